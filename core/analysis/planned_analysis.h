#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/prepare.h"
#include "core/analysis/settings.h"
#include "core/track/track.h"
#include "core/windows/window_plan.h"

namespace vybeg {

// analyse() in two halves, for those who show some windows before all of them are estimated.

// A recording made ready, and where its windows lie.
struct Planned : Prepared {
    WindowPlan plan;
};

// From the recording to its windows. Errors: setting_invalid, and those of prepare();
// window_too_short, window_too_long.
Result<Planned> plan_analysis(const Recording& recording, const Settings& settings,
                              const JobControl& job);

// What is known of an analysis before a window is estimated: settings as used, plan, residual, and
// what the recording tells of itself.
AnalysisSummary summary_before(const Settings& settings, const Planned& planned, double rate_hz);

// From the windows to their rows. `planned` is used up: its check has seen the samples then.
// Errors: those of the source and of the sink; interrupted.
Result<AnalysisSummary> analyse_planned(const Recording& recording, const Settings& settings,
                                        const Planned& planned, const TrackSink& sink,
                                        const JobControl& job);

// The same with the whole track, flags set.
Result<Analysis> analyse_planned(const Recording& recording, const Settings& settings,
                                 const Planned& planned, const JobControl& job);

}  // namespace vybeg
