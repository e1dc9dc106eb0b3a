#include "ui/document/run_store.h"

#include "ui/widgets/theme.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace vybeg::ui {
namespace {

// A name that no run has: "demo", "demo (2)", ...
QString freeName(const std::vector<RunEntry>& runs, const QString& wish) {
    const auto taken = [&](const QString& name) {
        return std::ranges::any_of(runs,
                                   [&](const RunEntry& entry) { return entry.run.name == name; });
    };
    QString name = wish;
    for (int count = 2; taken(name); ++count) {
        name = QStringLiteral("%1 (%2)").arg(wish).arg(count);
    }
    return name;
}

// The style wished for, or the first that no run has.
int freeStyle(const std::vector<RunEntry>& runs, int wish) {
    const auto taken = [&](int candidate) {
        const RunStyle style = runStyle(candidate);
        return std::ranges::any_of(runs, [&](const RunEntry& entry) {
            return entry.run.color == style.color && entry.run.dash == style.dash;
        });
    };
    if (!taken(wish)) {
        return wish;
    }
    // Styles repeat after a while; with more runs than styles the first free index is as good.
    int index = 0;
    while (index < static_cast<int>(runs.size()) && taken(index)) {
        ++index;
    }
    return index;
}

void setOutcome(RunEntry& entry, const Settings& requested, AnalysisOutcome outcome) {
    entry.requested = requested;
    entry.summary = outcome.summary;
    entry.events = std::move(outcome.events);
    entry.run.seconds_taken = outcome.analysis->timing.estimate_s;
    entry.run.analysis = std::move(outcome.analysis);
    entry.run.curves = std::move(outcome.curves);
}

}  // namespace

RunStore::RunStore(AnalysisJob& job, const RecordingStore& recordings, IdCounter& ids,
                   QObject* parent)
    : QObject(parent), job_(job), recordings_(recordings), ids_(ids) {}

const RunEntry* RunStore::find(int id) const {
    const auto found =
        std::ranges::find_if(runs_, [id](const RunEntry& entry) { return entry.run.id == id; });
    return found == runs_.end() ? nullptr : &*found;
}

const RunEntry* RunStore::liveOf(int recording_id) const {
    const auto found = std::ranges::find_if(runs_, [recording_id](const RunEntry& entry) {
        return entry.live && entry.recording_id == recording_id;
    });
    return found == runs_.end() ? nullptr : &*found;
}

std::vector<Run> RunStore::plotted(bool live_on_top) const {
    std::vector<Run> plotted;
    plotted.reserve(runs_.size());
    for (const bool on_top : {false, true}) {
        for (const RunEntry& entry : runs_) {
            if ((entry.live && live_on_top) == on_top) {
                plotted.push_back(entry.run);
            }
        }
    }
    return plotted;
}

int RunStore::show(int recording_id, const Settings& requested, AnalysisOutcome outcome) {
    const RecordingEntry& recording = *recordings_.find(recording_id);
    auto same = std::ranges::find_if(runs_, [&](const RunEntry& other) {
        return !other.live && other.recording_id == recording_id && other.requested == requested;
    });
    if (same == runs_.end()) {
        runs_.push_back(newRun(recording, QStringLiteral("%1, n = %2")
                                              .arg(QFileInfo(recording.path).completeBaseName())
                                              .arg(outcome.analysis->plan.length)));
        same = runs_.end() - 1;
    }
    same->run.visible = true;
    setOutcome(*same, requested, std::move(outcome));
    const int id = same->run.id;
    emit changed();
    emit added(id);
    return id;
}

int RunStore::showLive(int recording_id, const Settings& requested, AnalysisOutcome outcome) {
    auto live = std::ranges::find_if(runs_, [&](const RunEntry& entry) {
        return entry.live && entry.recording_id == recording_id;
    });
    const bool is_new = live == runs_.end();
    RunEntry& entry = is_new ? addLive(recording_id) : *live;
    setOutcome(entry, requested, std::move(outcome));
    const int id = entry.run.id;
    emit changed();
    if (is_new) {
        emit added(id);
    }
    return id;
}

// In the order and with the colour of its recording, whichever analysis ends first.
RunEntry& RunStore::addLive(int recording_id) {
    const std::size_t own = recordings_.place(recording_id);
    const RecordingEntry& recording = *recordings_.find(recording_id);
    // Its settings change, so they are in its row and not in its name.
    RunEntry added =
        newRun(recording, QFileInfo(recording.path).completeBaseName(), static_cast<int>(own));
    added.live = true;
    const auto next = std::ranges::find_if(runs_, [&](const RunEntry& other) {
        return other.live && recordings_.place(other.recording_id) > own;
    });
    return *runs_.insert(next, std::move(added));
}

RunEntry RunStore::newRun(const RecordingEntry& recording, const QString& name, int wish) {
    const RunStyle style = runStyle(freeStyle(runs_, wish));
    RunEntry entry;
    entry.recording_id = recording.id;
    entry.run.id = ids_.next();
    entry.run.name = freeName(runs_, name);
    entry.run.recording = recording.name;
    entry.run.color = style.color;
    entry.run.dash = style.dash;
    entry.run.rate_hz = recording.recording->rate_hz;
    return entry;
}

void RunStore::setVisible(int id, bool visible) {
    for (RunEntry& entry : runs_) {
        if (entry.run.id == id && entry.run.visible != visible) {
            entry.run.visible = visible;
            emit changed();
        }
    }
}

void RunStore::rename(int id, const QString& name) {
    for (RunEntry& entry : runs_) {
        if (entry.run.id == id && entry.run.name != name && !name.trimmed().isEmpty()) {
            entry.run.name = name.trimmed();
            emit changed();
        }
    }
}

void RunStore::remove(int id) {
    if (std::erase_if(runs_, [id](const RunEntry& entry) { return entry.run.id == id; }) > 0) {
        emit changed();
    }
}

void RunStore::removeOf(int recording_id) {
    const auto gone = std::erase_if(runs_, [recording_id](const RunEntry& entry) {
        return entry.recording_id == recording_id;
    });
    if (gone > 0) {
        emit changed();
    }
}

void RunStore::exportTrack(int id, const QString& path, std::function<void(const Status&)> done) {
    const RunEntry* entry = find(id);
    if (entry && !entry->partial()) {
        job_.writeTrack(id, *recordings_.find(entry->recording_id)->recording, entry->run.analysis,
                        QStringLiteral("vybeg ") + QCoreApplication::applicationVersion(), path,
                        std::move(done));
    }
}

}  // namespace vybeg::ui
