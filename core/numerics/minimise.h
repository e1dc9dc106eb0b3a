#pragma once

#include <algorithm>
#include <functional>
#include <utility>

namespace vybeg {

struct Minimum {
    double at = 0;
    double value = 0;
    bool at_bound = false;  // the minimum lies at the edge of [low, high], where f still decreases
};

// A local minimum of f in [low, high], downhill from `start` (low <= start <= high) with a first
// step of `step` > 0: steps outward until it is bracketed, then Brent's method. The error of `at`
// is below `tolerance` (unit of `at`), limited by the rounding of f: about step * sqrt(machine
// epsilon) for a parabola of width `step`.
Minimum minimise(const std::function<double(double)>& f, double low, double start, double high,
                 double step, double tolerance);

// The end of an interval at whose begin `holds` is true and at whose end it is false, halved to
// `width`, or 60 times.
template <class Holds>
double bisected(double low, double high, const Holds& holds, double width = 0) {
    for (int step = 0; step < 60 && high - low > width; ++step) {
        const double middle = (low + high) / 2;
        (holds(middle) ? low : high) = middle;
    }
    return high;
}

struct DampedRules {
    int steps = 0;  // at most
    double least_damping = 0;
    double most_damping = 0;  // beyond it no step lowers chi^2
};

// Levenberg's and Marquardt's steps: from `at` to the points trial(at, damping) that lower the
// member chi2, until one lowers it by less than a millionth.
template <class Point, class Trial>
void descend_damped(Point& at, const DampedRules& rules, const Trial& trial) {
    double damping = 1e-3;
    for (int step = 0; step < rules.steps && damping <= rules.most_damping; ++step) {
        Point next = trial(at, damping);
        if (!(next.chi2 < at.chi2)) {
            damping *= 10;
            continue;
        }
        const bool done = at.chi2 - next.chi2 < 1e-6 * std::max(1.0, next.chi2);
        at = std::move(next);
        damping = std::max(damping / 10, rules.least_damping);
        if (done) {
            return;
        }
    }
}

}  // namespace vybeg
