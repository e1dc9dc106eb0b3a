#include "ui/document/document.h"

#include "core/analysis/measurement_list.h"

#include <QFileInfo>

#include <algorithm>

namespace vybeg::ui {

Document::Document() {
    // Signals of the stores that are the document's own.
    connect(&recordings_, &RecordingStore::listChanged, this, &Document::recordingsChanged);
    connect(&recordings_, &RecordingStore::changed, this, &Document::recordingChanged);
    connect(&recordings_, &RecordingStore::envelopeGrown, this, &Document::envelopeGrown);
    connect(&recordings_, &RecordingStore::carrierChanged, this, &Document::carrierChanged);
    connect(&recordings_, &RecordingStore::reported, this, &Document::reported);
    connect(&recordings_, &RecordingStore::importWanted, this, &Document::importWanted);
    connect(&analyses_, &AnalysisStore::changed, this, &Document::analysesChanged);
    connect(&analyses_, &AnalysisStore::added, this, &Document::analysisAdded);
    connect(&queue_, &RequestQueue::busyChanged, this, &Document::busyChanged);
    connect(&queue_, &RequestQueue::progressChanged, this, &Document::progressChanged);
    connect(&sets_, &SetStore::reported, this, &Document::reported);
    connect(&drift_, &DriftStore::reported, this, &Document::reported);
    connect(&passport_, &PassportStore::reported, this, &Document::reported);
    connect(&drift_, &DriftStore::settled, this, &Document::settled);
    connect(&recordings_, &RecordingStore::opened, this, &Document::whenOpened);
    connect(&recordings_, &RecordingStore::openFailed, this,
            [this](RecordingId id, const Message& message) {
                close(id);
                emit reported(message);
            });
    connect(&recordings_, &RecordingStore::foundLog, this,
            [this](RecordingId id, const QString& path, bool whole_angle) {
                if (whole_angle) {
                    angle_logs_[recordings_.find(id)->together][id] = path;
                }
                close(id);
                if (!whole_angle) {
                    emit foundLog(path);
                }
            });
    connect(&recordings_, &RecordingStore::currentChanged, this, [this] {
        emit currentRecordingChanged();
        if (const RecordingEntry* current = recordings_.current()) {
            catchUp(current->id);
        }
    });
    connect(&settings_, &SettingsModel::changed, this, &Document::whenSettingsChanged);
}

void Document::reopen(RecordingId id, const OpenOptions& options) {
    if (!recordings_.find(id)) {
        return;
    }
    const ClosedRecording before = whatCloses(id);
    ClosedRecording after = before;
    after.options = options;
    after.analyses.reset();
    steps_.change([name = recordings_.find(id)->name] { return tr("import of %1").arg(name); },
                  before, after,
                  [this](const ClosedRecording& wanted) {
                      close(wanted.id);
                      bringBack(wanted);
                  });
}

RecordingId Document::restore(const ClosedRecording& recording) {
    recordings_.open({recording.path}, recording.options);
    const auto id = recordings_.all().back().id;
    restored_[id] = recording.analyses.value_or(std::vector<AnalysisEntry>());
    return id;
}

ClosedRecording Document::whatCloses(RecordingId id) {
    analyses_.keepPlaces();
    ClosedRecording closed = asClosed(*recordings_.find(id), analyses());
    closed.place = recordings_.place(id);
    closed.sets = sets_.holding(id);
    return closed;
}

void Document::bringBack(const ClosedRecording& closed) {
    if (closed.analyses) {
        restored_[closed.id] = *closed.analyses;
    }
    recordings_.openAs(closed.id, closed.place, closed.path, closed.options);
    sets_.putInto(closed.sets, closed.id);
}

void Document::closeRecording(RecordingId id) {
    if (const RecordingEntry* entry = recordings_.find(id)) {
        steps_.add([name = entry->name] { return tr("close %1").arg(name); },
                   [this, closed = whatCloses(id)] { bringBack(closed); },
                   [this, id] { close(id); });
        close(id);
    }
}

void Document::close(RecordingId id) {
    const RecordingEntry* closed = recordings_.find(id);
    const int together = closed ? closed->together : 0;
    restored_.erase(id);
    for (const int key : queue_.keysOfRecording(id)) {
        queue_.forget(key);
    }
    sets_.removeFromAll(id);
    analyses_.removeOf(id);
    recordings_.close(id);
    // Both make steps of undo, one of which may be what closes here.
    QMetaObject::invokeMethod(
        this,
        [this, together] {
            takeArrived();
            openAngleLogs(together);
        },
        Qt::QueuedConnection);
}

void Document::openAngleLogs(int together) {
    const auto opening = [together](const RecordingEntry& entry) {
        return entry.together == together && !entry.recording;
    };
    if (std::ranges::any_of(recordings(), opening)) {
        return;
    }
    if (const auto found = angle_logs_.extract(together)) {
        QStringList paths;
        for (const auto& [id, path] : found.mapped()) {
            paths << path;
        }
        drift_.open(paths);
    }
}

void Document::openIntoSet(const QStringList& paths) {
    Arriving arriving{sets_.current() ? sets_.current()->id : SetId::none, {}};
    const bool of_logs = sets_.current() && isOfLogs(*sets_.current());
    QStringList logs;
    for (const QString& path : paths) {
        if (is_measurement_list(path.toStdU16String())) {
            sets_.openList(path, {});
            continue;
        }
        if (of_logs) {
            logs << path;
            continue;
        }
        const RecordingEntry* open = recordings_.findPath(QFileInfo(path).absoluteFilePath());
        if (!open) {
            recordings_.open({path}, {});
            open = &recordings_.all().back();
        }
        if (std::ranges::find(arriving.ids, open->id) == arriving.ids.end()) {
            arriving.ids.push_back(open->id);
        }
    }
    if (!logs.isEmpty()) {
        askForLogs(arriving.into, logs);
    }
    arriving_.push_back(std::move(arriving));
    takeArrived();
}

void Document::takeArrived() {
    const auto opening = [this](RecordingId id) {
        const RecordingEntry* entry = recordings_.find(id);
        return entry && !entry->recording;
    };
    const auto waits = [&opening](const Arriving& each) {
        return std::ranges::any_of(each.ids, opening);
    };
    const auto arrived = std::stable_partition(arriving_.begin(), arriving_.end(), waits);
    const std::vector<Arriving> all(arrived, arriving_.end());
    arriving_.erase(arrived, arriving_.end());
    for (const Arriving& each : all) {
        std::vector<RecordingId> ids = each.ids;
        std::erase_if(ids, [this](RecordingId id) { return !recordings_.find(id); });
        const RecordingSet* into = sets_.find(each.into);
        if (ids.empty() || (!into && each.into != SetId::none)) {
            continue;  // no recording, or the set is gone
        }
        if (into && !isOfLogs(*into)) {
            sets_.addTo(into->id, ids);
        } else {
            sets_.addToCurrent(ids);
        }
    }
}

void Document::whenOpened(RecordingId id) {
    takeArrived();
    openAngleLogs(recordings_.find(id)->together);
    emit opened(recordings_.find(id)->path);
    if (const auto restored = restored_.extract(id)) {
        recordings_.searchCarrier(id);
        for (const AnalysisEntry& analysis : restored.mapped()) {
            analyses_.expect(id, analysis);
            if (analysis.live) {
                follow(id, analysis.requested);
            } else {
                ask({.recording_id = id, .settings = analysis.requested, .restored = true});
            }
        }
    } else if (live()) {
        follow(id, settings());  // finds the carrier, too
    } else {
        recordings_.searchCarrier(id);
        ask({.recording_id = id, .settings = settings()});
    }
}

void Document::whenSettingsChanged(const Settings& before) {
    emit settingsChanged();
    const RecordingEntry* current = recordings_.current();
    if (!same_carrier_search(before, settings()) || before.f0_hz != settings().f0_hz) {
        for (const RecordingEntry& entry : recordings_.all()) {
            const bool found_by_live_analysis = live() && &entry == current;
            if (entry.recording && !settings().f0_hz && !found_by_live_analysis) {
                recordings_.searchCarrier(entry.id);
            }
        }
        emit carrierChanged();
    }
    if (live() && current && before != settings()) {
        follow(current->id, settings());
    }
}

void Document::analyse() {
    if (const RecordingEntry* entry = currentRecording(); entry && entry->recording) {
        ask({.recording_id = entry->id, .settings = settings()});
    }
}

void Document::analyseAgain(AnalysisId analysis_id, bool snapped) {
    if (const AnalysisEntry* entry = analysis(analysis_id)) {
        Request request{.recording_id = entry->recording_id, .settings = entry->requested};
        request.settings.snap = request.settings.snap || snapped;
        setCurrentRecording(request.recording_id);
        setSettings(request.settings);
        ask(request);
    }
}

void Document::ask(const Request& request) {
    if (!request.restored) {
        // A new analysis of a recording replaces one that is still computing.
        queue_.replace(queue_.keyOfAnalysis(request.recording_id));
    }
    const int key = ids_.next();
    queue_.enter(key, request);
    const RecordingEntry& entry = *recording(request.recording_id);
    job_.analyse(
        key, *entry.recording, RecordingStore::withKnownCarrier(entry, request.settings),
        [this, key](Result<AnalysisOutcome> result) { whenAnalysed(key, std::move(result)); });
}

void Document::setLive(bool live) {
    if (live == live_) {
        return;
    }
    live_ = live;
    emit liveChanged();
    if (const RecordingEntry* current = recordings_.current()) {
        catchUp(current->id);
    }
}

void Document::catchUp(RecordingId recording_id) {
    const bool shown = std::ranges::any_of(analyses(), [&](const AnalysisEntry& entry) {
        return entry.recording_id == recording_id && entry.requested == settings() &&
               !entry.partial();
    });
    if (live_ && !shown) {
        follow(recording_id, settings());
    }
}

void Document::follow(RecordingId recording_id, const Settings& wanted) {
    const RecordingEntry* entry = recordings_.find(recording_id);
    if (!entry || !entry->recording) {
        return;
    }
    // The key of a live request is its recording: the newer one stops the one before.
    const int key = number(recording_id);
    const Request* asked = queue_.find(key);
    if (asked && asked->settings == wanted) {
        return;
    }
    const Request request{.recording_id = recording_id, .settings = wanted, .live = true};
    queue_.enter(key, request);
    job_.analyseLive(
        key, *entry->recording, RecordingStore::withKnownCarrier(*entry, wanted), visible_,
        [this, request](AnalysisOutcome outcome) { show(request, std::move(outcome)); },
        [this, key](Result<AnalysisOutcome> result) { whenAnalysed(key, std::move(result)); });
}

AnalysisId Document::show(const Request& request, AnalysisOutcome outcome) {
    recordings_.learnCarrier(request.recording_id, request.settings, outcome.analysis->settings);
    if (request.live) {
        emit settled(Topic::live);
    }
    return analyses_.show(request.recording_id, request.settings, std::move(outcome), request.live);
}

void Document::whenAnalysed(int key, Result<AnalysisOutcome> result) {
    const Request request = *queue_.find(key);
    if (result) {
        const double seconds = result->analysis->timing.estimate_s;
        emit finished(show(request, std::move(*result)), seconds);
    } else if (result.error().code != ErrorCode::interrupted) {
        emit reported(errorMessage(result.error(), request.live ? Topic::live : Topic::none));
        const RecordingEntry& entry = *recordings_.find(request.recording_id);
        const bool searched =
            entry.f0_search && same_carrier_search(*entry.f0_search, request.settings);
        if (request.live && !request.settings.f0_hz && !searched) {
            recordings_.searchCarrier(request.recording_id);  // the fields of the window show it
        }
    }
    queue_.done(key);
}

void Document::removeAnalysis(AnalysisId id) {
    if (const AnalysisEntry* entry = analysis(id); entry && entry->live) {
        // Its computation would bring it back.
        if (const Request* request = queue_.find(number(entry->recording_id));
            request && request->live) {
            queue_.forget(number(entry->recording_id));
        }
    }
    analyses_.remove(id);
}

}  // namespace vybeg::ui

#include "moc_document.cpp"
