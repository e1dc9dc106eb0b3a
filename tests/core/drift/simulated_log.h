#pragma once

#include "core/drift/whole_angle_log.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <string>
#include <vector>

// A whole-angle loop: a wave of held amplitude that turns as its drift says, and the efforts that
// hold it. It integrates the equation of motion in small steps and shares no formula with the fit.
namespace vybeg::test {

struct HeldLoop {
    double seconds = 600;
    double rate_hz = 10;
    double start = 0.1;  // rad
    double turn = 0.05;  // rad/s
    // Of the rate, rad/s.
    double c2 = 0;
    double s2 = 0;
    double c4 = 0;
    double s4 = 0;
    double kappa = 1;      // gain of D over that of C
    double skew = 0;       // of their electrodes, rad
    double white = 0;      // sd of each angle, rad
    double walk = 0;       // rad per root second
    double slow = 0;       // sd of a noise of the angle, rad
    double slow_s = 1;     // its correlation time
    double slow_rate = 0;  // sd of a noise of the rate, rad/s, with the same correlation time
    double tau_s = 400;
    double split_hz = 1e-3;
    double theta_w = 0.2;
    double gain = 5;          // of both efforts
    double effort_noise = 0;  // sd of each, relative to the mean amplitude effort
    unsigned seed = 1;
};

// g and theta_tau follow from the fourth harmonic of the drift: (g/4) sin 4(theta - theta_tau).
inline WholeAngleLog simulated_log(const HeldLoop& loop, const std::string& name = "log") {
    std::mt19937_64 random(loop.seed);
    std::normal_distribution<double> normal;
    const auto count = static_cast<std::size_t>(loop.seconds * loop.rate_hz);
    const double h = 1 / loop.rate_hz;
    // Short enough for rows that are far apart.
    const int parts = std::max(20, static_cast<int>(std::abs(loop.turn) * h / 1e-3));
    const auto rate = [&loop](double theta) {
        return loop.turn + loop.c2 * std::cos(2 * theta) + loop.s2 * std::sin(2 * theta) +
               loop.c4 * std::cos(4 * theta) + loop.s4 * std::sin(4 * theta);
    };
    const double g_cos = 4 * loop.s4;
    const double g_sin = -4 * loop.c4;
    const double keeps = std::exp(-h / loop.slow_s);
    const double renews = std::sqrt(1 - keeps * keeps);
    WholeAngleLog log;
    log.name = name;
    double theta = loop.start;
    double slow = loop.slow * normal(random);
    double slow_rate = loop.slow_rate * normal(random);
    for (std::size_t k = 0; k < count; ++k) {
        log.time_s.push_back(static_cast<double>(k) * h);
        const double seen =
            std::atan2(loop.kappa * std::sin(2 * theta + loop.skew), std::cos(2 * theta));
        const double error = std::remainder(seen - 2 * theta, 2 * std::numbers::pi) / 2;
        log.theta.push_back(theta + error + slow + loop.white * normal(random));
        const double decay =
            1 / loop.tau_s + 0.5 * (g_cos * std::cos(4 * theta) + g_sin * std::sin(4 * theta));
        const double growth =
            std::numbers::pi * loop.split_hz * std::sin(4 * (theta - loop.theta_w));
        const double noise = loop.effort_noise / loop.tau_s;
        log.amplitude_effort.push_back(loop.gain * (decay + noise * normal(random)));
        log.quadrature_effort.push_back(loop.gain * (-growth + noise * normal(random)));
        for (int part = 0; part < parts; ++part) {
            const double step = h / parts;
            const double middle = theta + 0.5 * step * rate(theta);
            theta += step * (rate(middle) + slow_rate);
        }
        theta += loop.walk * std::sqrt(h) * normal(random);
        slow = keeps * slow + loop.slow * renews * normal(random);
        slow_rate = keeps * slow_rate + loop.slow_rate * renews * normal(random);
    }
    return log;
}

// A loop whose turn becomes another one half way.
inline WholeAngleLog simulated_log_with_turn(HeldLoop loop, double turn_then) {
    loop.seconds /= 2;
    WholeAngleLog log = simulated_log(loop);
    loop.turn = turn_then;
    loop.start = log.theta.back() + turn_then / loop.rate_hz;
    ++loop.seed;
    const WholeAngleLog then = simulated_log(loop);
    for (std::size_t k = 0; k < then.time_s.size(); ++k) {
        log.time_s.push_back(loop.seconds + then.time_s[k]);
        log.theta.push_back(then.theta[k]);
    }
    log.amplitude_effort.clear();
    log.quadrature_effort.clear();
    return log;
}

// As a controller writes it that knows its angle up to whole periods.
inline WholeAngleLog wrapped(WholeAngleLog log, double period) {
    for (double& theta : log.theta) {
        theta -= period * std::floor(theta / period);
    }
    return log;
}

}  // namespace vybeg::test
