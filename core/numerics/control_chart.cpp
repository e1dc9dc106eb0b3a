#include "core/numerics/control_chart.h"

#include "core/base/guarded.h"
#include "core/numerics/minimise.h"
#include "core/numerics/phase.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

namespace vybeg {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Points for each false alarm at a stable resonator, of the three charts together and on average
// over baselines.
constexpr double family_points_per_alarm = 370;
// Shares of the false alarms. The average finds lasting changes, for which the charts are kept.
constexpr double average_share = 0.7;
constexpr double individuals_share = 0.2;
constexpr double ranges_share = 0.1;
// Alarms of the family for each alarm of its charts: one result may lie outside several of them
// (tests/statistical/test_control_charts.cpp, baselines of 10 to 100).
constexpr double alarms_apart = 0.9;

// The baseline's values and the squares of their own uncertainties.
struct Baseline {
    std::vector<double> values;
    std::vector<double> variances;
};

struct WeightedMean {
    double mean = 0;
    double chi2 = 0;       // of the values about it
    double effective = 0;  // number of equal values that would know it as well
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

// Expected square of a deviation: between + share * u^2, with which the squared distances of the
// baseline add up to its degrees of freedom.
struct Scatter {
    double between = 0;
    double share = 1;
};

double mean_of(std::span<const double> z) {
    double mean = 0;
    for (const double each : z) {
        mean += each / static_cast<double>(z.size());
    }
    return mean;
}

Scatter scatter_of(const Baseline& baseline) {
    const auto freedom = static_cast<double>(baseline.values.size() - 1);
    if (std::ranges::all_of(baseline.variances, [](double v) { return v > 0; })) {
        const double chi2 = weighted_mean(baseline, 0).chi2;
        if (chi2 <= freedom) {
            return {0, chi2 / freedom};
        }
    }
    const double mean = mean_of(baseline.values);
    double squares = 0;
    for (const double value : baseline.values) {
        squares += (value - mean) * (value - mean);
    }
    // At this one chi^2 is at most the degrees of freedom.
    const double most = squares / freedom;
    if (!(most > 0)) {
        return {0, 0};
    }
    const auto too_small = [&](double between) {
        return weighted_mean(baseline, between).chi2 > freedom;
    };
    return {bisected(0, most, too_small), 1};
}

double square_or_zero(double u) {
    return std::isfinite(u) ? u * u : 0;
}

Baseline baseline_of(std::span<const double> values, std::span<const double> u, std::size_t size) {
    Baseline baseline;
    for (std::size_t k = 0; k < std::min(size, values.size()); ++k) {
        if (std::isfinite(values[k])) {
            baseline.values.push_back(values[k]);
            baseline.variances.push_back(square_or_zero(u[k]));
        }
    }
    return baseline;
}

// Of z against the order: Student's t of its slope, with freedom z.size() - 2.
double slope_t(std::span<const double> z) {
    const auto count = static_cast<double>(z.size());
    const double mean = mean_of(z);
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (std::size_t k = 0; k < z.size(); ++k) {
        const double x = static_cast<double>(k) - (count - 1) / 2;
        xx += x * x;
        xy += x * (z[k] - mean);
        yy += (z[k] - mean) * (z[k] - mean);
    }
    const double rest = yy - xy * xy / xx;
    return std::abs(xy) / std::sqrt(xx * std::max(rest, 0.0) / (count - 2));
}

// Correlation of each z with the next in units of its deviation for independent normal numbers,
// about its expectation (P. A. P. Moran, Biometrika 35 (1948) 255-260).
double lag_deviations(std::span<const double> z) {
    const auto count = static_cast<double>(z.size());
    const double mean = mean_of(z);
    double products = 0;
    double squares = 0;
    for (std::size_t k = 0; k < z.size(); ++k) {
        products += k > 0 ? (z[k] - mean) * (z[k - 1] - mean) : 0;
        squares += (z[k] - mean) * (z[k] - mean);
    }
    const double sd = (count - 2) / (count * std::sqrt(count - 1));
    return std::abs(products / squares + 1 / count) / sd;
}

BaselineFault fault_of(std::span<const double> z) {
    if (student_beyond(slope_t(z), z.size() - 2) < baseline_level) {
        return BaselineFault::trend;
    }
    return std::erfc(lag_deviations(z) / std::numbers::sqrt2) < baseline_level
               ? BaselineFault::correlated
               : BaselineFault::none;
}

// Factors of the deviations, for a share of the alarms.
struct Factors {
    double individual = none;
    double range = none;
    double average = none;
};

Factors factors_of(std::size_t count, double lambda) {
    const double alarms = 1 / (family_points_per_alarm * alarms_apart);
    // A new value less the mean of the baseline, and the difference of two values, both in units of
    // its standard deviation, have Student's distribution.
    return {student_limit(individuals_share * alarms, count - 1) *
                std::sqrt(1 + 1 / static_cast<double>(count)),
            student_limit(ranges_share * alarms, count - 1),
            ewma_limit(lambda, count, 1 / (average_share * alarms))};
}

// Sets centre, scatter and fault; the factors of the limits, NaN where the baseline sets none.
Factors set_baseline(const Baseline& known, double lambda, Scatter& scatter,
                     ControlCharts& charts) {
    charts.used = known.values.size();
    if (charts.used < least_baseline) {
        return {};
    }
    scatter = scatter_of(known);
    if (!(scatter.between > 0 || scatter.share > 0)) {
        return {};  // all values alike: nothing to compare with
    }
    Baseline shared = known;
    for (double& variance : shared.variances) {
        variance *= scatter.share;
    }
    const WeightedMean mean = weighted_mean(shared, scatter.between);
    constexpr double rounding = 1e-6;
    charts.used = static_cast<std::size_t>(mean.effective + rounding);
    if (charts.used < least_baseline) {
        return {};
    }
    charts.centre = mean.mean;
    std::vector<double> z;
    for (std::size_t k = 0; k < shared.values.size(); ++k) {
        z.push_back((shared.values[k] - mean.mean) /
                    std::sqrt(scatter.between + shared.variances[k]));
    }
    charts.fault = fault_of(z);
    return factors_of(charts.used, lambda);
}

void add_point(ControlChart& chart, double value, double limit) {
    chart.values.push_back(value);
    chart.limits.push_back(limit);
    chart.out.push_back(std::abs(value) > limit);  // false of NaN: no value, or no limit
}

// 24 nodes give the mean run length to 1e-4 for lambda >= 0.1 (tests/core/numerics).
constexpr int nodes = 24;

struct Node {
    double x = 0;
    double weight = 0;
};

// Of Gauss and Legendre on (-1, 1), by Newton's method from Tricomi's estimate.
std::array<Node, nodes> legendre_nodes() {
    std::array<Node, nodes> all;
    for (int k = 0; k < nodes; ++k) {
        double x = std::cos(std::numbers::pi * (k + 0.75) / (nodes + 0.5));
        double slope = 0;
        for (int step = 0; step < 8; ++step) {
            double before = 1;
            double value = x;
            for (int n = 2; n <= nodes; ++n) {
                before = std::exchange(value, ((2 * n - 1) * x * value - (n - 1) * before) / n);
            }
            slope = nodes * (x * value - before) / (x * x - 1);
            x -= value / slope;
        }
        all[static_cast<std::size_t>(k)] = {x, 2 / ((1 - x * x) * slope * slope)};
    }
    return all;
}

double normal_density(double z) {
    return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
}

// Averages over a normal number: Gauss and Hermite, seven nodes (Abramowitz, Stegun, table 25.10).
constexpr std::array<Node, 7> hermite{{{-3.750439717725742, 0.000548268855972217},
                                       {-2.366759410734541, 0.030757123967586},
                                       {-1.154405394739968, 0.240123178605013},
                                       {0, 0.457142857142857},
                                       {1.154405394739968, 0.240123178605013},
                                       {2.366759410734541, 0.030757123967586},
                                       {3.750439717725742, 0.000548268855972217}}};

// False alarms per point with centre and standard deviation of a baseline of `count` numbers.
double alarm_rate(double lambda, double limit, double count) {
    double rate = 0;
    const double freedom = count - 1;
    for (const Node& scatter : hermite) {
        // Quantiles of chi^2 after E. B. Wilson, M. M. Hilferty (1931).
        const double part = 2 / (9 * freedom);
        const double sd = std::pow(1 - part + scatter.x * std::sqrt(part), 1.5);
        for (const Node& centre : hermite) {
            if (centre.x < 0) {
                continue;  // as its counterpart
            }
            const double both = centre.x > 0 ? 2 : 1;
            const double shift = centre.x / std::sqrt(count) / sd;
            rate += both * scatter.weight * centre.weight /
                    ewma_run_length(lambda, limit, shift, 1 / sd);
        }
    }
    return rate;
}

}  // namespace

double student_beyond(double t, std::size_t freedom) {
    const double angle = std::atan(t / std::sqrt(static_cast<double>(freedom)));
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    const bool odd = freedom % 2 == 1;
    double sum = 0;
    double term = odd ? cosine : 1;
    // Of an odd number cos + 2/3 cos^3 + ..., of an even one 1 + 1/2 cos^2 + ...
    for (std::size_t k = odd ? 1 : 0; k + 2 <= freedom; k += 2) {
        sum += term;
        const auto step = static_cast<double>(k);
        term *= cosine * cosine * (step + 1) / (step + 2);
    }
    return 1 - (odd ? 2 / std::numbers::pi * (angle + sine * sum) : sine * sum);
}

double student_limit(double beyond, std::size_t freedom) {
    double low = 0;
    double high = 1;
    while (student_beyond(high, freedom) > beyond) {
        high *= 2;
    }
    while (high - low > 1e-9 * high) {
        const double middle = (low + high) / 2;
        (student_beyond(middle, freedom) > beyond ? low : high) = middle;
    }
    return high;
}

ControlCharts control_charts(std::span<const double> values, std::span<const double> u,
                             std::size_t baseline, double lambda) {
    ControlCharts charts;
    Scatter scatter{none, none};
    const Factors factors = set_baseline(baseline_of(values, u, baseline), lambda, scatter, charts);
    double average = 0;
    double rest = 1;  // share of the start in the average, squared
    double before = none;
    double deviation_before = none;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double deviation = std::sqrt(scatter.between + scatter.share * square_or_zero(u[k]));
        const double off = values[k] - charts.centre;
        charts.deviations.push_back(deviation);
        add_point(charts.individuals, off, factors.individual * deviation);
        add_point(charts.ranges, std::abs(values[k] - before),
                  factors.range * std::hypot(deviation, deviation_before));
        const double z = off / deviation;
        if (std::isfinite(z)) {
            average = lambda * z + (1 - lambda) * average;
            rest *= (1 - lambda) * (1 - lambda);
        }
        add_point(charts.average, std::isfinite(z) ? average : none,
                  factors.average * std::sqrt(lambda / (2 - lambda) * (1 - rest)));
        if (std::isfinite(values[k])) {
            before = values[k];
            deviation_before = deviation;
        }
    }
    return charts;
}

std::vector<double> beside_first(std::span<const double> values, double period) {
    std::vector<double> moved(values.begin(), values.end());
    const auto first =
        std::ranges::find_if(moved, [](double value) { return std::isfinite(value); });
    if (period > 0 && first != moved.end()) {
        const double reference = *first;
        for (double& value : moved) {
            value = nearest_branch(value, reference, period);
        }
    }
    return moved;
}

double ewma_run_length(double lambda, double limit, double shift, double sd) {
    static const std::array<Node, nodes> legendre = legendre_nodes();
    const double edge = limit * std::sqrt(lambda / (2 - lambda));
    const double width = lambda * sd;
    Eigen::Matrix<double, nodes, nodes> equations;
    Eigen::Matrix<double, nodes, 1> first;
    for (int to = 0; to < nodes; ++to) {
        const auto& [x, weight] = legendre[static_cast<std::size_t>(to)];
        const double mean = lambda * shift;
        first(to) = edge * weight * normal_density((edge * x - mean) / width) / width;
        for (int from = 0; from < nodes; ++from) {
            const double rest = (1 - lambda) * edge * legendre[static_cast<std::size_t>(from)].x;
            equations(from, to) =
                (from == to ? 1 : 0) -
                edge * weight * normal_density((edge * x - rest - mean) / width) / width;
        }
    }
    const Eigen::Matrix<double, nodes, 1> lengths =
        equations.partialPivLu().solve(Eigen::Matrix<double, nodes, 1>::Ones());
    return 1 + first.dot(lengths);
}

double ewma_limit(double lambda, std::size_t baseline, double points_per_alarm) {
    if (baseline < least_baseline) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    // Charts of many quantities have the same baseline, and a limit takes milliseconds.
    static const Guarded<std::map<std::tuple<double, std::size_t, double>, double>> known;
    const std::tuple key(lambda, baseline, points_per_alarm);
    if (const auto all = known.hold(); all->contains(key)) {
        return all->at(key);
    }
    // The logarithm of the rate falls almost as a parabola: bisection to 1e-3 of a deviation.
    const auto alarms_too_often = [&](double limit) {
        return alarm_rate(lambda, limit, static_cast<double>(baseline)) * points_per_alarm > 1;
    };
    const double limit = bisected(1, 8, alarms_too_often, 1e-3);
    return known.hold()->try_emplace(key, limit).first->second;
}

}  // namespace vybeg
