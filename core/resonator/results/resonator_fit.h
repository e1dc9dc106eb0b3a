#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/resonator/model/phasor_run.h"
#include "core/resonator/results/fit_options.h"
#include "core/resonator/results/resonator_result.h"

#include <span>

namespace vybeg {

// Fits one resonator to all runs together (METHOD section 8): one M, and a start, frequency and
// drift of each run. One model with all its parameters and priors, all results from one covariance;
// a parameter is given if the data narrow its prior. Standard deviations follow the actual
// residual, coloured or white. Where the stated tolerances leave more than noise and the assumed
// ones as priors do not, this fit counts. The same bits for any number of threads. Errors:
// fit_too_few_windows, fit_failed, interrupted.
Result<ResonatorFit> fit_resonator(std::span<const PhasorRun> runs, const FitOptions& stated,
                                   const JobControl& job);

}  // namespace vybeg
