#pragma once

#include "core/analysis/prepare.h"
#include "core/analysis/settings.h"
#include "core/recording/checks/recording_check.h"
#include "core/track/track.h"
#include "core/track/track_summary.h"
#include "core/windows/window_plan.h"

#include <vector>

namespace vybeg {

struct EstimationSummary {
    std::int64_t context = 0;         // samples that the algorithm needs on both sides of a window
    std::int64_t not_converged = 0;   // windows
    std::vector<FlaggedRows> moving;  // rows that get Flag::moving: seen from their neighbours
    TrackSummary track;               // before those flags
    std::vector<double> f_correlation;  // of errors of f, by hops (TrackSummariser)
    double read_s = 0;
    double estimate_s = 0;  // summed over the threads, divided by their number
};

// Runs the estimator over all windows of the plan, chunk by chunk: while one chunk is estimated,
// its windows spread over `threads` threads, the next is read and the rows of the one before, their
// angles unwrapped, go to the sink. Memory does not grow with the samples. Errors: those of the
// source and of the sink; interrupted.
Result<EstimationSummary> estimate_track(const ConditionedRecording& prepared,
                                         const WindowPlan& plan, const Settings& settings,
                                         double rate_hz, int threads, const TrackSink& sink,
                                         const JobControl& job);

// Which windows of a plan lie over faults of the samples: Flag::clipped over segments at the rail,
// Flag::gap over segments of a constant value, with the frames to each side that a filter of this
// reach takes in, and where samples were lost or doubled inside. Ordered by first row; segments of
// one flag do not overlap.
std::vector<FlaggedRows> windows_over(const SampleFaults& faults, const WindowPlan& plan,
                                      std::int64_t filter_reach);

// The rows of `moving` that no window over a fault explains: all but those within two
// windows' lengths of `over_faults`, as far as motion is looked for.
std::vector<FlaggedRows> moving_apart(const std::vector<FlaggedRows>& moving,
                                      const std::vector<FlaggedRows>& over_faults,
                                      const WindowPlan& plan);

}  // namespace vybeg
