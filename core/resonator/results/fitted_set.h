#pragma once

#include "core/resonator/fit/map_fit.h"
#include "core/resonator/fit/posterior.h"
#include "core/resonator/results/reported_variances.h"
#include "core/resonator/results/resonator_result.h"

namespace vybeg {

// A fit and its properties.
struct FittedSet {
    ResonatorModel model{};
    const FitProblem* problem = nullptr;
    MapFit fit;
    Posterior posterior;
    QuantityContext context;
    ChannelTolerance tolerance;  // told or assumed
    Eigen::MatrixXd moved;       // by the tolerance (sensitivities.h)
    Eigen::MatrixXd scattered;   // by one deviation of each run from the set
    ReportedVariances variances;
    double scale = 1;        // recording units of a scaled unit
    double split_needs = 3;  // least size of a given split or anisotropy, standard deviations
    Estimate cubic_limit;    // b and its sd if a fit with it was no better; scaled units
    bool amplitude_or_time = false;  // settling frequencies explain the phasors as well as b
};

}  // namespace vybeg
