#include "ui/document/document.h"

#include <utility>

namespace vybeg::ui {

Document::Document(QObject* parent) : QObject(parent) {
    connectStores();
    connect(&recordings_, &RecordingStore::opened, this, &Document::whenOpened);
    connect(&recordings_, &RecordingStore::openFailed, this,
            [this](int id, const Message& message) {
                close(id);
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
    if (!recordings_.find(id)) {
        return;
    }
    const Closed before = whatCloses(id);
    Closed after = before;
    after.options = options;
    after.runs.reset();
    const auto become = [this](const Closed& wanted) {
        close(wanted.id);
        bringBack(wanted);
    };
    steps_.add([name = recordings_.find(id)->name] { return tr("import of %1").arg(name); },
               [become, before] { become(before); }, [become, after] { become(after); });
    become(after);
}

int Document::restore(const QString& path, const OpenOptions& options, std::vector<RunWish> runs) {
    recordings_.open({path}, options);
    const int id = recordings_.all().back().id;
    restored_[id] = std::move(runs);
    return id;
}

void Document::restoreRuns(int id, const std::vector<RunWish>& runs) {
    for (const RunWish& run : runs) {
        runs_.expect(id, run);
        if (run.live) {
            live_.follow(id, run.settings);
        } else {
            ask({.recording_id = id, .settings = run.settings, .restored = true});
        }
    }
}

Document::Closed Document::whatCloses(int id) {
    runs_.keepPlaces();
    const RecordingEntry& entry = *recordings_.find(id);
    Closed closed{id, recordings_.place(id), entry.path, entry.options, {}, sets_.holding(id)};
    closed.runs.emplace();
    for (std::size_t place = 0; place < runs().size(); ++place) {
        if (runs()[place].recording_id == id) {
            closed.runs->push_back(wishOf(runs()[place], static_cast<int>(place)));
        }
    }
    return closed;
}

void Document::bringBack(const Closed& closed) {
    if (closed.runs) {
        restored_[closed.id] = *closed.runs;
    }
    recordings_.openAs(closed.id, closed.place, closed.path, closed.options);
    sets_.putInto(closed.sets, closed.id);
}

void Document::closeRecording(int id) {
    if (const RecordingEntry* entry = recordings_.find(id)) {
        steps_.add([name = entry->name] { return tr("close %1").arg(name); },
                   [this, closed = whatCloses(id)] { bringBack(closed); },
                   [this, id] { close(id); });
        close(id);
    }
}

void Document::close(int id) {
    restored_.erase(id);
    for (const int key : queue_.keysOfRecording(id)) {
        queue_.forget(key);
    }
    sets_.removeFromAll(id);
    runs_.removeOf(id);
    recordings_.close(id);
}

void Document::whenOpened(int id) {
    emit opened(recordings_.find(id)->path);
    if (const auto restored = restored_.extract(id)) {
        recordings_.searchCarrier(id);
        restoreRuns(id, restored.mapped());
    } else if (live()) {
        live_.follow(id);  // finds the carrier, too
    } else {
        recordings_.searchCarrier(id);
        ask({.recording_id = id, .settings = settings()});
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
        ask({.recording_id = entry->id, .settings = settings()});
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
    ask({.recording_id = recording_id, .settings = requested});
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
        ask({.recording_id = id, .settings = compared, .batch = batch});
    }
}

void Document::ask(const Request& request) {
    if (request.batch == 0 && !request.restored) {
        // A new run of a recording replaces one that is still computing.
        queue_.replace(queue_.keyOfRun(request.recording_id));
    }
    const int key = ids_.next();
    queue_.enter(key, request);
    const RecordingEntry& entry = *recording(request.recording_id);
    job_.analyse(
        key, *entry.recording, RecordingStore::withKnownCarrier(entry, request.settings),
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
