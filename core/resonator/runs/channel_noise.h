#pragma once

#include "core/resonator/model/fitted_motion.h"
#include "core/resonator/model/phasor_run.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace vybeg {

// For each run the lower triangle W that makes the white noise of both channels equal and
// independent, in units of the windows' sd; the unit matrix where they are within six deviations,
// and where both channels share nearly all of their noise.
// From third differences of the windows' phasors less the fitted ones, in which slow motions are
// missing.
std::vector<Eigen::Matrix2d> whitenings(const FittedMotion& motion,
                                        std::span<const PhasorRun> runs);

}  // namespace vybeg
