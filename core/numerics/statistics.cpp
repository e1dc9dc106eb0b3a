#include "core/numerics/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace vybeg {

double median(std::vector<double> values) {
    if (values.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Moments moments_of(std::span<const double> x) {
    Moments moments;
    moments.count = x.size();
    if (x.empty()) {
        return moments;
    }
    const auto n = static_cast<double>(x.size());
    double sum = 0;
    for (const double value : x) {
        sum += value;
    }
    moments.mean = sum / n;
    double second = 0;
    double third = 0;
    double fourth = 0;
    double farthest = 0;
    for (const double value : x) {
        const double off = value - moments.mean;
        const double square = off * off;
        second += square;
        third += square * off;
        fourth += square * square;
        farthest = std::max(farthest, std::abs(off));
    }
    moments.sd = std::sqrt(second / n);
    if (!(moments.sd > 0)) {
        return moments;
    }
    moments.largest_z = farthest / moments.sd;
    moments.expected_beyond = n * std::erfc(moments.largest_z / std::numbers::sqrt2);
    if (n < 4) {
        return moments;
    }
    moments.skewness = third / n / (moments.sd * moments.sd * moments.sd);
    moments.kurtosis = fourth / n / (moments.sd * moments.sd * moments.sd * moments.sd) - 3;
    // Of the moments above, by H. Cramer, Mathematical Methods of Statistics (1946), 29.3.
    moments.sd_skewness = std::sqrt(6 * (n - 2) / ((n + 1) * (n + 3)));
    moments.sd_kurtosis =
        std::sqrt(24 * n * (n - 2) * (n - 3) / ((n + 1) * (n + 1) * (n + 3) * (n + 5)));
    return moments;
}

Histogram histogram_of(std::span<const double> x, const Moments& moments) {
    constexpr double widest = 8;
    constexpr double most_bins = 201;
    Histogram histogram;
    if (!(moments.sd > 0)) {
        return histogram;
    }
    const double reach = std::min(moments.largest_z, widest) * (1 + 1e-9);
    const double scott = 3.49 / std::cbrt(static_cast<double>(x.size()));
    // An odd number, so that the mean lies inside a bin.
    const double half = std::floor(std::clamp(2 * reach / scott, 3.0, most_bins - 1) / 2);
    const auto bins = static_cast<std::size_t>(2 * half + 1);
    histogram.width = 2 * reach / static_cast<double>(bins);
    histogram.low = -reach;
    histogram.counts.assign(bins, 0);
    for (const double value : x) {
        const double z = (value - moments.mean) / moments.sd;
        if (z < -reach) {
            ++histogram.below;
        } else if (z > reach) {
            ++histogram.above;
        } else {
            const auto bin = static_cast<std::size_t>((z + reach) / histogram.width);
            ++histogram.counts[std::min(bin, bins - 1)];
        }
    }
    return histogram;
}

LineFit fit_line(std::span<const double> x, std::span<const double> y) {
    LineFit fit = fit_line(x.size(), [&](std::size_t k) {
        return LinePoint{x[k], y[k], std::isnan(x[k] + y[k]) ? 0.0 : 1.0};
    });
    fit.slope = fit.spread > 0 ? fit.slope : 0;
    return fit;
}

}  // namespace vybeg
