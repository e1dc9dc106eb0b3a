#pragma once

#include "core/resonator/model/fitted_motion.h"
#include "core/resonator/model/phasor_run.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// Condition (30) along one run: <S_A S_B> / (<S_A^2> + <S_B^2>) in the axes of the fitted motion,
// at a few points. It is zero within its deviation if the channels are balanced as in the fit. It
// deviates if the gain or direction of a pick-off changes during the run or depends on the
// amplitude. A constant error looks like a damping anisotropy and is absorbed by the fit.
struct ChannelBalance {
    std::vector<double> time_s;
    std::vector<double> theta_rad;  // mean direction of the fitted wave, (-pi/4, pi/4]
    std::vector<double> orthogonality;
    std::vector<double> sd;
};

// At most `most_points` means over consecutive windows. `motion` is that of the structured model;
// `index` is the run's place in it. Windows with a circular fitted wave have no axes and are
// ignored.
ChannelBalance channel_balance(const PhasorRun& run, const FittedMotion& motion, std::size_t index,
                               std::size_t most_points);

// For each run the lower triangle W that makes the white noise of both channels equal and
// independent, in units of the windows' sd; the unit matrix where they are within six deviations,
// and where both channels share nearly all of their noise.
// From third differences of the windows' phasors less the fitted ones, in which slow motions are
// missing.
std::vector<Eigen::Matrix2d> whitenings(const FittedMotion& motion,
                                        std::span<const PhasorRun> runs);

}  // namespace vybeg
