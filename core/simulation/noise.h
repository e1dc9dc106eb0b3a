#pragma once

#include "core/simulation/free_decay.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace vybeg {

// White Gaussian noise of unit variance, two independent numbers at a time, by Marsaglia's polar
// method. std::normal_distribution differs between standard libraries.
class GaussianNoise {
public:
    explicit GaussianNoise(std::uint64_t seed) : engine_(seed) {}

    std::pair<double, double> next() {
        double x = 0;
        double y = 0;
        double square = 0;
        do {
            x = uniform();
            y = uniform();
            square = x * x + y * y;
        } while (square >= 1 || square == 0);
        const double scale = std::sqrt(-2 * std::log(square) / square);
        return {x * scale, y * scale};
    }

private:
    // Uniform in [-1, 1), from the upper 53 bits.
    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-52 - 1; }

    std::mt19937_64 engine_;
};

// A stationary complex Ornstein-Uhlenbeck process, sampled: each component has sd 1 and the
// correlation e^{-2 pi width |lag|}.
class OrnsteinUhlenbeck {
public:
    OrnsteinUhlenbeck(double width_hz, double rate_hz, std::uint64_t seed);
    std::complex<double> next();

private:
    GaussianNoise noise_;
    double kept_;
    double added_;
    std::complex<double> value_;
};

// 1/f noise: real Ornstein-Uhlenbeck processes an octave of width apart, each of variance ln 2, add
// up to the one-sided density 1/f, within 1e-5 far from both ends and half of it at the lower one.
// The value is drawn once in `stride` samples, with straight lines between.
class FlickerNoise {
public:
    // From low_hz to half of rate / stride.
    FlickerNoise(double low_hz, double rate_hz, int stride, std::uint64_t seed);
    double next();

private:
    double draw();

    GaussianNoise noise_;
    std::vector<double> kept_;
    std::vector<double> added_;
    std::vector<double> values_;
    int stride_;
    int place_ = 0;
    double from_ = 0;
    double to_ = 0;
};

// The noise of FreeDecay about the carrier. Streams of the seed, apart from the white noise's.
class CarrierNoise {
public:
    explicit CarrierNoise(const FreeDecay& decay);

    // Disturbs the phasors of a frame, frame by frame from 0 on; leaves them unchanged without
    // noise.
    void disturb(Eigen::Vector2cd& z, std::int64_t frame);

private:
    double f0_hz_;
    double rate_hz_;
    double added_sd_;
    double modulation_sd_;
    double phase_sd_;
    std::array<OrnsteinUhlenbeck, 2> added_;
    std::array<OrnsteinUhlenbeck, 2> modulation_;
    FlickerNoise phase_;
};

}  // namespace vybeg
