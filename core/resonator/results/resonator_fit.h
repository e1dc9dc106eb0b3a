#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/resonator/model/channel_tolerance.h"
#include "core/resonator/model/phasor_run.h"
#include "core/resonator/results/resonator_result.h"

#include <optional>
#include <span>

namespace vybeg {

struct FitOptions {
    enum class Model { automatic, structured, free };
    Model model = Model::automatic;
    ChannelTolerance tolerance{};  // priors of the fit
    // Of errors without a tolerance, which the fit holds at zero: their part of u.
    ChannelTolerance assumed{.kappa = 0};
    // Between the runs of a set, in u: relative sd of 1/tau (that of the split and of the gain
    // ratio follow, `largest_spread`). None: what two or three runs cannot show is assumed.
    std::optional<double> spread = 0;
};

// Fits one resonator to all runs together (METHOD section 8): one M, and a start, frequency and
// drift of each run. One model with all its parameters and priors, all results from one covariance;
// a parameter is given if the data narrow its prior. Standard deviations follow the actual
// residual, coloured or white. The same bits for any number of threads. Errors:
// fit_too_few_windows, fit_failed, interrupted.
Result<ResonatorFit> fit_resonator(std::span<const PhasorRun> runs, const FitOptions& options,
                                   const JobControl& job);

}  // namespace vybeg
