#include "core/simulation/free_decay.h"

#include "core/base/number_text.h"
#include "core/simulation/gaussian_noise.h"
#include "core/simulation/slow_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <utility>

namespace vybeg {
namespace {

constexpr std::int64_t most_frames = std::int64_t{1} << 28;  // 4 GiB of samples
constexpr std::int64_t block = 256;        // frames between two exact anchors: 256 roundings
constexpr std::int64_t check_every = 256;  // blocks between two looks at the stop token

Error impossible(std::string reason) {
    return {ErrorCode::simulation_impossible, "simulate", {std::move(reason)}};
}

void clip_and_round(std::vector<double>& samples, double full_scale, int bits) {
    const double steps = std::ldexp(1.0, bits - 1);
    for (double& sample : samples) {
        const double code = std::clamp(std::round(sample / full_scale * steps), -steps, steps - 1);
        sample = code * (full_scale / steps);
    }
}

double largest(const std::vector<double>& samples) {
    const auto [low, high] = std::ranges::minmax(samples);
    return std::max(std::abs(low), std::abs(high));
}

}  // namespace

FreeDecay demo_decay() {
    FreeDecay decay;
    decay.split_hz = 0.012;
    decay.theta_w = -0.2;
    decay.tau_s = 30;
    decay.damping_anisotropy_per_s = 0.002;
    decay.theta_tau = 0.3;
    decay.omega_rad_s = 0.08;
    decay.noise = 1e-3;
    return decay;
}

Status check(const FreeDecay& decay) {
    const std::array numbers{
        decay.seconds,  decay.rate_hz,     decay.f0_hz,     decay.a_A,
        decay.a_B,      decay.two_theta_A, decay.alpha,     decay.split_hz,
        decay.theta_w,  decay.tau_s,       decay.theta_tau, decay.damping_anisotropy_per_s,
        decay.bryan,    decay.omega_rad_s, decay.noise,     decay.kappa,
        decay.offset_c, decay.offset_d,    decay.full_scale};
    if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); })) {
        return impossible("every parameter must be a finite number");
    }
    if (decay.seconds <= 0 || decay.rate_hz <= 0) {
        return impossible("the length and the sample rate must be above 0");
    }
    if (decay.f0_hz <= 0 || decay.f0_hz >= decay.rate_hz / 2) {
        return impossible("the carrier of " + short_text(decay.f0_hz) +
                          " Hz is not between 0 and half the sample rate, " +
                          short_text(decay.rate_hz / 2) + " Hz");
    }
    if (decay.seconds * decay.rate_hz > static_cast<double>(most_frames)) {
        return impossible(short_text(decay.seconds * decay.rate_hz) +
                          " samples are more than fit into memory; the most is " +
                          integer_text(most_frames));
    }
    if (frame_count(decay) < 1) {
        return impossible("the record is shorter than one sample");
    }
    if (decay.tau_s <= 0) {
        return impossible("the decay time must be above 0");
    }
    if (decay.split_hz < 0 || decay.damping_anisotropy_per_s < 0) {
        return impossible("frequency split and damping anisotropy cannot be negative");
    }
    if (decay.damping_anisotropy_per_s > 2 / decay.tau_s) {
        return impossible("a damping anisotropy above 2/tau = " + short_text(2 / decay.tau_s) +
                          " 1/s would let one mode grow");
    }
    if (decay.noise < 0) {
        return impossible("the noise cannot be negative");
    }
    if (decay.kappa <= 0) {
        return impossible("the gain ratio kappa must be above 0");
    }
    if (decay.bits != 0 && (decay.bits < 2 || decay.bits > 32)) {
        return impossible("the quantiser has 2 to 32 bits");
    }
    if (decay.full_scale < 0) {
        return impossible("the full scale cannot be negative");
    }
    return {};
}

std::int64_t frame_count(const FreeDecay& decay) {
    return static_cast<std::int64_t>(std::floor(decay.seconds * decay.rate_hz + 1e-6));
}

Result<SimulatedDecay> simulate(const FreeDecay& decay, const JobControl& job) {
    if (const Status status = check(decay); !status) {
        return status.error();
    }
    const std::int64_t frames = frame_count(decay);
    SimulatedDecay samples;
    try {
        // Reserved, not filled: filling gigabytes would not hear the stop token.
        samples.c.reserve(static_cast<std::size_t>(frames));
        samples.d.reserve(static_cast<std::size_t>(frames));
    } catch (const std::bad_alloc&) {
        return impossible("there is no memory for " + integer_text(frames) + " samples");
    }
    const SlowMotion motion(decay);
    const Eigen::Matrix2cd step = motion.propagator(1 / decay.rate_hz) * motion.carrier(1);
    GaussianNoise noise(decay.seed);
    for (std::int64_t first = 0; first < frames; first += block) {
        if (first % (block * check_every) == 0) {
            if (job.cancelled()) {
                return Error{ErrorCode::interrupted, {}, {}};
            }
            job.report(static_cast<double>(first) / static_cast<double>(frames));
        }
        Eigen::Vector2cd z = motion.at_frame(static_cast<double>(first));
        const std::int64_t end = std::min(first + block, frames);
        for (std::int64_t k = first; k < end; ++k) {
            double c = z(0).real() + decay.offset_c;
            double d = z(1).real() / decay.kappa + decay.offset_d;
            if (decay.noise > 0) {
                const auto [noise_c, noise_d] = noise.next();
                c += decay.noise * noise_c;
                d += decay.noise * noise_d;
            }
            samples.c.push_back(c);
            samples.d.push_back(d);
            z = step * z;
        }
    }
    if (decay.bits > 0) {
        const double peak = std::max(largest(samples.c), largest(samples.d));
        samples.full_scale = decay.full_scale > 0 ? decay.full_scale : 1.25 * peak;
        if (samples.full_scale <= 0) {
            return impossible("a record of zeros has no full scale; give one");
        }
        clip_and_round(samples.c, samples.full_scale, decay.bits);
        clip_and_round(samples.d, samples.full_scale, decay.bits);
    }
    return samples;
}

}  // namespace vybeg
