#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
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

// Number of values that count as one, because what a fit leaves of them is correlated: the sum of
// its autocorrelation up to its first zero, at least one. product(lag): the sum of the products of
// values so far apart; `power`: that of the squares.
template <class Product>
double correlated_values(std::size_t count, double power, const Product& product) {
    double sum = 1;
    for (std::size_t lag = 1; lag < count / 4; ++lag) {
        const double at = product(lag);
        if (!(at > 0.1 * power)) {
            break;
        }
        sum += 2 * at / power;
    }
    return sum;
}

// The straight line y = mean_y + slope (x - mean_x) of least squares.
struct LineFit {
    double mean_x = 0;
    double mean_y = 0;
    double slope = 0;   // units of y per unit of x
    double weight = 0;  // sum of the weights
    double spread = 0;  // sum of weight (x - mean_x)^2
};

struct LinePoint {
    double x = 0;
    double y = 0;
    double weight = 1;  // without one it does not count
};

// Of the points point(0) to point(count - 1).
template <class Point>
LineFit fit_line(std::size_t count, const Point& point) {
    LineFit fit;
    for (std::size_t k = 0; k < count; ++k) {
        if (const LinePoint at = point(k); at.weight > 0) {
            fit.weight += at.weight;
            fit.mean_x += at.weight * at.x;
            fit.mean_y += at.weight * at.y;
        }
    }
    fit.mean_x /= fit.weight;
    fit.mean_y /= fit.weight;
    double moment = 0;
    for (std::size_t k = 0; k < count; ++k) {
        if (const LinePoint at = point(k); at.weight > 0) {
            const double x = at.x - fit.mean_x;
            fit.spread += at.weight * x * x;
            moment += at.weight * x * (at.y - fit.mean_y);
        }
    }
    fit.slope = moment / fit.spread;
    return fit;
}

// Pairs in which x or y is NaN do not count; slope 0 where all x are the same. Precondition: equal
// lengths, at least one valid pair.
LineFit fit_line(std::span<const double> x, std::span<const double> y);

}  // namespace vybeg
