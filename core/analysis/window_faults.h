#pragma once

#include "core/recording/checks/recording_check.h"
#include "core/track/track.h"
#include "core/windows/window_plan.h"

#include <vector>

namespace vybeg {

// Which windows of a plan lie over faults of the samples: Flag::clipped over segments at the rail,
// Flag::gap where samples were lost or doubled inside. Ordered by first row;
// segments of one flag do not overlap.
std::vector<FlaggedRows> windows_over(const SampleFaults& faults, const WindowPlan& plan);

// The rows of `moving` that no window over a fault explains: all but those within two
// windows' lengths of `over_faults`, as far as motion is looked for.
std::vector<FlaggedRows> moving_apart(const std::vector<FlaggedRows>& moving,
                                      const std::vector<FlaggedRows>& over_faults,
                                      const WindowPlan& plan);

}  // namespace vybeg
