#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace vybeg {

// The value in the middle by size, of an even number of values the larger of the two in the middle;
// NaN of none.
double median(std::vector<double> values);

// Chi^2 over its mean, the degrees of freedom, at a normal deviate; at 0 the median (E. B. Wilson
// and M. M. Hilferty, 1931).
inline double chi2_ratio(double deviations, double freedom) {
    const double variance = 2 / (9 * freedom);
    return std::pow(std::max(1 - variance + deviations * std::sqrt(variance), 0.1), 3);
}

// The normal deviate of chi^2, the inverse of chi2_ratio().
inline double chi2_deviations(double chi2, double freedom) {
    const double variance = 2 / (9 * freedom);
    return (std::cbrt(chi2 / freedom) - 1 + variance) / std::sqrt(variance);
}

}  // namespace vybeg
