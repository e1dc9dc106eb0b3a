#include "core/drift/held_resonator.h"

#include "core/numerics/phase.h"
#include "core/numerics/statistics.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace vybeg {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double axis_needs = 5;                               // deviations of its pair
constexpr double any_axis_rad = pi / 4 / std::numbers::sqrt3;  // sd of any angle within 90 degrees

// A pair (x cos 4 axis, x sin 4 axis) with the covariance of its noise and that for u.
struct Pair {
    Eigen::Vector2d value;
    Eigen::Matrix2d covariance;
    Eigen::Matrix2d wide = covariance;

    double size() const { return value.norm(); }
    double sd_size() const { return sd_along(value / size(), covariance); }
    double u_size() const { return sd_along(value / size(), wide); }
    double sd_axis() const { return sd_along(across(), covariance) / (4 * size()); }
    // Errors as large as the pair leave any axis.
    double u_axis() const {
        return std::min(sd_along(across(), wide) / (4 * size()),
                        std::hypot(sd_axis(), any_axis_rad));
    }
    double largest_sd() const { return largest(covariance); }
    double largest_u() const { return largest(wide); }
    // Sizes and axes as in the fit of a resonator: three and five deviations.
    bool has_size() const { return size() > 3 * largest_sd(); }
    bool has_axis() const { return size() > axis_needs * largest_sd(); }

private:
    static double largest(const Eigen::Matrix2d& covariance) {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(covariance,
                                                                   Eigen::EigenvaluesOnly);
        return std::sqrt(eigen.eigenvalues()[1]);
    }
    Eigen::Vector2d across() const { return Eigen::Vector2d(-value[1], value[0]) / size(); }
    static double sd_along(const Eigen::Vector2d& direction, const Eigen::Matrix2d& covariance) {
        return std::sqrt(direction.dot(covariance * direction));
    }
};

Pair turned(const Pair& pair, const Eigen::Matrix2d& by) {
    return {by * pair.value, by * pair.covariance * by.transpose(),
            by * pair.wide * by.transpose()};
}

Reason within(const Pair& pair, const char* unit) {
    return {ReasonCode::within_noise,
            {number_arg(pair.size() + 2 * pair.largest_u(), 3), unit_arg(unit)}};
}

void take(const Pair& pair, const char* unit, Estimate& size, Estimate& axis) {
    size = pair.has_size() ? Estimate{pair.size(), pair.sd_size(), {}, pair.u_size()}
                           : Estimate{.reason = within(pair, unit)};
    axis = pair.has_axis() ? Estimate{std::atan2(pair.value[1], pair.value[0]) / 4,
                                      pair.sd_axis(),
                                      {},
                                      pair.u_axis()}
                           : Estimate{.reason = within(pair, unit)};
}

// Whether the mean of an amplitude effort, by which all is divided, has this sign beyond its noise.
bool drives(const ColouredFit& amplitude, int sign) {
    constexpr double least = 5;
    return sign * amplitude.coefficients[0] > least * std::sqrt(amplitude.covariance(0, 0));
}

// The fourth harmonic of an effort over the mean of the amplitude effort. Of two efforts of one log
// the noise is taken as independent.
Pair relative(const ColouredFit& effort, const ColouredFit& amplitude) {
    const double mean = amplitude.coefficients[0];
    const Eigen::Vector2d harmonic = effort.coefficients.segment<2>(fourth);
    const Eigen::Vector2d value = harmonic / mean;
    const Eigen::Matrix2d covariance = (effort.covariance.block<2, 2>(fourth, fourth) +
                                        value * value.transpose() * amplitude.covariance(0, 0)) /
                                       (mean * mean);
    return {value, covariance};
}

struct EffortPair {
    std::optional<Pair> pair;
    Reason reason = {ReasonCode::effort_missing, {}};  // without a pair, or of logs that differ
};

// The weighted mean of all logs that have the efforts.
EffortPair of_logs(std::span<const LogDrift* const> logs,
                   std::optional<ColouredFit> LogDrift::*effort) {
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    double square = 0;
    double freedom = -2;
    EffortPair found;
    for (const LogDrift* log : logs) {
        if (!log->amplitude || !(log->*effort)) {
            continue;
        }
        if (drives(*log->amplitude, -1)) {
            return {std::nullopt, {ReasonCode::effort_negative, {}}};
        }
        if (drives(*log->amplitude, 1)) {
            const Pair pair = relative(*(log->*effort), *log->amplitude);
            const Eigen::Matrix2d weight = pair.covariance.inverse();
            information += weight;
            moment += weight * pair.value;
            square += pair.value.dot(weight * pair.value);
            freedom += 2;
        }
    }
    if (freedom >= 0) {
        const Eigen::Vector2d mean = information.inverse() * moment;
        const bool differ = freedom > 0 && chi2_deviations(std::max(square - mean.dot(moment), 0.0),
                                                           freedom) > log_differs;
        found.reason = {ReasonCode::logs_differ, {}};
        if (!differ) {
            found.pair = Pair{mean, information.inverse()};
        }
    }
    return found;
}

Estimate refused(ReasonCode code, std::vector<MessageArg> args = {}) {
    return Estimate{.reason = {code, std::move(args)}};
}

// Angle between the axes of damping by the drift and by the effort, rad of 4 theta; zero within
// their noise.
double axes_apart(const Pair& damping, const Pair& rho) {
    const double apart = std::abs(wrap(std::atan2(rho.value[1], rho.value[0]) -
                                       std::atan2(damping.value[1], damping.value[0])));
    return apart > 4 * log_differs * std::hypot(rho.sd_axis(), damping.sd_axis()) ? apart : 0;
}

// tau = 2 rho/g. An error of the channels moves both alike: the controller holds an amplitude that
// it sees too large at some angles, and its effort pays for the change.
Estimate tau_of(const Pair& damping, const EffortPair& effort) {
    if (!effort.pair) {
        return Estimate{.reason = effort.reason};
    }
    const Pair& rho = *effort.pair;
    if (!damping.has_axis() || !rho.has_axis()) {
        return refused(ReasonCode::effort_unseen);
    }
    // Of a harmonic what moves it across, as the latency of an effort does, may move it along: u of
    // tau holds it while it is small.
    constexpr double small = 0.02;
    const double apart = axes_apart(damping, rho);
    if (apart > small) {
        return refused(ReasonCode::effort_axis_apart, {number_arg(apart / 4 * 180 / pi, 3)});
    }
    const double tau = 2 * rho.size() / damping.size();
    const double sd =
        tau * std::hypot(rho.sd_size() / rho.size(), damping.sd_size() / damping.size());
    return {tau, sd, {}, std::hypot(sd, tau * apart)};
}

}  // namespace

HeldResonator held_resonator(const Eigen::Vector2d& drift, const Eigen::Matrix2d& of_noise,
                             const Eigen::Matrix2d& with_channels,
                             std::span<const LogDrift* const> logs) {
    HeldResonator found;
    // (g/4) sin 4(theta - theta_tau) has cos4 = -g/4 sin 4 theta_tau, sin4 = g/4 cos 4 theta_tau.
    Eigen::Matrix2d to_damping;
    to_damping << 0, 4, -4, 0;
    const Pair damping = turned({drift, of_noise, with_channels}, to_damping);
    take(damping, "1/s", found.damping_anisotropy_per_s, found.theta_tau_rad);
    const EffortPair damped = of_logs(logs, &LogDrift::amplitude);
    found.tau_s = tau_of(damping, damped);
    // The effort is against the growth pi split a_A sin 4(theta - theta_w) of the quadrature, in
    // units of that against the decay a_A/tau of the amplitude.
    const EffortPair effort = of_logs(logs, &LogDrift::quadrature);
    if (!effort.pair || !found.tau_s.given()) {
        const Reason reason = effort.pair ? found.tau_s.reason : effort.reason;
        found.split_hz.reason = found.theta_w_rad.reason = reason;
        return found;
    }
    const double per_tau = 1 / (pi * found.tau_s.value);
    Eigen::Matrix2d to_split;
    to_split << 0, -per_tau, per_tau, 0;
    const Pair split = turned(*effort.pair, to_split);
    take(split, "Hz", found.split_hz, found.theta_w_rad);
    if (found.theta_w_rad.given()) {  // a late effort turns both axes
        found.theta_w_rad.u =
            std::hypot(found.theta_w_rad.u, axes_apart(damping, *damped.pair) / 4);
    }
    if (found.split_hz.given()) {
        const double by_tau = found.split_hz.value / found.tau_s.value;
        found.split_hz.u = std::hypot(found.split_hz.sd, by_tau * found.tau_s.u);
        found.split_hz.sd = std::hypot(found.split_hz.sd, by_tau * found.tau_s.sd);
    }
    return found;
}

}  // namespace vybeg
