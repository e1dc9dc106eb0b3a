#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/resonator/model/power_run.h"
#include "core/resonator/results/fit_options.h"
#include "core/resonator/results/resonator_result.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace vybeg {

// The resonator of free decays of which E, R, S, Q are kept: all of it but
// the frequency, which has no place in them.

// 2/tau, g cos 4theta_tau, g sin 4theta_tau, dw sin 4theta_w, dw cos 4theta_w, 2r of the slow
// motion, 1/s: linear least squares of E, R, S, Q less their starts against the integrals of E, R,
// S, Q. The integrals are along the noisy rows, so that noise makes them too small: a start.
Eigen::VectorXd linear_powers(std::span<const PowerRun> runs);

struct PowerFit {
    ResonatorFit fit;
    std::vector<PhasorRun> runs;  // with their phase as fitted, and the sd of their noise
};

// The fit of fit_resonator() with the phase of each row left out, from the linear start: the same
// priors, covariance and verdicts; the structured model. A number that needs the frequency has the
// reason phase_lost. Errors: fit_too_few_windows, fit_failed, interrupted.
Result<PowerFit> fit_powers(std::span<const PowerRun> runs, const FitOptions& options,
                            const JobControl& job);

}  // namespace vybeg
