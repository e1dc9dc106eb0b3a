#pragma once

#include "core/estimators/batch/descent.h"
#include "core/estimators/batch/profile.h"
#include "core/estimators/wave/estimator.h"

namespace vybeg {

// The in-phase closed forms (15), (18) of one window at a given frequency: the start values of
// algorithm 5.
WaveState in_phase_start(const Window& window, double w);

struct Descent {
    WaveParameters parameters;
    bool converged = false;  // the gradient vanishes, to rounding, at a minimum inside the bracket
};

// Minimises n F over a window from the given start by preconditioned conjugate gradients: exact
// step -g.d / d.H.d along each direction, a line search where the curvature d.H.d is not positive
// or the exact step does not descend.
Descent descend(const Window& window, const FrequencyBracket& bracket, const WaveParameters& start);

}  // namespace vybeg
