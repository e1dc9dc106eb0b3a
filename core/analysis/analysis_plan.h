#pragma once

#include "core/analysis/prepare.h"
#include "core/analysis/settings.h"
#include "core/windows/window_plan.h"

namespace vybeg {

// Where the windows of a prepared recording lie. Errors: window_too_short, window_too_long.
Result<WindowPlan> plan_of(const WindowSettings& settings, const ConditionedRecording& prepared,
                           const Recording& recording);

}  // namespace vybeg
