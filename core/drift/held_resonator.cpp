#include "core/drift/held_resonator.h"

#include "core/numerics/median.h"
#include "core/numerics/phase.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace vybeg {
namespace {

constexpr double pi = std::numbers::pi;
constexpr Eigen::Index fourth = 3;  // of log_terms

// A pair (x cos 4 axis, x sin 4 axis) with its covariance.
struct Pair {
    Eigen::Vector2d value;
    Eigen::Matrix2d covariance;

    double size() const { return value.norm(); }
    double sd_size() const { return sd_along(value / size()); }
    double sd_axis() const {
        return sd_along(Eigen::Vector2d(-value[1], value[0]) / size()) / (4 * size());
    }
    double largest_sd() const {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(covariance,
                                                                   Eigen::EigenvaluesOnly);
        return std::sqrt(eigen.eigenvalues()[1]);
    }
    // Sizes and axes as in the fit of a resonator: three and five deviations.
    bool has_size() const { return size() > 3 * largest_sd(); }
    bool has_axis() const { return size() > 5 * largest_sd(); }

private:
    double sd_along(const Eigen::Vector2d& direction) const {
        return std::sqrt(direction.dot(covariance * direction));
    }
};

Pair turned(const Pair& pair, const Eigen::Matrix2d& by) {
    return {by * pair.value, by * pair.covariance * by.transpose()};
}

Reason within(const Pair& pair, const char* unit) {
    return {ReasonCode::within_noise,
            {number_arg(pair.size() + 2 * pair.largest_sd(), 3), unit_arg(unit)}};
}

void take(const Pair& pair, const char* unit, Estimate& size, Estimate& axis) {
    size = pair.has_size() ? Estimate{pair.size(), pair.sd_size(), {}}
                           : Estimate{.reason = within(pair, unit)};
    axis = pair.has_axis()
               ? Estimate{std::atan2(pair.value[1], pair.value[0]) / 4, pair.sd_axis(), {}}
               : Estimate{.reason = within(pair, unit)};
}

// Whether the mean of an amplitude effort, by which all is divided, is above its noise.
bool drives(const EffortHarmonics& amplitude) {
    constexpr double least = 5;
    return amplitude.coefficients[0] > least * std::sqrt(amplitude.covariance(0, 0));
}

// The fourth harmonic of an effort over the mean of the amplitude effort. Of two efforts of one log
// the noise is taken as independent.
Pair relative(const EffortHarmonics& effort, const EffortHarmonics& amplitude) {
    const double mean = amplitude.coefficients[0];
    const Eigen::Vector2d harmonic = effort.coefficients.segment<2>(fourth);
    Pair pair{harmonic / mean, effort.covariance.block<2, 2>(fourth, fourth) / (mean * mean)};
    pair.covariance +=
        pair.value * pair.value.transpose() * amplitude.covariance(0, 0) / (mean * mean);
    return pair;
}

struct EffortPair {
    std::optional<Pair> pair;
    bool differ = false;  // the logs do
};

// The weighted mean of all logs that have the efforts.
EffortPair of_logs(std::span<const LogDrift> logs,
                   std::optional<EffortHarmonics> LogDrift::*effort) {
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    double square = 0;
    double freedom = -2;
    for (const LogDrift& log : logs) {
        if (log.amplitude && log.*effort && drives(*log.amplitude)) {
            const Pair pair = relative(*(log.*effort), *log.amplitude);
            const Eigen::Matrix2d weight = pair.covariance.inverse();
            information += weight;
            moment += weight * pair.value;
            square += pair.value.dot(weight * pair.value);
            freedom += 2;
        }
    }
    EffortPair found;
    if (freedom >= 0) {
        found.pair = Pair{information.inverse() * moment, information.inverse()};
        found.differ =
            freedom > 0 && chi2_deviations(std::max(square - found.pair->value.dot(moment), 0.0),
                                           freedom) > log_differs;
    }
    return found;
}

Estimate refused(ReasonCode code, std::vector<MessageArg> args = {}) {
    return Estimate{.reason = {code, std::move(args)}};
}

// tau = 2 rho/g.
Estimate tau_of(const Pair& damping, const EffortPair& effort) {
    if (!effort.pair) {
        return refused(ReasonCode::effort_missing);
    }
    if (effort.differ) {
        return refused(ReasonCode::logs_differ);
    }
    const Pair& rho = *effort.pair;
    if (!damping.has_axis() || !rho.has_axis()) {
        return refused(ReasonCode::effort_unseen);
    }
    const double apart = wrap(std::atan2(rho.value[1], rho.value[0]) -
                              std::atan2(damping.value[1], damping.value[0])) /
                         4;
    if (std::abs(apart) > log_differs * std::hypot(rho.sd_axis(), damping.sd_axis())) {
        return refused(ReasonCode::effort_axis_apart, {number_arg(std::abs(apart) * 180 / pi, 3)});
    }
    const double tau = 2 * rho.size() / damping.size();
    return {
        tau, tau * std::hypot(rho.sd_size() / rho.size(), damping.sd_size() / damping.size()), {}};
}

}  // namespace

HeldResonator held_resonator(const Eigen::Vector2d& drift, const Eigen::Matrix2d& covariance,
                             std::span<const LogDrift> logs) {
    HeldResonator found;
    // (g/4) sin 4(theta - theta_tau) has cos4 = -g/4 sin 4 theta_tau, sin4 = g/4 cos 4 theta_tau.
    Eigen::Matrix2d to_damping;
    to_damping << 0, 4, -4, 0;
    const Pair damping = turned({drift, covariance}, to_damping);
    take(damping, "1/s", found.damping_anisotropy_per_s, found.theta_tau_rad);
    found.tau_s = tau_of(damping, of_logs(logs, &LogDrift::amplitude));
    // The effort is against the growth pi split a_A sin 4(theta - theta_w) of the quadrature, in
    // units of that against the decay a_A/tau of the amplitude.
    const EffortPair effort = of_logs(logs, &LogDrift::quadrature);
    if (!effort.pair || effort.differ || !found.tau_s.given()) {
        const Reason reason = !effort.pair    ? Reason{ReasonCode::effort_missing, {}}
                              : effort.differ ? Reason{ReasonCode::logs_differ, {}}
                                              : found.tau_s.reason;
        found.split_hz.reason = found.theta_w_rad.reason = reason;
        return found;
    }
    const double per_tau = 1 / (pi * found.tau_s.value);
    Eigen::Matrix2d to_split;
    to_split << 0, -per_tau, per_tau, 0;
    const Pair split = turned(*effort.pair, to_split);
    take(split, "Hz", found.split_hz, found.theta_w_rad);
    if (found.split_hz.given()) {
        const double of_tau = found.tau_s.sd / found.tau_s.value;
        found.split_hz.sd = std::hypot(found.split_hz.sd, found.split_hz.value * of_tau);
    }
    return found;
}

}  // namespace vybeg
