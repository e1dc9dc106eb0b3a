#include "core/resonator/runs/decay.h"

#include "core/numerics/minimise.h"
#include "core/numerics/statistics.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace vybeg {
namespace {

using Eigen::Vector3d;

constexpr std::size_t fewest_seen = 8;
constexpr double visible = 10;  // deviations
constexpr double most_power = 4;
constexpr int law_steps = 100;

struct LogAmplitude {
    std::vector<std::size_t> window;
    std::vector<double> time_s;  // from the mean instant
    std::vector<double> value;
    std::vector<double> weight;  // 1/sd
};

LogAmplitude log_amplitude(const PhasorRun& run) {
    LogAmplitude series;
    double mean = 0;
    double weights = 0;
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        const double power = run.power(k);
        const double variance = run.sd[k] * run.sd[k];
        if (!(power > visible * visible * variance)) {
            // A wave that rests leaves noise; one window alone is a fault.
            if (series.value.size() >= fewest_seen) {
                break;
            }
            continue;
        }
        series.window.push_back(k);
        series.time_s.push_back(run.time_s[k]);
        series.value.push_back(std::log(power - 4 * variance) / 2);
        series.weight.push_back(std::sqrt(power / variance));
        mean += run.time_s[k] * power / variance;
        weights += power / variance;
    }
    for (double& t : series.time_s) {
        t -= mean / weights;
    }
    return series;
}

// log a at t for (log a, rate) at t = 0 and q = 1 - p: log a = v0 + log(1 - q r t)/q, with its
// derivatives by v0, r and q. NaN after the instant of rest.
struct LawAt {
    double value = 0;
    Vector3d by;
};

LawAt law_at(const Vector3d& law, double t) {
    constexpr double small = 1e-3;
    const double turn = law[1] * t;
    const double x = law[2] * turn;
    if (std::abs(x) < small) {
        return {law[0] - turn * (1 + x / 2 + x * x / 3),
                {1, -t * (1 + x + x * x), -turn * turn * (0.5 + 2 * x / 3 + 3 * x * x / 4)}};
    }
    const double log = std::log1p(-x);
    return {law[0] + log / law[2],
            {1, -t / (1 - x), -log / (law[2] * law[2]) - turn / (law[2] * (1 - x))}};
}

double chi2_of(const LogAmplitude& series, const Vector3d& law) {
    double chi2 = 0;
    for (std::size_t k = 0; k < series.value.size(); ++k) {
        const double off =
            series.weight[k] * (series.value[k] - law_at(law, series.time_s[k]).value);
        chi2 += off * off;
    }
    return std::isfinite(chi2) ? chi2 : std::numeric_limits<double>::infinity();
}

struct Normal {
    Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
    Vector3d side = Vector3d::Zero();
};

Normal normal_of(const LogAmplitude& series, const Vector3d& law) {
    Normal normal;
    for (std::size_t k = 0; k < series.value.size(); ++k) {
        const LawAt at = law_at(law, series.time_s[k]);
        const double weight = series.weight[k] * series.weight[k];
        normal.square += weight * at.by * at.by.transpose();
        normal.side += weight * (series.value[k] - at.value) * at.by;
    }
    return normal;
}

struct TriedLaw {
    Vector3d law;
    double chi2 = 0;
};

// In v0, r and q.
Vector3d fitted(const LogAmplitude& series, const Vector3d& start) {
    TriedLaw at{start, chi2_of(series, start)};
    descend_damped(at, {law_steps, 1e-9, 1e8}, [&](const TriedLaw& from, double damping) {
        Normal normal = normal_of(series, from.law);
        normal.square.diagonal() *= 1 + damping;
        Vector3d next = from.law + normal.square.ldlt().solve(normal.side);
        next[2] = std::clamp(next[2], 1 - most_power, most_power - 1);
        return TriedLaw{next, chi2_of(series, next)};
    });
    return at.law;
}

// Factor of the variance of slow parameters.
double correlation_time(const LogAmplitude& series, const Vector3d& law) {
    std::vector<double> left;
    double power = 0;
    for (std::size_t k = 0; k < series.value.size(); ++k) {
        left.push_back(series.weight[k] * (series.value[k] - law_at(law, series.time_s[k]).value));
        power += left.back() * left.back();
    }
    return correlated_values(left.size(), power, [&left](std::size_t lag) {
        double product = 0;
        for (std::size_t k = lag; k < left.size(); ++k) {
            product += left[k] * left[k - lag];
        }
        return product;
    });
}

}  // namespace

Estimate decay_time(const Estimate& rate) {
    constexpr double given_from = 5;
    constexpr double limit = 2;
    const double per_s = rate.value;
    const double width = rate.uncertainty();
    if (per_s >= given_from * width) {
        return {1 / per_s, rate.sd / (per_s * per_s), {}, rate.u / (per_s * per_s)};
    }
    const double fastest = per_s + limit * width;
    if (fastest <= 0) {
        return {.reason = {ReasonCode::grows, {number_arg(-per_s, 3), number_arg(width, 2)}}};
    }
    const double slowest = per_s - limit * width;
    if (slowest > 0) {
        return {.reason = {ReasonCode::decay_limits,
                           {number_arg(1 / fastest, 3), number_arg(1 / slowest, 3)}}};
    }
    return {.reason = {ReasonCode::no_decay, {number_arg(1 / fastest, 3)}}};
}

double DecayLaw::scatter() const {
    return std::max(1.0, chi2 / std::max(static_cast<double>(windows) - 3, 1.0));
}

bool DecayLaw::departs() const {
    constexpr double deviations = 5;
    constexpr double most_of_it = 0.8;
    constexpr double least_fall = 25;
    const double fall = line_chi2 - chi2;
    return windows > 0 && std::abs(power - 1) > deviations * power_sd &&
           fall > least_fall * scatter() &&
           fall > most_of_it * (line_chi2 - static_cast<double>(windows));
}

QBand q_band(const DecayLaw& law, double q) {
    const auto q_at = [&](double amplitude) {
        const double rate = law.per_s * std::pow(amplitude / law.amplitude, law.power - 1);
        return q * law.line_per_s / rate;
    };
    return {law.amplitude * std::pow(law.line_per_s / law.per_s, 1 / (law.power - 1)), law.largest,
            q_at(law.largest), law.smallest, q_at(law.smallest)};
}

double log_amplitude_chi2(const PhasorRun& run, std::span<const Phasors> expected) {
    const LogAmplitude series = log_amplitude(run);
    double chi2 = 0;
    for (std::size_t k = 0; k < series.value.size(); ++k) {
        const Phasors& z = expected[series.window[k]];
        const double model = std::log(std::norm(z.c) + std::norm(z.d)) / 2;
        const double off = series.weight[k] * (series.value[k] - model);
        chi2 += off * off;
    }
    return chi2;
}

DecayLaw decay_law(const PhasorRun& run) {
    const LogAmplitude series = log_amplitude(run);
    DecayLaw found;
    if (series.value.size() < fewest_seen) {
        return found;
    }
    // The mean and the straight line; times count from the weighted mean.
    double weights = 0;
    double mean = 0;
    double spread = 0;
    double slope = 0;
    for (std::size_t k = 0; k < series.value.size(); ++k) {
        const double weight = series.weight[k] * series.weight[k];
        weights += weight;
        mean += weight * series.value[k];
        spread += weight * series.time_s[k] * series.time_s[k];
        slope += weight * series.time_s[k] * series.value[k];
    }
    mean /= weights;
    const Vector3d line(mean, -slope / spread, 0);
    const Vector3d law = fitted(series, line);
    found.windows = series.value.size();
    found.still_chi2 = chi2_of(series, {mean, 0, 0});
    found.line_chi2 = chi2_of(series, line);
    found.line_per_s = line[1];
    found.chi2 = chi2_of(series, law);
    found.power = 1 - law[2];
    found.per_s = law[1];
    found.amplitude = std::exp(law[0]);
    found.largest = std::exp(law_at(law, series.time_s.front()).value);
    found.smallest = std::exp(law_at(law, series.time_s.back()).value);
    const double widen = found.scatter() * correlation_time(series, law);
    const Eigen::Matrix3d covariance =
        widen * normal_of(series, law).square.fullPivLu().solve(Eigen::Matrix3d::Identity());
    found.per_s_sd = std::sqrt(covariance(1, 1));
    const double sd = std::sqrt(covariance(2, 2));
    found.power_sd = std::isfinite(sd) && sd > 0 ? sd : std::numeric_limits<double>::infinity();
    return found;
}

EnvelopeDecay envelope_decay(const ScaledRun& run, std::span<const Eigen::Vector2cd> expected) {
    double weights = 0;
    double mean_t = 0;
    int used = 0;
    // Both sums use the same windows and weights, so that a decay other than a straight line
    // affects both alike.
    const auto for_windows = [&](const auto& use) {
        for (std::size_t k = 0; k < run.size(); ++k) {
            const double power = run.z[k].squaredNorm();
            const double variance = 1 / (run.weight[k] * run.weight[k]);
            if (power > 100 * variance) {
                // The noise adds four variances to the power; the logarithm's variance is 4
                // variances over the power.
                use(k, power - 4 * variance, power / (4 * variance));
            }
        }
    };
    for_windows([&](std::size_t k, double, double weight) {
        weights += weight;
        mean_t += weight * run.time_s[k];
        ++used;
    });
    if (used < 3) {
        return {0, std::numeric_limits<double>::infinity(), 0};
    }
    mean_t /= weights;
    double spread = 0;
    double seen = 0;
    double fitted = 0;
    double difference = 0;  // of measured and expected logarithm
    double square = 0;
    double level = 0;  // of the measured logarithm
    double level_square = 0;
    for_windows([&](std::size_t k, double power, double weight) {
        const double t = run.time_s[k] - mean_t;
        spread += weight * t * t;
        seen += weight * t * std::log(power);
        fitted += weight * t * std::log(expected[k].squaredNorm());
        const double off = std::log(power / expected[k].squaredNorm());
        difference += weight * off;
        square += weight * off * off;
        level += weight * std::log(power);
        level_square += weight * std::log(power) * std::log(power);
    });
    // The scatter about a straight line after the prediction, because a motion other than a line
    // bends both alike, or about one without it, where the prediction is worse than none.
    const auto about_line = [&](double sum, double sum_square, double with_time) {
        return (sum_square - sum * sum / weights - with_time * with_time / spread) / (used - 2);
    };
    const double scatter = std::min(about_line(difference, square, seen - fitted),
                                    about_line(level, level_square, seen));
    return {-seen / spread / 2, 0.5 * std::sqrt(std::max(scatter, 1.0) / spread),
            -fitted / spread / 2};
}

}  // namespace vybeg
