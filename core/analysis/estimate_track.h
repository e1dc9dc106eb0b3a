#pragma once

#include "core/analysis/prepare.h"
#include "core/analysis/settings.h"
#include "core/track/track.h"
#include "core/windows/window_plan.h"

namespace vybeg {

struct EstimatedTrack {
    Track track;
    std::int64_t context = 0;  // samples that the algorithm needs on both sides of a window
    double read_s = 0;
    double estimate_s = 0;
};

// Runs the estimator over all windows of the plan, chunk by chunk, so that memory does not grow
// with the samples; the windows of a chunk are spread over `threads` threads. The angles are as
// estimated, window by window. Errors: those of the source, interrupted.
Result<EstimatedTrack> estimate_track(const Prepared& prepared, const WindowPlan& plan,
                                      const Settings& settings, double rate_hz, int threads,
                                      const JobControl& job);

}  // namespace vybeg
