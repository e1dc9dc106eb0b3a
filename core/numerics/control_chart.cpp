#include "core/numerics/control_chart.h"

#include "core/numerics/ewma_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vybeg {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Factors of the mean moving range of two points, whose expectation is d2 = 1.128 deviations.
constexpr double limit_per_range = 2.66;         // 3 / d2, d2 = 1.128
constexpr double range_limit_per_range = 3.267;  // D4 of two

// The baseline's values and the squares of their own deviations.
struct Baseline {
    std::vector<double> values;
    std::vector<double> variances;
};

struct WeightedMean {
    double mean = 0;
    double chi2 = 0;       // of the values about it
    double effective = 0;  // number of equal values that would know it as well (L. Kish)
};

WeightedMean weighted_mean(const Baseline& baseline, double between) {
    double weights = 0;
    double squares = 0;
    double sum = 0;
    for (std::size_t k = 0; k < baseline.values.size(); ++k) {
        const double weight = 1 / (between + baseline.variances[k]);
        weights += weight;
        squares += weight * weight;
        sum += weight * baseline.values[k];
    }
    WeightedMean result{sum / weights, 0, weights * weights / squares};
    for (std::size_t k = 0; k < baseline.values.size(); ++k) {
        const double off = baseline.values[k] - result.mean;
        result.chi2 += off * off / (between + baseline.variances[k]);
    }
    return result;
}

// Variance between the results after R. C. Paule, J. Mandel (1982): the one with which the squared
// distances in units of their deviations add up to the degrees of freedom; 0 where the own
// deviations alone explain them.
double between_variance(const Baseline& baseline) {
    const auto freedom = static_cast<double>(baseline.values.size() - 1);
    double mean = 0;
    for (const double value : baseline.values) {
        mean += value / static_cast<double>(baseline.values.size());
    }
    double squares = 0;
    for (const double value : baseline.values) {
        squares += (value - mean) * (value - mean);
    }
    // At this one chi^2 is at most the degrees of freedom.
    double high = squares / freedom;
    if (!(high > 0)) {
        return 0;
    }
    double low = 0;
    const bool all_known = std::ranges::all_of(baseline.variances, [](double v) { return v > 0; });
    if (all_known && weighted_mean(baseline, 0).chi2 <= freedom) {
        return 0;
    }
    constexpr int halvings = 60;
    for (int k = 0; k < halvings; ++k) {
        const double middle = (low + high) / 2;
        (weighted_mean(baseline, middle).chi2 > freedom ? low : high) = middle;
    }
    return high;
}

double square_or_zero(double sd) {
    return std::isfinite(sd) ? sd * sd : 0;
}

Baseline baseline_of(std::span<const double> values, std::span<const double> sd, std::size_t size) {
    Baseline baseline;
    for (std::size_t k = 0; k < std::min(size, values.size()); ++k) {
        if (std::isfinite(values[k])) {
            baseline.values.push_back(values[k]);
            baseline.variances.push_back(square_or_zero(sd[k]));
        }
    }
    return baseline;
}

}  // namespace

IndividualsChart individuals_chart(std::span<const double> values, std::size_t baseline) {
    IndividualsChart chart;
    double sum = 0;
    double range_sum = 0;
    double count = 0;
    double ranges = 0;
    double before = none;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double range = std::abs(values[k] - before);
        chart.ranges.push_back(range);
        const bool is_point = std::isfinite(values[k]);
        before = is_point ? values[k] : before;
        if (k < baseline && is_point) {
            sum += values[k];
            ++count;
        }
        if (k < baseline && std::isfinite(range)) {
            range_sum += range;
            ++ranges;
        }
    }
    chart.mean_range = ranges > 0 ? range_sum / ranges : none;
    chart.centre = ranges > 0 ? sum / count : none;
    chart.low = chart.centre - limit_per_range * chart.mean_range;
    chart.high = chart.centre + limit_per_range * chart.mean_range;
    chart.range_limit = range_limit_per_range * chart.mean_range;
    for (std::size_t k = 0; k < values.size(); ++k) {
        chart.out.push_back(values[k] < chart.low || values[k] > chart.high);
        chart.range_is_out.push_back(chart.ranges[k] > chart.range_limit);
    }
    return chart;
}

EwmaChart ewma_chart(std::span<const double> values, std::span<const double> sd,
                     std::size_t baseline, const EwmaOptions& options) {
    EwmaChart chart{none, none, none, {}, {}, {}, {}};
    const Baseline known = baseline_of(values, sd, baseline);
    if (known.values.size() >= least_baseline) {
        const double between = between_variance(known);
        chart.scatter = std::sqrt(between);
        // All values alike and no deviations told: nothing to compare with.
        const bool weighs =
            between > 0 || std::ranges::all_of(known.variances, [](double v) { return v > 0; });
        if (weighs) {
            const WeightedMean mean = weighted_mean(known, between);
            chart.centre = mean.mean;
            chart.limit = ewma_limit(options.lambda, static_cast<std::size_t>(mean.effective),
                                     options.points_per_alarm);
        }
    }
    double average = 0;
    double rest = 1;  // share of the start in the average, squared
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double deviation = std::sqrt(chart.scatter * chart.scatter + square_or_zero(sd[k]));
        const double z = (values[k] - chart.centre) / deviation;
        chart.z.push_back(z);
        if (std::isfinite(z)) {
            average = options.lambda * z + (1 - options.lambda) * average;
            rest *= (1 - options.lambda) * (1 - options.lambda);
        }
        chart.average.push_back(std::isfinite(z) ? average : none);
        chart.limits.push_back(chart.limit *
                               std::sqrt(options.lambda / (2 - options.lambda) * (1 - rest)));
        chart.out.push_back(std::abs(chart.average[k]) > chart.limits[k]);
    }
    return chart;
}

std::vector<double> beside_first(std::span<const double> values, double period) {
    std::vector<double> moved(values.begin(), values.end());
    const auto first =
        std::ranges::find_if(moved, [](double value) { return std::isfinite(value); });
    if (period > 0 && first != moved.end()) {
        const double reference = *first;
        for (double& value : moved) {
            value -= period * std::round((value - reference) / period);
        }
    }
    return moved;
}

}  // namespace vybeg
