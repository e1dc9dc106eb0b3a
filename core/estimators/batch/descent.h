#pragma once

#include "core/estimators/batch/taylor_window.h"
#include "core/estimators/batch/window_estimate.h"
#include "core/estimators/wave/wave_formulas.h"

#include <array>
#include <cstddef>
#include <cstdint>

// One step of the preconditioned conjugate gradient on n F.

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
WaveFunctional<double> evaluate_functional(const WaveParameters& parameters,
                                           const WindowMoments& moments,
                                           const WindowKernel& kernel);

// Tolerance of convergence: change of the samples by a Newton-like step relative to the wave. The
// last digit of w moves the ends of a long window by more than 1e-13.
inline double descent_tolerance(double w, std::int64_t n) {
    return 1e-13 + 6e-17 * w * static_cast<double>(n);
}

// Directions restart after as many steps as there are parameters.
inline constexpr int descent_restart = 5;

template <class Real>
VYBEG_INLINED inline Real dot(const Five<Real>& a, const Five<Real>& b) {
    Real sum = a[0] * b[0];
    for (std::size_t k = 1; k < 5; ++k) {
        sum += a[k] * b[k];
    }
    return sum;
}

template <class Real>
VYBEG_INLINED inline Five<Real> times(const std::array<Five<Real>, 5>& matrix,
                                      const Five<Real>& vector) {
    Five<Real> product;
    for (std::size_t k = 0; k < 5; ++k) {
        product[k] = dot(matrix[k], vector);
    }
    return product;
}

template <class Real>
VYBEG_INLINED inline Five<Real> moved(const Five<Real>& from, const Five<Real>& direction,
                                      Real step) {
    Five<Real> to;
    for (std::size_t k = 0; k < 5; ++k) {
        to[k] = from[k] + step * direction[k];
    }
    return to;
}

// Whether a symmetric matrix is positive definite, by the pivots of its elimination.
template <class Real>
VYBEG_INLINED inline MaskOf<Real> is_positive(std::array<Five<Real>, 5> h) {
    MaskOf<Real> positive = less(Real{}, 1.0);
    for (std::size_t k = 0; k < 5; ++k) {
        positive = positive & negative(-h[k][k]);
        const Real by_pivot = 1 / h[k][k];
        for (std::size_t row = k + 1; row < 5; ++row) {
            const Real factor = h[row][k] * by_pivot;
            for (std::size_t column = k + 1; column < 5; ++column) {
                h[row][column] -= factor * h[k][column];
            }
        }
    }
    return positive;
}

// a_A^2 + a_B^2.
template <class Real>
VYBEG_INLINED inline Real power_of(const Five<Real>& at) {
    return at[0] * at[0] + at[1] * at[1];
}

// Inverse Hessian of F in an ideal window without noise: the natural scale of each parameter. The
// quadrature wave couples angle and phase; at a_A = |a_B| the coupling is total and is limited to
// just below.
template <class Real>
struct Preconditioner {
    double amplitude;
    Real same;
    Real cross;
    Real frequency;

    // `spread` is that of the window's kernel; `unit` frequency units are one radian per sample.
    VYBEG_INLINED Preconditioner(const Five<Real>& at, double n, double spread, double unit) {
        const Real power = power_of(at);
        const Real most = 0.999 * power;
        Real product = 2 * at[0] * at[1];
        product = select(less(most, product), most, product);
        product = select(less(product, -most), -most, product);
        const Real by_determinant = 1 / (power * power - product * product);
        amplitude = 1 / n;
        same = amplitude * power * by_determinant;
        cross = amplitude * product * by_determinant;
        frequency = unit * unit / (power * spread);
    }

    VYBEG_INLINED Five<Real> apply(const Five<Real>& g) const {
        return {amplitude * g[0], amplitude * g[1], same * g[2] + cross * g[3],
                cross * g[2] + same * g[3], frequency * g[4]};
    }
};

// Next direction, conjugate to the one before with respect to the present Hessian; -scaled, the
// preconditioned gradient, if the conjugate direction ascends.
template <class Real>
struct DescentWay {
    Five<Real> direction;
    Real slope;
    Real curvature;
};
template <class Real>
VYBEG_INLINED inline DescentWay<Real> next_way(const WaveFunctional<Real>& f,
                                               const Five<Real>& scaled, const Five<Real>& before) {
    constexpr double least = 1e-300;
    const Five<Real> bent = times(f.hessian, before);
    const Real curvature = dot(before, bent);
    const Real beta = select(less(least, curvature), dot(scaled, bent) / curvature, Real{});
    DescentWay<Real> way;
    for (std::size_t k = 0; k < 5; ++k) {
        way.direction[k] = beta * before[k] - scaled[k];
    }
    const MaskOf<Real> downhill = negative(dot(f.gradient, way.direction));
    for (std::size_t k = 0; k < 5; ++k) {
        way.direction[k] = select(downhill, way.direction[k], -scaled[k]);
    }
    way.slope = dot(f.gradient, way.direction);
    way.curvature = dot(way.direction, times(f.hessian, way.direction));
    return way;
}

// Excess of F over the level that a step must reach. Rounding limits F, a difference of sums of
// squares.
template <class Real>
VYBEG_INLINED inline Real excess_of(Real there, Real here, Real step, Real slope) {
    const Real rounding = 1e-14 * (absolute(here) + absolute(slope * step));
    return there - (here + 1e-4 * step * slope + rounding);
}

// The five parameters of eight windows, the frequency as x.
using BatchStart = Five<Lanes>;

// Start values of algorithm 5, (15), (18), at the reference frequency.
void in_phase_starts(const ProjectionBatch& batch, const TaylorFrame& frame, BatchStart& start);

// Algorithm 5 for eight windows: the conjugate gradient of descend() with the same
// steps; F and its derivatives come from the series of the projections. Windows whose steps leave
// the reach of the series or whose step is not the exact one do not arrive: descend() is for them.
void descend_batch(const ProjectionBatch& batch, const TaylorFrame& frame, const BatchStart& start,
                   SeriesFit<Vec8>& found);

}  // namespace vybeg
