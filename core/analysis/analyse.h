#pragma once

#include "core/analysis/settings.h"
#include "core/base/job_control.h"
#include "core/recording/recording.h"
#include "core/track/flagged_rows.h"
#include "core/track/track_summary.h"
#include "core/windows/window_plan.h"

#include <vector>

namespace vybeg {

// Seconds spent, by monotonic clock of the caller's machine (the --timing line). Reading and
// estimating overlap.
struct Timing {
    double read_s = 0;      // reading, calibration and filter
    double carrier_s = 0;   // search for the carrier
    double estimate_s = 0;  // the estimators alone: the sum of their threads by the threads' number
    int threads = 0;
};

// An analysis without its track.
struct AnalysisSummary {
    Settings settings;  // as used: window, hop and f0_hz filled in, offsets resolved
    WindowPlan plan;
    double residual = 0;                  // <cos 2wt> of the window (METHOD section 3)
    std::vector<Diagnostic> diagnostics;  // of the recording and of the analysis
    std::vector<FlaggedRows> flagged;     // rows whose flag was known only after they were made
    TrackSummary means;                   // before `flagged`
    Timing timing;

    double f0_hz() const { return *settings.f0_hz; }
};

struct Analysis : AnalysisSummary {
    Track track;
};

// The whole road from a recording to its track, of which `sink` takes the rows while they are made:
// memory does not grow with the recording. The summary's `flagged` are left to the caller. Errors:
// those of the sink, setting_invalid, the analysis group, and the input group where reading fails
// on the way; interrupted. The result is the same to the last bit for any number of threads.
Result<AnalysisSummary> analyse(const Recording& recording, const Settings& settings,
                                const TrackSink& sink, const JobControl& job);

// The same with the whole track, flags set.
Result<Analysis> analyse(const Recording& recording, const Settings& settings,
                         const JobControl& job);

// Only the carrier f0 of the recording (Hz), with the settings' band, filter, calibration and
// range: what the interface shows before the first run.
Result<double> find_recording_carrier(const Recording& recording, const Settings& settings,
                                      const JobControl& job);

}  // namespace vybeg
