#include "ui/document/run_store.h"

#include "ui/widgets/theme.h"
#include "ui/words/program_name.h"

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

RunWish wishOf(const RunEntry& entry, int place) {
    return {.settings = entry.requested,
            .name = entry.run.name,
            .color = entry.run.color,
            .dash = entry.run.dash,
            .visible = entry.run.visible,
            .live = entry.live,
            .place = place};
}

RunStore::RunStore(BackgroundJobs& job, const RecordingStore& recordings, IdCounter& ids,
                   UndoSteps& steps, QObject* parent)
    : QObject(parent), job_(job), recordings_(recordings), ids_(ids), steps_(steps) {}

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
    const auto same = std::ranges::find_if(runs_, [&](const RunEntry& other) {
        return !other.live && other.recording_id == recording_id && other.requested == requested;
    });
    RunEntry* shown = nullptr;
    if (same != runs_.end()) {
        shown = &*same;
        shown->run.visible = true;
    } else if (shown = addExpected(recording_id, requested, false); !shown) {
        shown = &add(newRun(recording,
                            QStringLiteral("%1, n = %2")
                                .arg(QFileInfo(recording.path).completeBaseName())
                                .arg(outcome.analysis->plan.length),
                            styleWish(recording_id)));
    }
    setOutcome(*shown, requested, std::move(outcome));
    const int id = shown->run.id;
    emit changed();
    emit added(id);
    return id;
}

int RunStore::showLive(int recording_id, const Settings& requested, AnalysisOutcome outcome) {
    auto live = std::ranges::find_if(runs_, [&](const RunEntry& entry) {
        return entry.live && entry.recording_id == recording_id;
    });
    const bool is_new = live == runs_.end();
    RunEntry* expected = is_new ? addExpected(recording_id, requested, true) : nullptr;
    RunEntry& entry = expected ? *expected : is_new ? addLive(recording_id) : *live;
    setOutcome(entry, requested, std::move(outcome));
    const int id = entry.run.id;
    emit changed();
    if (is_new) {
        emit added(id);
    }
    return id;
}

// The first run of a recording has the colour of the recording's place.
int RunStore::styleWish(int recording_id) const {
    const bool first =
        std::ranges::find(runs_, recording_id, &RunEntry::recording_id) == runs_.end();
    return first ? static_cast<int>(recordings_.place(recording_id)) : 0;
}

// The first run of each recording stands in the order of the recordings, whichever analysis ends
// first; later ones at the end.
RunEntry& RunStore::add(RunEntry entry) {
    const auto is_first = [this](auto run) {
        return std::ranges::find(runs_.begin(), run, run->recording_id, &RunEntry::recording_id) ==
               run;
    };
    auto next = runs_.end();
    if (std::ranges::find(runs_, entry.recording_id, &RunEntry::recording_id) == runs_.end()) {
        const std::size_t own = recordings_.place(entry.recording_id);
        for (next = runs_.begin(); next != runs_.end(); ++next) {
            if (is_first(next) && recordings_.place(next->recording_id) > own) {
                break;
            }
        }
    }
    return *runs_.insert(next, std::move(entry));
}

RunEntry& RunStore::addLive(int recording_id) {
    const RecordingEntry& recording = *recordings_.find(recording_id);
    // Its settings change, so they are in its row and not in its name.
    RunEntry added = newRun(recording, QFileInfo(recording.path).completeBaseName(),
                            static_cast<int>(recordings_.place(recording_id)));
    added.live = true;
    return add(std::move(added));
}

void RunStore::expect(int recording_id, const RunWish& wish) {
    expected_.emplace(recording_id, wish);
}

RunEntry* RunStore::addExpected(int recording_id, const Settings& requested, bool live) {
    const auto [first, last] = expected_.equal_range(recording_id);
    const auto wish = std::find_if(first, last, [&](const auto& expected) {
        return expected.second.live == live && expected.second.settings == requested;
    });
    if (wish == last) {
        return nullptr;
    }
    const RunWish& wanted = wish->second;
    RunEntry entry = newRun(*recordings_.find(recording_id), wanted.name);
    entry.run.color = wanted.color;
    entry.run.dash = wanted.dash;
    entry.run.visible = wanted.visible;
    entry.live = live;
    entry.place = wanted.place;
    const auto next = std::ranges::upper_bound(runs_, entry.place, {}, &RunEntry::place);
    expected_.erase(wish);
    return &*runs_.insert(next, std::move(entry));
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

void RunStore::change(int id, const std::function<void(Run&)>& edit) {
    for (RunEntry& entry : runs_) {
        if (entry.run.id == id) {
            edit(entry.run);
            emit changed();
        }
    }
}

void RunStore::setVisible(int id, bool visible) {
    const RunEntry* entry = find(id);
    if (!entry || entry->run.visible == visible) {
        return;
    }
    const auto set = [this, id](bool shown) {
        change(id, [shown](Run& run) { run.visible = shown; });
    };
    steps_.add(
        [visible, name = entry->run.name] {
            return (visible ? tr("show %1") : tr("hide %1")).arg(name);
        },
        [set, visible] { set(!visible); }, [set, visible] { set(visible); });
    set(visible);
}

void RunStore::rename(int id, const QString& name) {
    const RunEntry* entry = find(id);
    const QString wanted = name.trimmed();
    if (!entry || wanted.isEmpty() || entry->run.name == wanted) {
        return;
    }
    const QString before = entry->run.name;
    const auto set = [this, id](const QString& text) {
        change(id, [text](Run& run) { run.name = text; });
    };
    steps_.add([before] { return tr("rename %1").arg(before); }, [set, before] { set(before); },
               [set, wanted] { set(wanted); });
    set(wanted);
}

void RunStore::remove(int id) {
    const RunEntry* found = find(id);
    if (!found) {
        return;
    }
    const auto place = static_cast<std::size_t>(found - runs_.data());
    steps_.add([name = found->run.name] { return tr("remove %1").arg(name); },
               [this, entry = *found, place] { putBack(entry, place); },
               [this, id] { takeOut(id); });
    takeOut(id);
}

// A live run that has come meanwhile stays; the recording may be closed.
void RunStore::putBack(const RunEntry& entry, std::size_t place) {
    const bool replaced = entry.live && liveOf(entry.recording_id);
    if (recordings_.find(entry.recording_id) && !replaced) {
        runs_.insert(runs_.begin() + static_cast<std::ptrdiff_t>(std::min(place, runs_.size())),
                     entry);
        emit changed();
    }
}

void RunStore::takeOut(int id) {
    if (std::erase_if(runs_, [id](const RunEntry& entry) { return entry.run.id == id; }) > 0) {
        emit changed();
    }
}

void RunStore::keepPlaces() {
    for (std::size_t place = 0; place < runs_.size(); ++place) {
        runs_[place].place = static_cast<int>(place);
    }
}

void RunStore::removeOf(int recording_id) {
    expected_.erase(recording_id);
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
                        programName(), path, std::move(done));
    }
}

}  // namespace vybeg::ui
