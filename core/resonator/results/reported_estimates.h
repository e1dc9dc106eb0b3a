#pragma once

#include "core/resonator/results/fitted_set.h"

namespace vybeg {

// Adds modes, resonator and runs: each number with its deviation, or the reason for its absence
// (FIT section 5).
void add_estimates(const FittedSet& set, ResonatorFit& fit);

// Removes all numbers of the resonator, and with them their sensitivities and shares.
void refuse_resonator(const Reason& reason, ResonatorFit& fit);

// Removes all numbers of modes, resonator and runs, except Q of the envelope, which follows from
// the recorded power only.
void refuse_all(const Reason& reason, ResonatorFit& fit);

}  // namespace vybeg
