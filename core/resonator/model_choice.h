#pragma once

#include "core/resonator/model_fit.h"
#include "core/resonator/reason.h"
#include "core/resonator/resonator_fit.h"

#include <span>
#include <vector>

namespace vybeg {

// Which model the runs bear, and its fit. Amplitudes in the scale of the runs.
struct ModelChoice {
    ResonatorModel model{};
    ModelSpace space;
    ModelFit fit;
    Eigen::MatrixXd covariance;  // of `fit` in the coordinates of phasor_model.h, not enlarged
    double dof = 0;
    double enlargement = 1;  // of variances: chi^2/dof where significantly above 1
    double free_over_structured = 0;
    bool split_seen = false;
    bool damping_seen = false;
    bool rotation_seen = false;
    bool equal_damping = false;  // assumed, for kappa's sake
    Estimate kappa;
    std::vector<Estimate> drift_hz_per_s;  // one for each run
    Estimate frequency_per_power;          // Hz per squared scaled amplitude
    std::vector<Diagnostic> warnings;      // those that tell of the choice
};

// Errors: fit_failed, interrupted.
Result<ModelChoice> choose_model(std::span<const ScaledRun> runs, const FitOptions& options,
                                 const JobControl& job);

}  // namespace vybeg
