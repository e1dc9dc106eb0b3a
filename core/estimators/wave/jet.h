#pragma once

#include "core/numerics/lanes.h"

namespace vybeg {

// A number with its first and second derivative by the frequency.
template <class Real>
struct Jet2 {
    Real value;
    Real slope;
    Real bend;
};

// sum_k coefficient(k) x^k.
template <std::size_t orders, class Real, class Coefficient>
VYBEG_INLINED inline Real polynomial(Real x, Coefficient coefficient) {
    Real value = coefficient(orders - 1);
    for (std::size_t k = orders - 1; k-- > 0;) {
        value = value * x + coefficient(k);
    }
    return value;
}

// The same with derivatives by x.
template <std::size_t orders, class Real, class Coefficient>
VYBEG_INLINED inline Jet2<Real> polynomial_jet(Real x, Coefficient coefficient) {
    Jet2<Real> sum{coefficient(orders - 1), Real{}, Real{}};
    for (std::size_t k = orders - 1; k-- > 0;) {
        sum.bend = sum.bend * x + sum.slope;
        sum.slope = sum.slope * x + sum.value;
        sum.value = sum.value * x + coefficient(k);
    }
    sum.bend *= 2;
    return sum;
}

template <class Real>
VYBEG_INLINED inline Jet2<Real> operator+(const Jet2<Real>& a, const Jet2<Real>& b) {
    return {a.value + b.value, a.slope + b.slope, a.bend + b.bend};
}

template <class Real>
VYBEG_INLINED inline Jet2<Real> operator-(const Jet2<Real>& a, const Jet2<Real>& b) {
    return {a.value - b.value, a.slope - b.slope, a.bend - b.bend};
}

template <class Real>
VYBEG_INLINED inline Jet2<Real> operator-(const Jet2<Real>& a) {
    return {-a.value, -a.slope, -a.bend};
}

template <class Real>
VYBEG_INLINED inline Jet2<Real> operator*(Real factor, const Jet2<Real>& a) {
    return {factor * a.value, factor * a.slope, factor * a.bend};
}

template <class Real>
VYBEG_INLINED inline Jet2<Real> operator*(const Jet2<Real>& a, const Jet2<Real>& b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope,
            a.bend * b.value + 2 * (a.slope * b.slope) + a.value * b.bend};
}

template <class Real>
VYBEG_INLINED inline Jet2<Real> square(const Jet2<Real>& a) {
    return {a.value * a.value, 2 * (a.value * a.slope), 2 * (a.slope * a.slope + a.value * a.bend)};
}

template <class Real>
VYBEG_INLINED inline Jet2<Real> reciprocal(const Jet2<Real>& a) {
    const Real value = 1 / a.value;
    const Real slope = -a.slope * value * value;
    return {value, slope, -value * (2 * (a.slope * slope) + a.bend * value)};
}

template <class Real>
VYBEG_INLINED inline Jet2<Real> square_root(const Jet2<Real>& a) {
    const Real value = sqrt_of(a.value);
    const Real half = 0.5 / value;
    const Real slope = a.slope * half;
    return {value, slope, (a.bend - 2 * (slope * slope)) * half};
}

// End of Newton's steps; the extremum lies at x + move.
template <class Real>
struct NewtonEnd {
    Real x;           // of the last evaluation
    Real move;        // to the extremum; zero in lanes that have left
    Jet2<Real> last;  // the function at x
    MaskOf<Real> arrived;

    // The function at the extremum, to the third order in `move`.
    VYBEG_INLINED Real value() const { return last.value + 0.5 * last.slope * move; }
};

struct NewtonRules {
    bool maximum = false;  // otherwise a minimum
    double last_move = 0;  // a shorter move is the last one: convergence is quadratic
    int steps = 0;         // after the first one
};

// Newton's steps on the slope of function(x), from x on, where the function is `last`. A lane
// leaves where the curvature has the wrong sign or inside(x) is false.
template <class Real, class Function, class Inside>
VYBEG_INLINED inline NewtonEnd<Real> newton(Real x, Jet2<Real> last, const NewtonRules& rules,
                                            Function function, Inside inside) {
    MaskOf<Real> good = less(Real{}, 1.0);
    for (int step = 0;; ++step) {
        Real move = -last.slope / last.bend;
        good = good & negative(rules.maximum ? last.bend : -last.bend);
        good = good & inside(x + move);
        move = select(good, move, Real{});
        const MaskOf<Real> on_the_way = good & !less(absolute(move), rules.last_move);
        if (!any(on_the_way) || step == rules.steps) {
            good = good & !on_the_way;
            return {x, move, last, good};
        }
        x += move;
        last = function(x);
    }
}

}  // namespace vybeg
