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

constexpr std::int64_t most_frames = std::int64_t{1} << 36;     // three weeks at 33333 Hz
constexpr std::int64_t most_in_memory = std::int64_t{1} << 28;  // 4 GiB of samples
constexpr std::int64_t block = 256;           // frames between two exact anchors: 256 roundings
constexpr std::int64_t at_once = 64 * block;  // frames for the sink

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

double largest(std::span<const double> samples) {
    const auto [low, high] = std::ranges::minmax(samples);
    return std::max(std::abs(low), std::abs(high));
}

// The signals before the quantiser.
Status run(const FreeDecay& decay,
           const std::function<Status(std::vector<double>&, std::vector<double>&)>& take,
           const JobControl& job) {
    const std::int64_t frames = frame_count(decay);
    const SlowMotion motion(decay);
    const Eigen::Matrix2cd step = motion.propagator(1 / decay.rate_hz) * motion.carrier(1);
    GaussianNoise noise(decay.seed);
    std::vector<double> c;
    std::vector<double> d;
    for (std::int64_t begin = 0; begin < frames; begin += at_once) {
        if (job.cancelled()) {
            return Error{ErrorCode::interrupted, {}, {}};
        }
        c.clear();
        d.clear();
        const std::int64_t end = std::min(begin + at_once, frames);
        Eigen::Vector2cd z;
        for (std::int64_t k = begin; k < end; ++k) {
            if (k % block == 0) {
                z = motion.at_frame(static_cast<double>(k));
            }
            c.push_back(z(0).real() + decay.offset_c);
            d.push_back(z(1).real() / decay.kappa + decay.offset_d);
            if (decay.noise > 0) {
                const auto [noise_c, noise_d] = noise.next();
                c.back() += decay.noise * noise_c;
                d.back() += decay.noise * noise_d;
            }
            z = step * z;
        }
        if (const Status taken = take(c, d); !taken) {
            return taken;
        }
        job.report(static_cast<double>(end) / static_cast<double>(frames));
    }
    return {};
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
                          " samples are too many; the most is " + integer_text(most_frames));
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

Result<double> find_full_scale(const FreeDecay& decay, const JobControl& job) {
    if (const Status status = check(decay); !status) {
        return status.error();
    }
    if (decay.bits == 0 || decay.full_scale > 0) {
        return decay.bits == 0 ? 0 : decay.full_scale;
    }
    double peak = 0;
    const auto look = [&peak](const std::vector<double>& c, const std::vector<double>& d) {
        peak = std::max({peak, largest(c), largest(d)});
        return Status{};
    };
    if (const Status ran = run(decay, look, job); !ran) {
        return ran.error();
    }
    if (peak <= 0) {
        return impossible("a record of zeros has no full scale; give one");
    }
    return 1.25 * peak;
}

Status simulate(const FreeDecay& decay, double full_scale, const DecaySink& sink,
                const JobControl& job) {
    if (const Status status = check(decay); !status) {
        return status;
    }
    const auto take = [&](std::vector<double>& c, std::vector<double>& d) {
        if (decay.bits > 0) {
            clip_and_round(c, full_scale, decay.bits);
            clip_and_round(d, full_scale, decay.bits);
        }
        return sink(c, d);
    };
    return run(decay, take, job);
}

Result<SimulatedDecay> simulate(const FreeDecay& decay, const JobControl& job) {
    const Result<double> full_scale = find_full_scale(decay, job);
    if (!full_scale) {
        return full_scale.error();
    }
    const std::int64_t frames = frame_count(decay);
    if (frames > most_in_memory) {
        return impossible(integer_text(frames) +
                          " samples are more than fit into memory; the most is " +
                          integer_text(most_in_memory));
    }
    SimulatedDecay samples;
    samples.full_scale = *full_scale;
    try {
        // Reserved, not filled: filling gigabytes would not hear the stop token.
        samples.c.reserve(static_cast<std::size_t>(frames));
        samples.d.reserve(static_cast<std::size_t>(frames));
    } catch (const std::bad_alloc&) {
        return impossible("there is no memory for " + integer_text(frames) + " samples");
    }
    const DecaySink collect = [&samples](std::span<const double> c, std::span<const double> d) {
        samples.c.insert(samples.c.end(), c.begin(), c.end());
        samples.d.insert(samples.d.end(), d.begin(), d.end());
        return Status{};
    };
    if (const Status ran = simulate(decay, *full_scale, collect, job); !ran) {
        return ran.error();
    }
    return samples;
}

}  // namespace vybeg
