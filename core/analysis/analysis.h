#pragma once

#include "core/analysis/settings.h"
#include "core/base/diagnostic.h"
#include "core/track/track.h"
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
    std::vector<double> f_correlation;    // of errors of f, by hops (TrackSummariser)
    Timing timing;

    double f0_hz() const { return *settings.f0_hz; }
};

struct Analysis : AnalysisSummary {
    Track track;
};

}  // namespace vybeg
