#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <span>

namespace vybeg {

// Functions common to the searches for the carrier.

// Length with zero padding of at least half the length, so that the parabola through the logarithms
// of a peak is accurate: the next power of two, or three times one.
inline std::size_t padded_length(std::size_t length) {
    const std::size_t least = std::max<std::size_t>(length + length / 2, 1024);
    const std::size_t power = std::bit_ceil(least);
    return power / 4 * 3 >= least ? power / 4 * 3 : power;
}

// Position of a peak of the power spectrum between its neighbours, in bins: vertex of the parabola
// through the logarithms.
inline double peak_shift(double left, double here, double right) {
    const double below = std::log(left);
    const double above = std::log(right);
    const double curvature = below - 2 * std::log(here) + above;
    // At the edge of a band the largest bin need not be a peak.
    return curvature < 0 ? std::clamp(0.5 * (below - above) / curvature, -0.5, 0.5) : 0;
}

inline double mean_of_finite(std::span<const double> x) {
    double sum = 0;
    double count = 0;
    for (const double value : x) {
        if (std::isfinite(value)) {
            sum += value;
            count += 1;
        }
    }
    return count > 0 ? sum / count : std::nan("");
}

}  // namespace vybeg
