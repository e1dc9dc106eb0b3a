#pragma once

#include <functional>

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

}  // namespace vybeg
