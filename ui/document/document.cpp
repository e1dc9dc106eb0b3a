#include "ui/document/document.h"

#include <utility>

namespace vybeg::ui {

Document::Document(QObject* parent) : QObject(parent) {
    connectStores();
    connect(&recordings_, &RecordingStore::opened, this, &Document::whenOpened);
    connect(&recordings_, &RecordingStore::openFailed, this,
            [this](int id, const Message& message) {
                closeRecording(id);
                emit reported(message);
            });
    connect(&recordings_, &RecordingStore::currentChanged, this, [this] {
        emit currentRecordingChanged();
        if (const RecordingEntry* current = recordings_.current()) {
            live_.catchUp(current->id);
        }
    });
    connect(&settings_, &SettingsModel::settingsChanged, this, &Document::whenSettingsChanged);
}

// Their signals that are the document's own.
void Document::connectStores() {
    connect(&recordings_, &RecordingStore::listChanged, this, &Document::recordingsChanged);
    connect(&recordings_, &RecordingStore::changed, this, &Document::recordingChanged);
    connect(&recordings_, &RecordingStore::envelopeGrown, this, &Document::envelopeGrown);
    connect(&recordings_, &RecordingStore::carrierChanged, this, &Document::carrierChanged);
    connect(&recordings_, &RecordingStore::reported, this, &Document::reported);
    connect(&settings_, &SettingsModel::toleranceChanged, this, &Document::settingsChanged);
    connect(&runs_, &RunStore::changed, this, &Document::runsChanged);
    connect(&runs_, &RunStore::added, this, &Document::runAdded);
    connect(&queue_, &RequestQueue::busyChanged, this, &Document::busyChanged);
    connect(&queue_, &RequestQueue::progressChanged, this, &Document::progressChanged);
    connect(&queue_, &RequestQueue::batchDone, this, &Document::comparisonReady);
    connect(&live_, &LiveFollower::onChanged, this, &Document::liveChanged);
    connect(&live_, &LiveFollower::finished, this, &Document::finished);
    connect(&live_, &LiveFollower::reported, this, &Document::reported);
    connect(&live_, &LiveFollower::settled, this, &Document::settled);
    connect(&sets_, &SetStore::reported, this, &Document::reported);
}

void Document::open(const QStringList& paths, const OpenOptions& options) {
    recordings_.open(paths, options);
}

void Document::reopen(int id, const OpenOptions& options) {
    const RecordingEntry* entry = recordings_.find(id);
    if (!entry) {
        return;
    }
    const QString path = entry->path;
    const std::vector<int> holders = sets_.holding(id);
    closeRecording(id);
    recordings_.open({path}, options);
    for (const int set : holders) {
        sets_.addTo(set, {recordings_.all().back().id});
    }
}

void Document::closeRecording(int id) {
    for (const int key : queue_.keysOfRecording(id)) {
        queue_.forget(key);
    }
    sets_.removeFromAll(id);
    runs_.removeOf(id);
    recordings_.close(id);
}

void Document::whenOpened(int id) {
    emit opened(recordings_.find(id)->path);
    if (live()) {
        live_.follow(id);  // finds the carrier, too
    } else {
        recordings_.searchCarrier(id);
        ask(id, settings(), 0);
    }
}

void Document::setSettings(const Settings& settings, int gesture) {
    settings_.setSettings(settings, gesture);
}

void Document::whenSettingsChanged(const Settings& before) {
    emit settingsChanged();
    const RecordingEntry* current = recordings_.current();
    if (!same_carrier_search(before, settings()) || before.f0_hz != settings().f0_hz) {
        for (const RecordingEntry& entry : recordings_.all()) {
            const bool found_by_live_run = live() && &entry == current;
            if (entry.recording && !settings().f0_hz && !found_by_live_run) {
                recordings_.searchCarrier(entry.id);
            }
        }
        emit carrierChanged();
    }
    if (live() && current) {
        live_.follow(current->id);
    }
}

void Document::analyse() {
    if (const RecordingEntry* entry = currentRecording(); entry && entry->recording) {
        ask(entry->id, settings(), 0);
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
    const int batch = ids_.next();
    queue_.beginBatch(batch);
    for (const std::int64_t length : lengths) {
        Settings compared = settings();
        compared.window = length;
        compared.periods.reset();
        compared.snap = false;
        compared.hop = 0;
        ask(id, compared, batch);
    }
}

void Document::ask(int recording_id, const Settings& settings, int batch) {
    if (batch == 0) {
        // A new run of a recording replaces one that is still computing.
        queue_.replace(queue_.keyOfRun(recording_id));
    }
    const int key = ids_.next();
    queue_.enter(key, {.recording_id = recording_id, .settings = settings, .batch = batch});
    const RecordingEntry& entry = *recording(recording_id);
    job_.analyse(
        key, *entry.recording, RecordingStore::withKnownCarrier(entry, settings),
        [this, key](Result<AnalysisOutcome> result) { whenAnalysed(key, std::move(result)); });
}

void Document::whenAnalysed(int key, Result<AnalysisOutcome> result) {
    const Request request = *queue_.find(key);
    if (result) {
        const double seconds = result->analysis->timing.estimate_s;
        recordings_.learnCarrier(request.recording_id, request.settings,
                                 result->analysis->settings);
        const int run_id = runs_.show(request.recording_id, request.settings, std::move(*result));
        if (request.batch != 0) {
            queue_.addToBatch(request.batch, run_id);
        }
        emit finished(run_id, seconds);
    } else if (result.error().code != ErrorCode::interrupted) {
        emit reported(errorMessage(result.error()));
    }
    queue_.done(key);
}

void Document::cancel() {
    queue_.forgetBatches();  // half a comparison is not shown
    job_.cancelAnalyses();
}

void Document::removeRun(int id) {
    if (const RunEntry* entry = run(id); entry && entry->live) {
        // Its computation would bring it back.
        if (const Request* request = queue_.find(entry->recording_id); request && request->live) {
            queue_.forget(entry->recording_id);
        }
    }
    runs_.remove(id);
}

void Document::exportTrack(int id, const QString& path, std::function<void(const Status&)> done) {
    runs_.exportTrack(id, path, std::move(done));
}

}  // namespace vybeg::ui
