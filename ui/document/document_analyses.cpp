// The part of the document that asks for analyses and takes their runs in.
#include "ui/document/document.h"
#include "ui/widgets/theme.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

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

}  // namespace

void Document::analyse() {
    if (const RecordingEntry* entry = currentRecording(); entry && entry->recording) {
        ask(entry->id, settings_, 0);
    }
}

void Document::rerun(int run_id) {
    if (const RunEntry* entry = run(run_id)) {
        runAgain(entry->recording_id, entry->requested);
    }
}

void Document::rerunSnapped(int run_id) {
    if (const RunEntry* entry = run(run_id)) {
        Settings snapped = entry->requested;
        snapped.snap = true;
        runAgain(entry->recording_id, snapped);
    }
}

void Document::runAgain(int recording_id, const Settings& requested) {
    setCurrentRecording(recording_id);
    setSettings(requested);
    ask(recording_id, requested, 0);
}

void Document::compareWindows(const std::vector<std::int64_t>& lengths) {
    const RecordingEntry* entry = currentRecording();
    if (!entry || !entry->recording || lengths.empty()) {
        return;
    }
    const int id = entry->id;
    const int batch = ++last_id_;
    batches_[batch] = {};
    for (const std::int64_t length : lengths) {
        Settings settings = settings_;
        settings.window = length;
        settings.periods.reset();
        settings.snap = false;
        settings.hop = 0;
        ask(id, settings, batch);
    }
}

void Document::ask(int recording_id, const Settings& settings, int batch) {
    if (batch == 0) {
        // A new run of a recording takes the place of one that is still computing.
        const auto older = std::ranges::find_if(requests_, [&](const auto& request) {
            const Request& other = request.second;
            return other.recording_id == recording_id && other.batch == 0 && !other.live;
        });
        if (older != requests_.end()) {
            job_.forget(older->first);
            requests_.erase(older);
            --requests_asked_;
        }
    }
    const int key = ++last_id_;
    enter(key, {recording_id, settings, batch, false});
    const RecordingEntry& entry = *recording(recording_id);
    job_.analyse(
        key, *entry.recording, withKnownCarrier(entry, settings),
        [this, key](Result<AnalysisOutcome> result) { whenAnalysed(key, std::move(result)); });
    emit busyChanged();
}

void Document::enter(int key, const Request& request) {
    if (!busy()) {
        requests_asked_ = 0;
        fraction_ = 0;
        busy_since_.start();
    }
    requests_asked_ += requests_.contains(key) ? 0 : 1;
    requests_[key] = request;
}

void Document::whenAnalysed(int key, Result<AnalysisOutcome> result) {
    const auto found = requests_.find(key);
    if (found == requests_.end()) {
        return;
    }
    const Request request = found->second;
    if (result) {
        const double seconds = result->analysis->timing.estimate_s;
        learnCarrier(request.recording_id, request.settings, result->analysis->settings);
        const int id = addRun(request, std::move(*result));
        if (request.batch != 0) {
            batches_[request.batch].push_back(id);
        }
        emit finished(id, seconds);
    } else if (result.error().code != ErrorCode::interrupted) {
        reportError(result.error());
    }
    requestDone(key);
}

void Document::requestDone(int key) {
    const int batch = requests_[key].batch;
    requests_.erase(key);
    fraction_ = 0;
    const bool batch_done =
        batch != 0 && std::ranges::none_of(requests_, [batch](const auto& request) {
            return request.second.batch == batch;
        });
    if (batch_done) {
        const QList<int> ids = batches_[batch];
        batches_.erase(batch);
        if (!ids.isEmpty()) {
            emit comparisonReady(ids);
        }
    }
    emit busyChanged();
}

int Document::addRun(const Request& request, AnalysisOutcome outcome) {
    const RecordingEntry& entry = *recording(request.recording_id);
    const auto same = std::ranges::find_if(runs_, [&](const RunEntry& other) {
        return !other.live && other.recording_id == entry.id && other.requested == request.settings;
    });
    const bool again = same != runs_.end();
    if (!again) {
        runs_.push_back(newRun(entry, QStringLiteral("%1, n = %2")
                                          .arg(QFileInfo(entry.path).completeBaseName())
                                          .arg(outcome.analysis->plan.length)));
    }
    RunEntry& run = again ? *same : runs_.back();
    run.run.visible = true;
    showOutcome(run, request.settings, std::move(outcome));
    const int id = run.run.id;
    emit runsChanged();
    emit runAdded(id);
    return id;
}

RunEntry Document::newRun(const RecordingEntry& recording, const QString& name, int wish) {
    const RunStyle style = runStyle(freeStyle(runs_, wish));
    RunEntry entry;
    entry.recording_id = recording.id;
    entry.run.id = ++last_id_;
    entry.run.name = freeName(runs_, name);
    entry.run.recording = recording.name;
    entry.run.color = style.color;
    entry.run.dash = style.dash;
    entry.run.rate_hz = recording.recording->rate_hz;
    return entry;
}

void Document::showOutcome(RunEntry& entry, const Settings& requested, AnalysisOutcome outcome) {
    entry.requested = requested;
    entry.summary = outcome.summary;
    entry.events = std::move(outcome.events);
    entry.run.seconds_taken = outcome.analysis->timing.estimate_s;
    entry.run.analysis = std::move(outcome.analysis);
    entry.run.curves = std::move(outcome.curves);
}

void Document::cancel() {
    batches_.clear();  // half a comparison is not shown
    job_.cancelAnalyses();
}

double Document::progress() const {
    if (requests_.empty()) {
        return 1;
    }
    const double done = requests_asked_ - static_cast<double>(requests_.size());
    return std::clamp((done + fraction_) / requests_asked_, 0.0, 1.0);
}

std::optional<double> Document::secondsLeft() const {
    const double share = progress();
    const double elapsed = static_cast<double>(busy_since_.elapsed()) / 1000;
    // The first half second says too little about the rest.
    if (!busy() || elapsed < 0.5 || share < 0.01) {
        return std::nullopt;
    }
    return elapsed * (1 - share) / share;
}

std::vector<Run> Document::plottedRuns() const {
    std::vector<Run> plotted;
    plotted.reserve(runs_.size());
    for (const RunEntry& entry : runs_) {
        if (!(entry.live && live_)) {
            plotted.push_back(entry.run);
        }
    }
    for (const RunEntry& entry : runs_) {
        if (entry.live && live_) {
            plotted.push_back(entry.run);
        }
    }
    return plotted;
}

void Document::setRunVisible(int id, bool visible) {
    for (RunEntry& entry : runs_) {
        if (entry.run.id == id && entry.run.visible != visible) {
            entry.run.visible = visible;
            emit runsChanged();
        }
    }
}

void Document::renameRun(int id, const QString& name) {
    for (RunEntry& entry : runs_) {
        if (entry.run.id == id && entry.run.name != name && !name.trimmed().isEmpty()) {
            entry.run.name = name.trimmed();
            emit runsChanged();
        }
    }
}

void Document::removeRun(int id) {
    if (const RunEntry* entry = run(id); entry && entry->live) {
        forgetLive(entry->recording_id);  // it would come back
    }
    if (std::erase_if(runs_, [id](const RunEntry& entry) { return entry.run.id == id; }) > 0) {
        emit runsChanged();
    }
}

void Document::exportTrack(int id, const QString& path, std::function<void(const Status&)> done) {
    const RunEntry* entry = run(id);
    if (entry && !entry->partial()) {
        job_.writeTrack(id, *recording(entry->recording_id)->recording, entry->run.analysis,
                        QStringLiteral("vybeg ") + QCoreApplication::applicationVersion(), path,
                        std::move(done));
    }
}

}  // namespace vybeg::ui
