#pragma once

#include "core/resonator/results/fitted_set.h"

#include <vector>

namespace vybeg {

// Changes of the resonator's parameters by errors of the channels and effects of the amplitude, in
// the order of resonator_parameters; NaN if a parameter is not given. f_ref_hz: mean of the runs'
// references.
std::vector<ChannelSensitivity> sensitivities(const FittedSet& set,
                                              const ResonatorEstimate& resonator, double f_ref_hz);

}  // namespace vybeg
