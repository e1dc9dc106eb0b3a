#pragma once

#include "core/resonator/results/fitted_set.h"

#include <vector>

namespace vybeg {

// Changes of the resonator's parameters by errors of the channels and effects of the amplitude, in
// the order of resonator_parameters; NaN if a parameter is not given. f_ref_hz: mean of the runs'
// references.
std::vector<ChannelSensitivity> sensitivities(const FittedSet& set,
                                              const ResonatorEstimate& resonator, double f_ref_hz);

// Contributions of the channels' tolerances to the parameters' combined uncertainties, in the same
// order: |dx/dm| s of the mean m and the deviation s of each tolerance's prior. Zeros if a
// parameter is not given.
std::vector<ToleranceShares> tolerance_shares(const FittedSet& set,
                                              const ResonatorEstimate& resonator, double f_ref_hz);

}  // namespace vybeg
