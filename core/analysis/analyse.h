#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/estimate_track.h"
#include "core/analysis/prepare.h"
#include "core/analysis/settings.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/recording.h"
#include "core/windows/window_plan.h"

#include <functional>

namespace vybeg {

// Where the windows of a prepared recording lie. Errors: window_too_short, window_too_long.
Result<WindowPlan> plan_of(const WindowSettings& settings, const ConditionedRecording& prepared,
                           const Recording& recording);

// Called before the first window is estimated, with the prepared recording and what is known of the
// analysis until then. An error ends the analysis.
using BeforeWindows = std::function<Status(const ConditionedRecording&, const AnalysisSummary&)>;

// The whole road from a recording to its track, of which `sink` takes the rows while they are made:
// memory does not grow with the recording. The summary's `flagged` are left to the caller. Errors:
// those of the sink, setting_invalid, the analysis group, and the input group where reading fails
// on the way; interrupted. The result is the same to the last bit for any number of threads.
Result<AnalysisSummary> analyse(const Recording& recording, const Settings& settings,
                                const TrackSink& sink, const JobControl& job,
                                const BeforeWindows& before = {});

// The same with the whole track, flags set.
Result<Analysis> analyse(const Recording& recording, const Settings& settings,
                         const JobControl& job, const BeforeWindows& before = {});

}  // namespace vybeg
