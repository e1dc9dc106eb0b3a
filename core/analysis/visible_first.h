#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/base/job_control.h"
#include "core/recording/samples/recording.h"

#include <functional>

namespace vybeg {

// Takes an analysis that has only some of its windows yet: fewer rows than plan.count, all of them
// in their order, with the first and the last window among them. Settings and plan are those of the
// whole; it has no timing and no findings of the sample check.
using EarlySink = std::function<void(Analysis)>;

// analyse(), for those who watch: where all windows take longer than a glance, `early` first gets
// single windows spread over the whole range and over the visible part of it, then all windows of
// the visible part between the spread ones; at once the latter, where they do not take long. Their
// values are those of the result to 1e-9, flags of
// clipped and lost samples and of motion excepted, and deviations of short windows, whose noise is
// that of the windows around; 2theta_A modulo pi, where the wave turns by more
// than pi/2 between two spread windows, and windows that start from the one before
// (StartRule::previous) as far as that start decides what they find. The result itself is that of
// analyse(), to the bit. Errors as of analyse().
Result<Analysis> analyse_visible_first(const Recording& recording, const Settings& settings,
                                       const TimeRange& visible, const EarlySink& early,
                                       const JobControl& job);

}  // namespace vybeg
