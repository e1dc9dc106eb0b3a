#pragma once

#include "core/resonator/results/fitted_set.h"
#include "core/resonator/results/resonator_result.h"

#include <span>

namespace vybeg {

// Adds modes, resonator and runs: each number with its deviation, or the reason for its absence
// (FIT section 5). `runs`: as fitted.
void add_estimates(const FittedSet& set, std::span<const PhasorRun> runs, ResonatorFit& fit);

// Removes all numbers of modes, resonator and runs, except Q of the envelope, which follows from
// the recorded power only.
void refuse_all(const Reason& reason, ResonatorFit& fit);

}  // namespace vybeg
