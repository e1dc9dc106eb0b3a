#pragma once

#include <functional>

namespace vybeg {

struct Minimum {
    double at = 0;
    double value = 0;
    bool at_bound = false;  // the function still falls at the edge of [low, high]
};

// A local minimum of f in [low, high], downhill from `start` (low <= start <= high) with a first
// step of `step` > 0: steps outward until it is bracketed, then Brent's method. `at` is right
// within `tolerance` (same unit as `at`), as far as f itself can tell: about step * sqrt(machine
// epsilon) for a parabola of width `step`.
Minimum minimise(const std::function<double(double)>& f, double low, double start, double high,
                 double step, double tolerance);

}  // namespace vybeg
