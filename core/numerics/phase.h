#pragma once

#include <cmath>
#include <numbers>

namespace vybeg {

// The angle in (-pi, pi] that differs from `angle` by whole turns. NaN stays NaN.
inline double wrap(double angle) {
    const double wrapped = std::remainder(angle, 2 * std::numbers::pi);
    return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

// The number of the form value + k period, k whole, nearest to `reference`.
inline double nearest_branch(double value, double reference, double period) {
    return value + period * std::round((reference - value) / period);
}

}  // namespace vybeg
