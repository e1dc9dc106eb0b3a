#pragma once

#include "core/resonator/model/fitted_motion.h"
#include "core/resonator/model/phasor_run.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// The run with neighbouring windows averaged to about `most` longer ones, because the time of the
// fit grows with their number, its precision does not. Adjacent windows form exactly one window of
// the sum of their lengths (phasor_run.h); a remainder before a gap is excluded, at most a tenth of
// all. No merging if the phasors would turn by more than 0.3 rad.
PhasorRun merge_windows(const PhasorRun& run, std::size_t most);

// The windows with finite values and a deviation.
PhasorRun usable_windows(const PhasorRun& run);

// The windows up to where the wave falls below ten deviations for good.
PhasorRun seen_windows(const PhasorRun& run);

struct NeededWindows {
    double by_motion = 0;
    double by_line = 0;
};

// Number of merged windows that a run needs, by the result of the fit. by_motion: windows so short
// that the changing frequency turns the phasor by about the same angle in each of them (a mean
// loses turn^2/24 of the amplitude). by_line: several windows per cycle of the modes found and of
// any line beyond their band in the residual of the unmerged windows. Such a line acts at its
// alias: near the axis of one mode a wave shows the other mode too weakly for merge_windows().
// `fine`: the runs of the motion, unmerged.
NeededWindows needed_windows(const FittedMotion& motion, std::span<const PhasorRun> fine);

// For each run the lower triangle W that makes the white noise of both channels equal and
// independent, in units of the windows' sd; the unit matrix where they are within six deviations,
// and where both channels share nearly all of their noise.
// From third differences of the windows' phasors less the fitted ones, in which slow motions are
// missing.
std::vector<Eigen::Matrix2d> whitenings(const FittedMotion& motion,
                                        std::span<const PhasorRun> runs);

}  // namespace vybeg
