#pragma once

#include "core/resonator/model/fitted_motion.h"
#include "core/resonator/model/phasor_run.h"

#include <cstddef>
#include <vector>

namespace vybeg {

// Condition (30) along one run: <S_A S_B> / (<S_A^2> + <S_B^2>) in the axes of the fitted motion,
// at a few points. It is zero within its deviation where the channels are balanced as the fit has
// them, and leaves zero where a pick-off's gain or direction changes on the way or depends on the
// amplitude. A constant error of them looks like a damping anisotropy, and the fit takes it in.
struct ChannelBalance {
    std::vector<double> time_s;
    std::vector<double> orthogonality;
    std::vector<double> sd;
};

// At most `most_points` means over consecutive windows. `motion` is that of the structured model;
// `index` is the run's place in it. Windows whose fitted wave is circular have no axes and do not
// count.
ChannelBalance channel_balance(const PhasorRun& run, const FittedMotion& motion, std::size_t index,
                               std::size_t most_points);

}  // namespace vybeg
