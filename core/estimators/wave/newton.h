#pragma once

#include "core/estimators/wave/jet.h"

namespace vybeg {

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
