#pragma once

#include "core/resonator/results/resonator_fit.h"
#include "tests/core/resonator/simulated_phasors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace vybeg::test {

// A random resonator and the runs recorded of it: the trial of the fit, white noise and an exact
// model. One, two or four runs of 8 to 57 s, 45 degrees of 2 theta_A apart.
struct RandomSet {
    FreeDecay resonator;          // that of all runs
    std::vector<FreeDecay> each;  // with each run's start
    std::vector<double> f_offset_hz;
    std::vector<PhasorRun> runs;
};

inline RandomSet random_set(std::uint64_t seed) {
    using std::numbers::pi;
    std::mt19937_64 random(seed);
    // The standard's distributions differ between libraries: this one does not.
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    const auto one_of = [&](std::initializer_list<double> list) {
        return list.begin()[random() % list.size()];
    };
    RandomSet set;
    FreeDecay& gyro = set.resonator;
    const auto count = static_cast<std::size_t>(one_of({1, 2, 4}));
    gyro.seconds = uniform(8, 57);
    gyro.tau_s = std::pow(10, uniform(1, 3.6));
    gyro.split_hz = std::pow(10, uniform(-7, 0));
    gyro.damping_anisotropy_per_s = uniform(0, 0.2) / gyro.tau_s;
    gyro.theta_w = uniform(-pi, pi) / 4;
    gyro.theta_tau = uniform(-pi, pi) / 4;
    const double rotation = one_of({0, 4e-5, uniform(-0.2, 0.2)});
    gyro.omega_rad_s = rotation / (2 * gyro.bryan);
    gyro.kappa = uniform(0.99, 1.01);
    // Short enough for Simpson's rule: a tenth of a radian of beat, rotation and offset.
    const double windows = std::max(200.0, gyro.seconds * 60 * (gyro.split_hz + 0.4));
    const auto window = static_cast<std::int64_t>(gyro.seconds * gyro.rate_hz / windows);
    gyro.noise = std::pow(10, -uniform(40, 80) / 20);
    const double quadrature = one_of({0, 0.01, 0.3});
    const double first = uniform(-3, 3);
    for (std::size_t k = 0; k < count; ++k) {
        FreeDecay run = gyro;
        run.a_B = quadrature * uniform(-1, 1);
        run.two_theta_A = first + static_cast<double>(k) * pi / 4;
        run.alpha = uniform(-3, 3);
        set.f_offset_hz.push_back(uniform(-0.3, 0.3));
        set.runs.push_back(simulated_phasors(run, window, seed * 16 + k, set.f_offset_hz.back()));
        set.each.push_back(run);
    }
    return set;
}

}  // namespace vybeg::test
