#pragma once

#include "core/resonator/fit/map_fit.h"
#include "core/resonator/fit/posterior.h"
#include "core/resonator/results/reported_variances.h"
#include "core/resonator/results/resonator_result.h"

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

}  // namespace vybeg
