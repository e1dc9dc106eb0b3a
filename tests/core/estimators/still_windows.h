#pragma once

#include "core/estimators/wave/estimator.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace vybeg::test {

constexpr double rate = 33333;
constexpr double pi = std::numbers::pi;

struct Samples {
    std::vector<double> c;
    std::vector<double> d;
};

// Windows of still waves: each of its own angle, phase, quadrature (both signs) and frequency near
// the carrier, by its equations of motion, with white noise.
inline Samples waves(std::int64_t n, std::size_t count, double f0, double off, double noise,
                     std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    std::normal_distribution<double> gauss(0, noise);
    Samples samples;
    for (std::size_t k = 0; k < count; ++k) {
        const double angle = pi * any(random);
        const double phase = pi * any(random);
        const double quadrature = 0.8 * any(random);
        const double w =
            2 * pi * f0 / rate + off * any(random) * 2 / static_cast<double>(n);  // |x| <= off
        for (std::int64_t j = 0; j < n; ++j) {
            const double tau =
                w * (static_cast<double>(j) - 0.5 * static_cast<double>(n - 1)) - phase;
            const double a = std::cos(tau);
            const double b = quadrature * std::sin(tau);
            samples.c.push_back(a * std::cos(angle) - b * std::sin(angle) + gauss(random));
            samples.d.push_back(a * std::sin(angle) + b * std::cos(angle) + gauss(random));
        }
    }
    return samples;
}

inline WindowBlock block_of(const Samples& samples, std::int64_t n) {
    return {samples.c, samples.d, 0, n, n};
}

// The first `count` windows of a block.
inline std::vector<WaveEstimate> estimates(Algorithm algorithm, const EstimatorOptions& options,
                                           const WindowBlock& block, std::size_t count) {
    std::vector<WaveEstimate> found(count);
    make_estimator(algorithm, options)->estimate(block, 0, found);
    return found;
}

}  // namespace vybeg::test
