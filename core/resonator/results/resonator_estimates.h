#pragma once

#include "core/resonator/fit/map_fit.h"
#include "core/resonator/fit/posterior.h"
#include "core/resonator/results/reported_variances.h"
#include "core/resonator/results/resonator_result.h"

#include <span>

namespace vybeg {

// A fit and what is known of it.
struct FittedSet {
    ResonatorModel model{};
    const FitProblem* problem = nullptr;
    MapFit fit;
    Posterior posterior;
    QuantityContext context;
    ReportedVariances variances;
    double scale = 1;        // recording units of a scaled unit
    double split_needs = 3;  // standard deviations, from which on a split or anisotropy is given
    Estimate cubic_limit;    // b and its sd where a fit with it was no better; scaled units
    bool amplitude_or_time = false;  // settling frequencies explain the phasors as well as b
};

// Fills in the modes, the resonator and the runs: each number with its deviation, or the reason why
// it is not given (FIT section 5). `runs`: as fitted.
void add_estimates(const FittedSet& set, std::span<const PhasorRun> runs, ResonatorFit& fit);

// Takes all numbers back, of modes, resonator and runs, but Q of the envelope, which rests on the
// recorded power alone.
void refuse_all(const Reason& reason, ResonatorFit& fit);

}  // namespace vybeg
