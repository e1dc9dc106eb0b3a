#pragma once

#include "core/recording/recording_check.h"
#include "core/track/flagged_rows.h"
#include "core/windows/window_plan.h"

#include <vector>

namespace vybeg {

// Which windows of a plan lie over faults of the samples: Flag::clipped over stretches at the rail,
// Flag::gap where samples were lost or doubled inside. Ordered by first row;
// stretches of one flag do not overlap.
std::vector<FlaggedRows> windows_over(const SampleFaults& faults, const WindowPlan& plan);

}  // namespace vybeg
