#pragma once

#include "core/resonator/model/fitted_motion.h"
#include "core/resonator/model/phasor_run.h"

#include <span>

namespace vybeg {

struct NeededWindows {
    double by_motion = 0;
    double by_line = 0;
};

// How many windows of a run the fit's merged ones must be, by what they gave (TRUTH principle 4):
// so short that a frequency that changes on the way turns all of them nearly alike (a mean loses
// turn^2/24 of the amplitude); and several for each cycle of the modes found, and of any line that
// the residual of the unmerged windows shows beyond the merged ones' band. Such a line counts at
// its alias: a wave that stands near one mode's axis shows the other mode too weakly for
// merge_windows(). `fine`: the runs of the motion, unmerged.
NeededWindows needed_windows(const FittedMotion& motion, std::span<const PhasorRun> fine);

}  // namespace vybeg
