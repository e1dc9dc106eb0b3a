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

// Called before the first window is estimated, with the prepared recording and the
// summary so far. An error ends the analysis.
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

// Takes an analysis that has only some of its windows yet: fewer rows than plan.count, all of them
// in their order, with the first and the last window among them. Settings and plan are those of the
// whole; it has no timing and no findings of the sample check.
using EarlySink = std::function<void(Analysis)>;

// analyse(), for those who watch. Where all windows take longer than a glance, `early` first gets
// single windows spread over the whole range and the visible part, then all windows of the visible
// part; only the latter, where they do not take long. Their values are those of the result to 1e-9,
// but for: flags of clipped and lost samples and of motion; deviations of short windows, whose
// noise is that of the windows around; 2theta_A modulo pi, where the wave turns by more than pi/2
// between two spread windows; and what depends on StartRule::previous. The result itself is that of
// analyse(), to the bit. Errors as of analyse().
Result<Analysis> analyse_visible_first(const Recording& recording, const Settings& settings,
                                       const TimeRange& visible, const EarlySink& early,
                                       const JobControl& job);

}  // namespace vybeg
