#pragma once

#include "core/base/dispatch.h"

#include <array>
#include <cstddef>

namespace vybeg {

// The error functional F of the article's last section by its five parameters, for one window
// (Real = double) or for several side by side (lanes.h).
//
// Seen along the wave's axes and in its phase the projections Z = sum s e^{-iwu} of both signals
// are
//     A = e^{i alpha} (Z_C cos 2theta + Z_D sin 2theta)
//     B = e^{i alpha} (Z_D cos 2theta - Z_C sin 2theta)
// and, with D = sum cos 2wu, n F less the power of the samples is
//     n/2 (a_A^2 + a_B^2) + D/2 cos 2alpha (a_A^2 - a_B^2) - 2 a_A Re A + 2 a_B Im B.
// dA/d2theta = B, dB/d2theta = -A, d/dalpha = i of both; that gives all derivatives.

// A number with its first and second derivative by the frequency.
template <class Real>
using FrequencyJet = std::array<Real, 3>;

template <class Real>
struct ComplexJet {
    FrequencyJet<Real> re;
    FrequencyJet<Real> im;
};

// cos and sin of 2theta_A and alpha beside the amplitudes.
template <class Real>
struct TurnedWave {
    Real a_A;
    Real a_B;
    Real cos_angle;
    Real sin_angle;
    Real cos_phase;
    Real sin_phase;
};

// Value, gradient and Hessian by (a_A, a_B, 2theta_A, alpha, frequency).
template <class Real>
struct WaveFunctional {
    Real value;
    std::array<Real, 5> gradient;
    std::array<std::array<Real, 5>, 5> hessian;
};

// z_c and z_d by the frequency in the unit of choice; `dirichlet` is D.
template <class Real>
VYBEG_INLINED inline WaveFunctional<Real> wave_functional(const TurnedWave<Real>& wave,
                                                          const ComplexJet<Real>& z_c,
                                                          const ComplexJet<Real>& z_d,
                                                          const FrequencyJet<Real>& dirichlet,
                                                          double n) {
    const Real a = wave.a_A;
    const Real b = wave.a_B;
    ComplexJet<Real> A;
    ComplexJet<Real> B;
    for (std::size_t k = 0; k < 3; ++k) {
        const Real a_re = wave.cos_angle * z_c.re[k] + wave.sin_angle * z_d.re[k];
        const Real a_im = wave.cos_angle * z_c.im[k] + wave.sin_angle * z_d.im[k];
        const Real b_re = wave.cos_angle * z_d.re[k] - wave.sin_angle * z_c.re[k];
        const Real b_im = wave.cos_angle * z_d.im[k] - wave.sin_angle * z_c.im[k];
        A.re[k] = wave.cos_phase * a_re - wave.sin_phase * a_im;
        A.im[k] = wave.cos_phase * a_im + wave.sin_phase * a_re;
        B.re[k] = wave.cos_phase * b_re - wave.sin_phase * b_im;
        B.im[k] = wave.cos_phase * b_im + wave.sin_phase * b_re;
    }
    const Real cosine = wave.cos_phase * wave.cos_phase - wave.sin_phase * wave.sin_phase;
    const Real sine = 2.0 * wave.sin_phase * wave.cos_phase;
    const Real dc = dirichlet[0] * cosine;
    const Real ds = dirichlet[0] * sine;
    const Real dc1 = dirichlet[1] * cosine;
    const Real difference = a * a - b * b;

    WaveFunctional<Real> f;
    f.value = 0.5 * (n * (a * a + b * b) + dc * difference) - 2.0 * (a * A.re[0] - b * B.im[0]);
    f.gradient = {(n + dc) * a - 2.0 * A.re[0], (n - dc) * b + 2.0 * B.im[0],
                  -2.0 * (a * B.re[0] + b * A.im[0]),
                  2.0 * (a * A.im[0] + b * B.re[0]) - ds * difference,
                  0.5 * dc1 * difference - 2.0 * (a * A.re[1] - b * B.im[1])};
    auto& h = f.hessian;
    const Real turning = 2.0 * (a * A.re[0] - b * B.im[0]);
    h[0] = {n + dc, Real{}, -2.0 * B.re[0], 2.0 * (A.im[0] - ds * a), dc1 * a - 2.0 * A.re[1]};
    h[1] = {Real{}, n - dc, -2.0 * A.im[0], 2.0 * (B.re[0] + ds * b), 2.0 * B.im[1] - dc1 * b};
    h[2] = {h[0][2], h[1][2], turning, 2.0 * (a * B.im[0] - b * A.re[0]),
            -2.0 * (a * B.re[1] + b * A.im[1])};
    h[3] = {h[0][3], h[1][3], h[2][3], turning - 2.0 * dc * difference,
            2.0 * (a * A.im[1] + b * B.re[1]) - dirichlet[1] * sine * difference};
    h[4] = {h[0][4], h[1][4], h[2][4], h[3][4],
            0.5 * dirichlet[2] * cosine * difference - 2.0 * (a * A.re[2] - b * B.im[2])};
    return f;
}

}  // namespace vybeg
