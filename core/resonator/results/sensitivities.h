#pragma once

#include "core/resonator/results/fitted_set.h"

#include <Eigen/Core>

#include <vector>

namespace vybeg {

// Errors of the active parameters by channel errors of the size of their tolerances, of which the
// fit knows no more than its priors: columns as channel_errors. With J e the error in the phasors,
// S the covariance and F the information, S F_e e where the fit holds the error at zero, and
// -S_e e/s^2 where it has the prior s.
Eigen::MatrixXd moved_by(const FitProblem& problem, const Posterior& posterior,
                         const ChannelTolerance& tolerance);

// By how much the resonator's parameters are wrong per unit of each error, in the order of
// resonator_parameters; NaN if a parameter is not given.
std::vector<BySource> sensitivities(const FittedSet& set, const ResonatorEstimate& resonator);

// Contributions of the channels' tolerances to the parameters' combined uncertainties, in the same
// order. Zeros if a parameter is not given.
std::vector<BySource> tolerance_shares(const FittedSet& set, const ResonatorEstimate& resonator);

}  // namespace vybeg
