// The part of the document that lets a run follow the settings.
#include "ui/document/document.h"
#include "ui/words/error_text.h"

#include <QFileInfo>

#include <algorithm>

namespace vybeg::ui {

void Document::setLive(bool live) {
    if (live == live_) {
        return;
    }
    live_ = live;
    emit liveChanged();
    if (live_) {
        catchUp(current_);
    }
}

RunEntry* Document::liveRun(int recording_id) {
    const auto found = std::ranges::find_if(runs_, [recording_id](const RunEntry& entry) {
        return entry.live && entry.recording_id == recording_id;
    });
    return found == runs_.end() ? nullptr : &*found;
}

// A recording to which the engineer turns shows the settings of the panel; it may do so already.
void Document::catchUp(int recording_id) {
    const bool shown = std::ranges::any_of(runs_, [&](const RunEntry& entry) {
        return entry.recording_id == recording_id && entry.requested == settings_ &&
               !entry.partial();
    });
    if (live_ && !shown) {
        follow(recording_id);
    }
}

void Document::follow(int recording_id) {
    const RecordingEntry* entry = recording(recording_id);
    if (!entry || !entry->recording) {
        return;
    }
    // The key of a live request is its recording: the newer one stops the one before.
    const auto asked = requests_.find(recording_id);
    if (asked != requests_.end() && asked->second.settings == settings_) {
        return;
    }
    enter(recording_id, {recording_id, settings_, 0, true});
    fraction_ = 0;
    job_.analyseLive(
        recording_id, *entry->recording, withKnownCarrier(*entry, settings_), visible_,
        [this, recording_id, requested = settings_](AnalysisOutcome outcome) {
            showLive(recording_id, requested, std::move(outcome));
        },
        [this, recording_id](Result<AnalysisOutcome> result) {
            whenLive(recording_id, std::move(result));
        });
    emit busyChanged();
}

void Document::showLive(int recording_id, const Settings& requested, AnalysisOutcome outcome) {
    learnCarrier(recording_id, requested, outcome.analysis->settings);
    RunEntry* live = liveRun(recording_id);
    const bool is_new = !live;
    if (is_new) {
        live = &addLive(recording_id);
    }
    showOutcome(*live, requested, std::move(outcome));
    const int id = live->run.id;
    emit settled(Topic::live);
    emit runsChanged();
    if (is_new) {
        emit runAdded(id);
    }
}

// In the place and the colour of its recording, whichever analysis is done first.
RunEntry& Document::addLive(int recording_id) {
    const auto place = [this](int id) {
        return std::ranges::find(recordings_, id, &RecordingEntry::id) - recordings_.begin();
    };
    const auto own = place(recording_id);
    const RecordingEntry& entry = *recording(recording_id);
    // Its name says nothing of the settings, which change; its row does.
    RunEntry added = newRun(entry, QFileInfo(entry.path).completeBaseName(), static_cast<int>(own));
    added.live = true;
    const auto next = std::ranges::find_if(runs_, [&](const RunEntry& other) {
        return other.live && place(other.recording_id) > own;
    });
    return *runs_.insert(next, std::move(added));
}

void Document::whenLive(int recording_id, Result<AnalysisOutcome> result) {
    const Settings requested = requests_[recording_id].settings;
    if (result) {
        const double seconds = result->analysis->timing.estimate_s;
        showLive(recording_id, requested, std::move(*result));
        emit finished(liveRun(recording_id)->run.id, seconds);
    } else if (result.error().code != ErrorCode::interrupted) {
        emit reported({Severity::error,
                       [error = result.error()] { return errorText(error); },
                       {},
                       {},
                       Topic::live});
        const RecordingEntry& entry = *recording(recording_id);
        if (!requested.f0_hz &&
            !(entry.f0_search && same_carrier_search(*entry.f0_search, requested))) {
            searchCarrier(recording_id);  // the window's fields go on showing what it would be
        }
    }
    requestDone(recording_id);
}

void Document::forgetLive(int recording_id) {
    if (requests_.contains(recording_id)) {
        job_.forgetLive(recording_id);
        requestDone(recording_id);
    }
}

// The search is the same every time, and the longest part of a short recording's analysis.
Settings Document::withKnownCarrier(const RecordingEntry& entry, Settings settings) {
    // Lost samples are looked for with the carrier of the file itself, which is another one.
    const bool known = entry.f0_hz && entry.f0_search && !settings.repair_lost &&
                       same_carrier_search(*entry.f0_search, settings);
    if (known && !settings.f0_hz) {
        settings.f0_hz = entry.f0_hz;
        settings.calibration = entry.f0_calibration;
    }
    return settings;
}

void Document::learnCarrier(int recording_id, const Settings& requested, const Settings& used) {
    RecordingEntry* entry = find(recording_id);
    if (!entry || requested.f0_hz || !same_carrier_search(requested, settings_)) {
        return;
    }
    const bool differs = entry->f0_hz != used.f0_hz;
    entry->f0_hz = used.f0_hz;
    entry->f0_search = requested;
    entry->f0_calibration = used.calibration;
    if (used.calibration.offset_auto) {
        entry->f0_search.reset();  // the offsets have yet to be found, and from another carrier
    }
    if (differs) {
        emit recordingChanged(recording_id);
        if (recording_id == current_) {
            emit carrierChanged();
        }
    }
}

}  // namespace vybeg::ui
