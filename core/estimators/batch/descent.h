#pragma once

#include "core/estimators/batch/profile.h"
#include "core/estimators/batch/window_estimate.h"

#include <array>

// Algorithm 5: n F, the error functional of the article's last section, over all five parameters.

namespace vybeg {

// One number for each of a_A, a_B, 2theta_A, alpha and the frequency: radians per sample of one
// window, x of eight.
template <class Real>
using Five = std::array<Real, 5>;

template <class Real>
VYBEG_INLINED inline Five<Real> five_of(const WaveStateOf<Real>& wave, Real frequency) {
    return {wave.a_A, wave.a_B, wave.two_theta_A, wave.alpha, frequency};
}

template <class Real>
struct WaveFunctional {
    Real value;
    Five<Real> gradient;
    std::array<Five<Real>, 5> hessian;
};

// n F of one window less the power of its samples.
WaveFunctional<double> functional_at(const Window& window, const Five<double>& at);

// The in-phase closed forms (15), (18) of one window at a given frequency: the start values.
Five<double> in_phase_start(const Window& window, double w);

struct Descent {
    Five<double> at{};
    bool converged = false;  // the gradient vanishes, to rounding, at a minimum inside the bracket
};

// Minimises n F over a window from the given start by preconditioned conjugate gradients: exact
// step -g.d / d.H.d along each direction, a line search where the curvature d.H.d is not positive
// or the exact step does not descend.
Descent descend(const Window& window, const FrequencyBracket& bracket, const Five<double>& start);

// The five parameters of eight windows, the frequency as x.
using BatchStart = Five<Lanes>;

// in_phase_start() at the reference frequency.
void in_phase_starts(const ProjectionBatch& batch, const TaylorFrame& frame, BatchStart& start);

// The conjugate gradient of descend() for eight windows, with the same steps; F and its derivatives
// come from the series of the projections. Windows whose steps leave the reach of the series or
// whose step is not the exact one do not arrive: descend() is for them.
void descend_batch(const ProjectionBatch& batch, const TaylorFrame& frame, const BatchStart& start,
                   SeriesFit<Vec8>& found);

}  // namespace vybeg
