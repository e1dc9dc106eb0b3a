#pragma once

#include "core/analysis/settings.h"
#include "core/base/job_control.h"
#include "core/recording/recording.h"
#include "core/track/track.h"
#include "core/windows/window_plan.h"

#include <vector>

namespace vybeg {

// Seconds spent, by monotonic clock of the caller's machine (the --timing line).
struct Timing {
    double read_s = 0;      // reading, calibration and filter
    double carrier_s = 0;   // search for the carrier
    double estimate_s = 0;  // the estimators alone
    int threads = 0;
};

struct Analysis {
    Track track;
    Settings settings;  // as used: window, hop and f0_hz filled in, offsets resolved
    WindowPlan plan;
    double residual = 0;                  // <cos 2wt> of the window (METHOD section 3)
    std::vector<Diagnostic> diagnostics;  // of the recording and of the analysis
    Timing timing;

    double f0_hz() const { return *settings.f0_hz; }
};

// The whole road from a recording to its track. Errors: setting_invalid, the analysis group, and
// the input group where reading fails on the way; interrupted. The result is the same to the last
// bit for any number of threads.
Result<Analysis> analyse(const Recording& recording, const Settings& settings,
                         const JobControl& job);

// Only the carrier f0 of the recording (Hz), with the settings' band, filter, calibration and
// range: what the interface shows before the first run.
Result<double> find_recording_carrier(const Recording& recording, const Settings& settings,
                                      const JobControl& job);

}  // namespace vybeg
