#pragma once

#include "core/resonator/model_choice.h"

#include <span>

namespace vybeg {

// The numbers of a fit with their deviations, by the delta method from the covariance of its
// parameters, or the reasons why they are not given. `runs` as they came, `scaled` as fitted,
// `scale` the recording units of one scaled unit.
ResonatorFit estimates(const ModelChoice& choice, std::span<const PhasorRun> runs,
                       std::span<const ScaledRun> scaled, double scale);

}  // namespace vybeg
