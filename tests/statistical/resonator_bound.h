#pragma once

#include "core/simulation/decay_motion.h"

#include <Eigen/LU>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace vybeg::test {

// The Cramer-Rao bound of a set of runs without damping anisotropy, from differences of the
// simulator's own motion: it shares no derivative with the fit. Unknown are the split (both
// components), the anisotropy (both), rotation and decay of the resonator, and of each run its
// frequency and four numbers of its start.
struct ResonatorBound {
    double sd_split_cos_hz = 0;
    double sd_split_sin_hz = 0;
    double sd_decay_per_s = 0;
};

// `angles` in degrees; every run is `decay` otherwise, which has no anisotropy.
inline ResonatorBound resonator_bound(const FreeDecay& decay, const std::vector<double>& angles) {
    using std::numbers::pi;
    constexpr int instants = 400;
    const double split_cos = decay.split_hz * std::cos(4 * decay.theta_w);
    const double split_sin = decay.split_hz * std::sin(4 * decay.theta_w);
    const auto runs = static_cast<int>(angles.size());
    const int count = 6 + 5 * runs;

    // Phasors of one run at an instant, parameter p moved by `step`.
    const auto phasors = [&](int run, int p, double step) {
        FreeDecay moved = decay;
        moved.two_theta_A = 2 * angles[static_cast<std::size_t>(run)] * pi / 180;
        const double by_cos = p == 0 ? step : 0;
        const double by_sin = p == 1 ? step : 0;
        moved.split_hz = std::hypot(split_cos + by_cos, split_sin + by_sin);
        moved.theta_w = std::atan2(split_sin + by_sin, split_cos + by_cos) / 4;
        if (p == 2 || p == 3) {
            // A negative anisotropy is a positive one across.
            moved.damping_anisotropy_per_s = std::abs(step);
            moved.theta_tau = (p == 3 ? pi / 8 : 0) + (step < 0 ? pi / 4 : 0);
        }
        moved.omega_rad_s += p == 4 ? step : 0;
        moved.tau_s = 1 / (1 / decay.tau_s + (p == 5 ? step : 0));
        const int own = p - 6 - 5 * run;
        const SlowMotion motion(moved);
        Eigen::Vector2cd start = motion.at_frame(0);
        if (own >= 1 && own <= 4) {
            start[(own - 1) / 2] +=
                (own % 2 == 1 ? std::complex(step, 0.0) : std::complex(0.0, step));
        }
        Eigen::VectorXd values(4 * instants);
        for (int k = 0; k < instants; ++k) {
            const double t = decay.seconds * (k + 0.5) / instants;
            Eigen::Vector2cd z = motion.propagator(t) * start;
            z *= std::polar(1.0, own == 0 ? 2 * pi * step * t : 0);
            values.segment<4>(4 * k) << z[0].real(), z[0].imag(), z[1].real(), z[1].imag();
        }
        return values;
    };

    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(count, count);
    for (int run = 0; run < runs; ++run) {
        Eigen::MatrixXd by = Eigen::MatrixXd::Zero(4 * instants, count);
        for (int p = 0; p < count; ++p) {
            if (p < 6 || (p - 6) / 5 == run) {
                constexpr double step = 1e-5;
                by.col(p) = (phasors(run, p, step) - phasors(run, p, -step)) / (2 * step);
            }
        }
        information += by.transpose() * by;
    }
    // Each instant stands for seconds * rate / instants samples; a component of a phasor from n
    // samples has variance 2 sigma^2/n.
    const double samples = decay.seconds * decay.rate_hz / instants;
    information *= samples / (2 * decay.noise * decay.noise);
    const Eigen::MatrixXd covariance = information.inverse();
    return {std::sqrt(covariance(0, 0)), std::sqrt(covariance(1, 1)), std::sqrt(covariance(5, 5))};
}

}  // namespace vybeg::test
