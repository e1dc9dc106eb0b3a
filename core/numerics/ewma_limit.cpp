#include "core/numerics/ewma_limit.h"

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

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
    // The logarithm of the rate falls almost as a parabola: bisection to 1e-3 of a deviation.
    double low = 1;
    double high = 8;
    while (high - low > 1e-3) {
        const double middle = (low + high) / 2;
        const double rate = alarm_rate(lambda, middle, static_cast<double>(baseline));
        (rate * points_per_alarm > 1 ? low : high) = middle;
    }
    return high;
}

}  // namespace vybeg
