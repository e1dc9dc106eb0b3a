#include "ui/document/live_follower.h"

#include <algorithm>
#include <utility>

namespace vybeg::ui {

LiveFollower::LiveFollower(BackgroundJobs& job, const SettingsModel& settings,
                           RecordingStore& recordings, AnalysisStore& analyses, RequestQueue& queue)
    : job_(job), settings_(settings), recordings_(recordings), analyses_(analyses), queue_(queue) {}

void LiveFollower::setOn(bool on) {
    if (on == on_) {
        return;
    }
    on_ = on;
    emit onChanged();
    if (const RecordingEntry* current = recordings_.current()) {
        catchUp(current->id);
    }
}

void LiveFollower::catchUp(RecordingId recording_id) {
    const bool shown = std::ranges::any_of(analyses_.all(), [&](const AnalysisEntry& entry) {
        return entry.recording_id == recording_id && entry.requested == settings_.settings() &&
               !entry.partial();
    });
    if (on_ && !shown) {
        follow(recording_id);
    }
}

void LiveFollower::follow(RecordingId recording_id, const Settings& wanted) {
    const RecordingEntry* entry = recordings_.find(recording_id);
    if (!entry || !entry->recording) {
        return;
    }
    // The key of a live request is its recording: the newer one stops the one before.
    const Request* asked = queue_.find(number(recording_id));
    if (asked && asked->settings == wanted) {
        return;
    }
    queue_.enter(number(recording_id),
                 {.recording_id = recording_id, .settings = wanted, .live = true});
    job_.analyseLive(
        number(recording_id), *entry->recording, RecordingStore::withKnownCarrier(*entry, wanted),
        visible_,
        [this, recording_id, wanted](AnalysisOutcome outcome) {
            show(recording_id, wanted, std::move(outcome));
        },
        [this, recording_id](Result<AnalysisOutcome> result) {
            whenDone(recording_id, std::move(result));
        });
}

AnalysisId LiveFollower::show(RecordingId recording_id, const Settings& requested,
                              AnalysisOutcome outcome) {
    recordings_.learnCarrier(recording_id, requested, outcome.analysis->settings);
    emit settled(Topic::live);
    return analyses_.showLive(recording_id, requested, std::move(outcome));
}

void LiveFollower::whenDone(RecordingId recording_id, Result<AnalysisOutcome> result) {
    const Settings requested = queue_.find(number(recording_id))->settings;
    if (result) {
        const double seconds = result->analysis->timing.estimate_s;
        emit finished(show(recording_id, requested, std::move(*result)), seconds);
    } else if (result.error().code != ErrorCode::interrupted) {
        emit reported(errorMessage(result.error(), Topic::live));
        const RecordingEntry& entry = *recordings_.find(recording_id);
        if (!requested.f0_hz &&
            !(entry.f0_search && same_carrier_search(*entry.f0_search, requested))) {
            recordings_.searchCarrier(recording_id);  // the fields of the window show it
        }
    }
    queue_.done(number(recording_id));
}

}  // namespace vybeg::ui
