#pragma once

#include "core/resonator/results/fitted_set.h"

#include <vector>

namespace vybeg {

// What errors of the channels and effects of the amplitude would change in the resonator's
// parameters, in the order of resonator_parameters; NaN where a parameter is not given. f_ref_hz:
// mean of the runs' references.
std::vector<ChannelSensitivity> sensitivities(const FittedSet& set,
                                              const ResonatorEstimate& resonator, double f_ref_hz);

}  // namespace vybeg
