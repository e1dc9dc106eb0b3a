#pragma once

#include "core/base/error.h"
#include "core/resonator/results/power_fit.h"
#include "core/resonator/results/resonator_parameters.h"
#include "tests/needed.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

// E, R, S, Q of decays that are integrated in small steps, and what a fit misses of their
// resonator.
namespace vybeg::test {

using Complex = std::complex<double>;
struct Resonator {
    double tau = 400;
    double split = 2e-3;
    double theta_w = 0.3;
    double g = 3e-4;
    double theta_tau = 0.7;
    double r = 1e-3;
};

struct ChannelPhasors {
    Complex c;
    Complex d;
};

inline ChannelPhasors operator+(const ChannelPhasors& a, const ChannelPhasors& b) {
    return {a.c + b.c, a.d + b.d};
}
inline ChannelPhasors operator*(double k, const ChannelPhasors& a) {
    return {k * a.c, k * a.d};
}

// dz/dt = M z of METHOD section 8.
inline ChannelPhasors rate(const Resonator& of, const ChannelPhasors& z) {
    const Complex i{0, 1};
    const Complex cos = i * std::numbers::pi * of.split * std::cos(4 * of.theta_w) -
                        of.g / 2 * std::cos(4 * of.theta_tau);
    const Complex sin = i * std::numbers::pi * of.split * std::sin(4 * of.theta_w) -
                        of.g / 2 * std::sin(4 * of.theta_tau);
    return {-1 / of.tau * z.c + cos * z.c + sin * z.d + of.r * z.d,
            -1 / of.tau * z.d + sin * z.c - cos * z.d - of.r * z.c};
}

inline ChannelPhasors stepped(const Resonator& of, const ChannelPhasors& z, double h) {
    const ChannelPhasors a = rate(of, z);
    const ChannelPhasors b = rate(of, z + h / 2 * a);
    const ChannelPhasors c = rate(of, z + h / 2 * b);
    const ChannelPhasors d = rate(of, z + h * c);
    return z + h / 6 * (a + 2 * b + 2 * c + d);
}

inline std::array<double, 4> powers(const ChannelPhasors& z) {
    const Complex cross = z.c * std::conj(z.d);
    return {std::norm(z.c) + std::norm(z.d), std::norm(z.c) - std::norm(z.d), 2 * cross.real(),
            2 * cross.imag()};
}

struct Noise {
    double power = 0;   // of each of E, R, S, Q
    double phasor = 0;  // of each real part of c and d
};

// A wave a_A = 1, a_B = 0.01 at theta, 10 rows a second, with a phase that wanders.
inline PowerRun log_of(const Resonator& of, double theta, double seconds, const Noise& noise,
                       std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const Complex i{0, 1};
    const double a_B = 0.01;
    ChannelPhasors z{std::cos(2 * theta) + i * a_B * std::sin(2 * theta),
                     std::sin(2 * theta) - i * a_B * std::cos(2 * theta)};
    PowerRun run;
    constexpr double h = 0.1;
    constexpr int parts = 4;
    for (int k = 0; k * h < seconds; ++k) {
        const ChannelPhasors seen{z.c + noise.phasor * Complex(normal(random), normal(random)),
                                  z.d + noise.phasor * Complex(normal(random), normal(random))};
        const auto [e, r, s, q] = powers(seen);
        run.time_s.push_back(k * h);
        run.e.push_back(e + noise.power * normal(random));
        run.r.push_back(r + noise.power * normal(random));
        run.s.push_back(s + noise.power * normal(random));
        run.q.push_back(q + noise.power * normal(random));
        for (int part = 0; part < parts; ++part) {
            z = stepped(of, z, h / parts);
        }
    }
    return run;
}

inline std::vector<PowerRun> set_of(const Resonator& of, int runs, double seconds,
                                    const Noise& noise, unsigned seed) {
    std::mt19937_64 random(seed);
    std::vector<PowerRun> set;
    for (int k = 0; k < runs; ++k) {
        set.push_back(log_of(of, 0.1 + k * std::numbers::pi / 8, seconds, noise, random));
    }
    return set;
}

inline FitOptions known_channels() {
    FitOptions options;
    options.tolerance[kappa_error] = 0;
    return options;
}

inline ResonatorEstimate resonator_of(const std::vector<PowerRun>& set,
                                      const FitOptions& options = known_channels()) {
    return needed(fit_powers(set, options, {})).fit.resonator;
}

// The truth under the names of the estimates.
inline std::map<std::string, double> truth_of(const Resonator& of) {
    const auto axis = [](double angle) { return std::remainder(angle, std::numbers::pi / 2); };
    return {{"split_hz", of.split},
            {"theta_w_rad", axis(of.theta_w)},
            {"tau_s", of.tau},
            {"damping_anisotropy_per_s", of.g},
            {"theta_tau_rad", axis(of.theta_tau)},
            {"angle_rate_rad_s", -of.r / 2}};
}

inline std::map<std::string, double> pulls_of(const ResonatorEstimate& found, const Resonator& of) {
    std::map<std::string, double> pulls;
    const std::map<std::string, double> truth = truth_of(of);
    for (const ResonatorParameter& parameter : resonator_parameters) {
        const Estimate& estimate = found.*parameter.member;
        if (truth.contains(parameter.name) && estimate.given()) {
            double off = estimate.value - truth.at(parameter.name);
            off = parameter.period > 0 ? std::remainder(off, parameter.period) : off;
            pulls[parameter.name] = off / estimate.sd;
        }
    }
    return pulls;
}

}  // namespace vybeg::test
