#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/resonator/phasor_model.h"

#include <initializer_list>

namespace vybeg {

// Which of the parameters a fit may move: the shared ones along the columns of `basis`
// (shared_count rows, orthonormal), each run's frequency and start always, its drift where asked.
struct ModelSpace {
    Eigen::MatrixXd basis;
    bool drift = false;
};

// A space whose columns are single shared parameters, by index.
ModelSpace space_of(std::initializer_list<int> shared, bool drift);

// Parameters of a space for `runs` runs.
Eigen::Index dimension(const ModelSpace& space, std::size_t runs);

// Degrees of freedom: residuals less parameters.
double degrees(std::span<const ScaledRun> runs, const ModelSpace& space);

// By how much the noise exceeds its stated variance: chi^2/dof where that is above 1 by more than
// four of its own standard deviations, else 1.
double enlargement_of(double chi2, double dof);

struct ModelFit {
    FitState state;
    double chi2 = 0;
    bool converged = false;
};

// Least squares from `start` by Levenberg and Marquardt (Ceres), one thread: the same data give the
// same bits. The runs are eliminated one by one, so that the cost grows with their number, not with
// its cube. Errors: fit_failed where a residual is not finite, interrupted.
Result<ModelFit> fit_model(std::span<const ScaledRun> runs, const ModelSpace& space,
                           const FitState& start, const JobControl& job);

// (J^T J)^-1 of the space at `state`, in the coordinates shared, run 1, run 2, ...: rows and
// columns of what the space holds fixed are zero. A direction that the data do not see at all (its
// information below 1e-14 of what its coordinates have singly) gets the variance of that bound:
// huge, not infinite. Where the runs see no more than their noise, that is the Cramer-Rao bound.
Eigen::MatrixXd covariance(std::span<const ScaledRun> runs, const ModelSpace& space,
                           const FitState& state);

}  // namespace vybeg
