#pragma once

#include "core/estimators/batch/descent.h"
#include "core/estimators/batch/profile.h"
#include "core/estimators/wave/estimator.h"

namespace vybeg {

// Algorithm 5: the article's conjugate gradient over all five parameters at once, with the analytic
// gradient and Hessian of F.
std::unique_ptr<Estimator> make_conjugate_gradient(const EstimatorOptions& options);

struct Descent {
    WaveParameters parameters;
    int steps = 0;
    bool converged = false;  // the gradient vanishes, to rounding, at a minimum inside the bracket
};

// Minimises n F over a window from the given start by preconditioned conjugate gradients: exact
// step -g.d / d.H.d along each direction, a line search where the curvature d.H.d is not positive
// or the exact step does not descend.
Descent descend(const Window& window, const FrequencyBracket& bracket, const WaveParameters& start);

}  // namespace vybeg
