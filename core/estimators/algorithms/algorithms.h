#pragma once

#include "core/estimators/batch/descent.h"
#include "core/estimators/batch/profile.h"
#include "core/estimators/wave/estimator.h"

namespace vybeg {

// The article's algorithms 1 to 4: four parameters in closed form at a given frequency, and the
// frequency from the minimum of J, (16), (25), (29), in one parameter.
std::unique_ptr<Estimator> make_closed_form(Algorithm algorithm, const EstimatorOptions& options);

// The in-phase closed forms (15), (18) of one window at a given frequency: the start values of
// algorithm 5.
WaveState in_phase_start(const Window& window, double w);

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

// Algorithm 6: least squares over all five parameters by variable projection (METHOD section 5.6),
// which in white noise is maximum likelihood. Exact for every window of at least least_window()
// samples.
std::unique_ptr<Estimator> make_maximum_likelihood(const EstimatorOptions& options);

}  // namespace vybeg
