#pragma once

#include "core/analysis/settings.h"
#include "core/base/diagnostic.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/checks/recording_check.h"
#include "core/recording/samples/recording.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// Only the carrier f0 of the recording (Hz), with the settings' band, filter, calibration and
// range: what the interface shows before the first run.
Result<double> find_recording_carrier(const Recording& recording, const SignalSettings& settings,
                                      const JobControl& job);

// A recording made ready for windows: what the samples are, where they lie, and what the carrier
// is.
struct ConditionedRecording {
    std::shared_ptr<const SampleSource> source;  // calibrated and filtered
    std::shared_ptr<const SampleSource> ahead;   // the same samples, unseen by `check`
    std::int64_t first = 0;                      // the range to analyse: frames [first, end)
    std::int64_t end = 0;
    double f0_hz = 0;
    std::optional<Band> filter;
    double rate_relative_sd = 0;          // of the recording
    std::int64_t filter_reach = 0;        // frames to each side of which the band-pass takes in
    std::optional<double> noise_in_band;  // sd per sample, after a band-pass (window_noise.h)
    Calibration calibration;              // with the offsets that were found
    std::shared_ptr<FaultCheck> check;    // sees the samples of `source` as they are read
    std::vector<Diagnostic> diagnostics;
    double carrier_s = 0;  // seconds that the search for the carrier took, reading included

    // The same for windows that are estimated out of order, of which the check must not know.
    ConditionedRecording past_check() const {
        ConditionedRecording other = *this;
        other.source = ahead;
        return other;
    }
};

// Lost samples, calibration, band-pass, range and carrier. Precondition: validate(settings). Errors
// as of analyse().
Result<ConditionedRecording> prepare(const Recording& recording, const SignalSettings& settings,
                                     const JobControl& job);

// How a recording is called in messages.
std::string recording_name(const Recording& recording);

// The error, which is about the recording where it names nothing.
Error about(const Recording& recording, Error error);

}  // namespace vybeg
