#pragma once

#include "core/estimators/batch/wave_functional.h"

#include <cstdint>

// One step of the preconditioned conjugate gradient on n F.

namespace vybeg {

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

}  // namespace vybeg
