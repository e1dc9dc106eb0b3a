#pragma once

#include "core/resonator/map_fit.h"

#include <Eigen/Core>

#include <optional>

namespace vybeg {

// Start values from the best of all matrix pencils: z(t + lag) = E z(t) in least squares over one
// run or over all, M = log(E)/lag, for lags from one window to a third of the run, and those of
// delayed_pencil.h. They find resolved pairs; where the wave hardly moves, there is none, or it is
// no good. Parameters that the problem holds stand at their means.
std::optional<Eigen::VectorXd> pencil_start(const FitProblem& problem);

}  // namespace vybeg
