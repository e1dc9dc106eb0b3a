#pragma once

#include "core/estimators/batch/window_jets.h"
#include "core/estimators/wave/wave_formulas.h"

#include <array>
#include <cstddef>

namespace vybeg {

// Error functional F of the article's last section over its five parameters, with derivatives.
//
// Seen along the wave's axes and in its phase the projections Z = sum s e^{-iwu} of both signals
// are
//     A = e^{i alpha} (Z_C cos 2theta + Z_D sin 2theta)
//     B = e^{i alpha} (Z_D cos 2theta - Z_C sin 2theta)
// and, with D = sum cos 2wu, n F less the power of the samples is
//     n/2 (a_A^2 + a_B^2) + D/2 cos 2alpha (a_A^2 - a_B^2) - 2 a_A Re A + 2 a_B Im B.
// dA/d2theta = B, dB/d2theta = -A, d/dalpha = i of both, which yields all derivatives.

// One number for each of a_A, a_B, 2theta_A, alpha and the frequency.
template <class Real>
using Five = std::array<Real, 5>;

template <class Real>
struct WaveFunctional {
    Real value;
    Five<Real> gradient;
    std::array<Five<Real>, 5> hessian;
};

// By the frequency in the unit of the jets.
template <class Real>
VYBEG_INLINED inline WaveFunctional<Real> wave_functional(const TurnedWave<Real>& wave,
                                                          const WindowJets<Real>& s, double n) {
    const Real a = wave.a_A;
    const Real b = wave.a_B;
    struct Turned {
        Jet2<Real> re;
        Jet2<Real> im;
    };
    const auto turned = [&](const Jet2<Real>& re, const Jet2<Real>& im) VYBEG_INLINED {
        return Turned{wave.cos_phase * re - wave.sin_phase * im,
                      wave.cos_phase * im + wave.sin_phase * re};
    };
    // Z = p - iq.
    const Turned A = turned(wave.cos_angle * s.pc + wave.sin_angle * s.pd,
                            -(wave.cos_angle * s.qc + wave.sin_angle * s.qd));
    const Turned B = turned(wave.cos_angle * s.pd - wave.sin_angle * s.pc,
                            -(wave.cos_angle * s.qd - wave.sin_angle * s.qc));
    const Jet2<Real> dirichlet{2 * s.g.value - n, 2 * s.g.slope, 2 * s.g.bend};
    const Real cosine = wave.cos_phase * wave.cos_phase - wave.sin_phase * wave.sin_phase;
    const Real sine = 2.0 * wave.sin_phase * wave.cos_phase;
    const Real dc = dirichlet.value * cosine;
    const Real ds = dirichlet.value * sine;
    const Real dc1 = dirichlet.slope * cosine;
    const Real difference = a * a - b * b;

    WaveFunctional<Real> f;
    f.value =
        0.5 * (n * (a * a + b * b) + dc * difference) - 2.0 * (a * A.re.value - b * B.im.value);
    f.gradient = {(n + dc) * a - 2.0 * A.re.value, (n - dc) * b + 2.0 * B.im.value,
                  -2.0 * (a * B.re.value + b * A.im.value),
                  2.0 * (a * A.im.value + b * B.re.value) - ds * difference,
                  0.5 * dc1 * difference - 2.0 * (a * A.re.slope - b * B.im.slope)};
    auto& h = f.hessian;
    const Real turning = 2.0 * (a * A.re.value - b * B.im.value);
    h[0] = {n + dc, Real{}, -2.0 * B.re.value, 2.0 * (A.im.value - ds * a),
            dc1 * a - 2.0 * A.re.slope};
    h[1] = {Real{}, n - dc, -2.0 * A.im.value, 2.0 * (B.re.value + ds * b),
            2.0 * B.im.slope - dc1 * b};
    h[2] = {h[0][2], h[1][2], turning, 2.0 * (a * B.im.value - b * A.re.value),
            -2.0 * (a * B.re.slope + b * A.im.slope)};
    h[3] = {h[0][3], h[1][3], h[2][3], turning - 2.0 * dc * difference,
            2.0 * (a * A.im.slope + b * B.re.slope) - dirichlet.slope * sine * difference};
    h[4] = {h[0][4], h[1][4], h[2][4], h[3][4],
            0.5 * dirichlet.bend * cosine * difference - 2.0 * (a * A.re.bend - b * B.im.bend)};
    return f;
}

// The five parameters of one window. n F less the power of the samples follows from moments at w.
struct WaveParameters {
    WaveState state;
    double w = 0;  // radians per sample
};
WaveFunctional<double> evaluate_functional(const WaveParameters& parameters, const Moments& moments,
                                           const WindowKernel& kernel);

}  // namespace vybeg
