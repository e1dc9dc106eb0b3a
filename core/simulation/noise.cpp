#include "core/simulation/noise.h"

#include "core/simulation/decay_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

using std::numbers::pi;

// Seed of a stream separate from the white noise's, by the finaliser of splitmix64: neighbouring
// seeds yield unrelated streams.
std::uint64_t stream_seed(std::uint64_t seed, std::uint64_t stream) {
    std::uint64_t x = seed + stream * 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}

double correlation(double width_hz, double rate_hz) {
    return std::exp(-2 * pi * width_hz / rate_hz);
}

// sd of the increment of a step: sqrt(1 - correlation^2), without loss of digits in slow processes.
double innovation(double width_hz, double rate_hz) {
    return std::sqrt(-std::expm1(-4 * pi * width_hz / rate_hz));
}

OrnsteinUhlenbeck about_carrier(const FreeDecay& decay, std::uint64_t stream) {
    return {decay.carrier_noise_width_hz, decay.rate_hz, stream_seed(decay.seed, stream)};
}

// Samples between two draws of the phase: about a period of the carrier.
int phase_stride(const FreeDecay& decay) {
    return static_cast<int>(std::clamp(decay.rate_hz / decay.f0_hz, 1.0, 1e6));
}

}  // namespace

OrnsteinUhlenbeck::OrnsteinUhlenbeck(double width_hz, double rate_hz, std::uint64_t seed)
    : noise_(seed), kept_(correlation(width_hz, rate_hz)), added_(innovation(width_hz, rate_hz)) {
    const auto [re, im] = noise_.next();
    value_ = {re, im};
}

std::complex<double> OrnsteinUhlenbeck::next() {
    const std::complex<double> now = value_;
    const auto [re, im] = noise_.next();
    value_ = kept_ * value_ + added_ * std::complex<double>{re, im};
    return now;
}

FlickerNoise::FlickerNoise(double low_hz, double rate_hz, int stride, std::uint64_t seed)
    : noise_(seed), stride_(stride) {
    const double draws_hz = rate_hz / stride;
    const auto add_process = [&](double width) {
        kept_.push_back(correlation(width, draws_hz));
        added_.push_back(innovation(width, draws_hz) * std::sqrt(std::numbers::ln2));
    };
    for (double width = low_hz; kept_.empty() || width <= draws_hz / 2; width *= 2) {
        add_process(width);
    }
    if (kept_.size() % 2 == 1) {  // Gaussian numbers come in pairs: one more octave below
        add_process(low_hz / 2);
    }
    values_.resize(kept_.size());
    for (std::size_t i = 0; i < values_.size(); i += 2) {
        const auto [a, b] = noise_.next();
        values_[i] = a * std::sqrt(std::numbers::ln2);
        values_[i + 1] = b * std::sqrt(std::numbers::ln2);
    }
    to_ = draw();
}

double FlickerNoise::draw() {
    double sum = 0;
    for (std::size_t i = 0; i < values_.size(); i += 2) {
        const auto [a, b] = noise_.next();
        values_[i] = kept_[i] * values_[i] + added_[i] * a;
        values_[i + 1] = kept_[i + 1] * values_[i + 1] + added_[i + 1] * b;
        sum += values_[i] + values_[i + 1];
    }
    return sum;
}

double FlickerNoise::next() {
    if (place_ == 0) {
        from_ = to_;
        to_ = draw();
    }
    const double now = from_ + (to_ - from_) * place_ / stride_;
    place_ = (place_ + 1) % stride_;
    return now;
}

CarrierNoise::CarrierNoise(const FreeDecay& decay)
    : f0_hz_(decay.f0_hz),
      rate_hz_(decay.rate_hz),
      added_sd_(decay.carrier_noise * std::abs(decay.a_A)),
      modulation_sd_(decay.modulation_noise),
      phase_sd_(decay.phase_noise_rad),
      added_{about_carrier(decay, 1), about_carrier(decay, 2)},
      modulation_{about_carrier(decay, 3), about_carrier(decay, 4)},
      phase_(0.01 / decay.seconds, decay.rate_hz, phase_stride(decay), stream_seed(decay.seed, 5)) {
}

void CarrierNoise::disturb(Eigen::Vector2cd& z, std::int64_t frame) {
    if (added_sd_ > 0) {
        // The process is slow; it turns with the carrier.
        const auto carrier =
            std::polar(1.0, 2 * pi * turns_at(static_cast<double>(frame), f0_hz_, rate_hz_));
        z += added_sd_ * carrier * Eigen::Vector2cd(added_[0].next(), added_[1].next());
    }
    if (modulation_sd_ > 0) {
        z(0) *= 1.0 + modulation_sd_ * modulation_[0].next();
        z(1) *= 1.0 + modulation_sd_ * modulation_[1].next();
    }
    if (phase_sd_ > 0) {
        z *= std::polar(1.0, phase_sd_ * phase_.next());
    }
}

}  // namespace vybeg
