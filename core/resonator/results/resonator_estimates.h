#pragma once

#include "core/resonator/results/fitted_set.h"
#include "core/resonator/results/resonator_result.h"

#include <span>

namespace vybeg {

// Fills in the modes, the resonator and the runs: each number with its deviation, or the reason why
// it is not given (FIT section 5). `runs`: as fitted.
void add_estimates(const FittedSet& set, std::span<const PhasorRun> runs, ResonatorFit& fit);

// Takes all numbers back, of modes, resonator and runs, but Q of the envelope, which rests on the
// recorded power alone.
void refuse_all(const Reason& reason, ResonatorFit& fit);

}  // namespace vybeg
