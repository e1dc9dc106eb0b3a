#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace vybeg {

// Moments of numbers that may be a sample of a normal distribution; NaN where the numbers are too
// few or all the same.
struct Moments {
    std::size_t count = 0;
    double mean = std::numeric_limits<double>::quiet_NaN();
    double sd = std::numeric_limits<double>::quiet_NaN();  // about the mean, count in the divisor
    double skewness = std::numeric_limits<double>::quiet_NaN();
    double kurtosis = std::numeric_limits<double>::quiet_NaN();  // 0 for a normal distribution
    // Standard deviations of these two for independent normal numbers.
    double sd_skewness = std::numeric_limits<double>::quiet_NaN();
    double sd_kurtosis = std::numeric_limits<double>::quiet_NaN();
    // Largest distance from the mean in units of sd, and the number of independent normal numbers
    // out of `count` that is expected to lie farther away.
    double largest_z = std::numeric_limits<double>::quiet_NaN();
    double expected_beyond = std::numeric_limits<double>::quiet_NaN();
};

Moments moments_of(std::span<const double> x);

// Counts of numbers in equal bins of (x - mean) / sd. All counts and those outside add up to the
// number of values.
struct Histogram {
    double low = 0;  // lower edge of the first bin, in units of sd
    double width = 0;
    std::vector<std::int64_t> counts;
    std::int64_t below = 0;
    std::int64_t above = 0;
};

// Symmetric about the mean and as wide as the numbers, but no wider than 8 sd to each side; the
// width of a bin follows D. W. Scott (1979), with at most 201 bins. Empty without an sd above 0.
Histogram histogram_of(std::span<const double> x, const Moments& moments);

}  // namespace vybeg
