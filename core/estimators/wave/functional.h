#pragma once

#include "core/estimators/wave/wave_state.h"
#include "core/estimators/wave/window_moments.h"

#include <Eigen/Core>

namespace vybeg {

// The five parameters of the error functional F of the article's last section, in this order.
struct WaveParameters {
    WaveState state;
    double w = 0;  // radians per sample
};

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

// n F = sum of both squared errors over the window, less the constant sum of the squared samples,
// with its gradient and Hessian by (a_A, a_B, 2theta_A, alpha, w). From moments taken at
// parameters.w.
struct Functional {
    double value = 0;
    Vector5 gradient;
    Matrix5 hessian;
};

Functional evaluate_functional(const WaveParameters& parameters, const Moments& moments,
                               const WindowKernel& kernel);

}  // namespace vybeg
