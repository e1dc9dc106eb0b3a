#include "core/simulation/simulate.h"

#include "core/base/number_text.h"
#include "core/simulation/carrier_noise.h"
#include "core/simulation/check_decay.h"
#include "core/simulation/decay_motion.h"
#include "core/simulation/gaussian_noise.h"
#include "core/simulation/pick_offs.h"
#include "core/simulation/recorder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

constexpr std::int64_t most_in_memory = std::int64_t{1} << 28;  // 4 GiB of samples
constexpr std::int64_t at_once = 16384;                         // frames for the sink

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
    const std::int64_t frames = motion_frame_count(decay);
    DecayMotion motion(decay);
    std::optional<DecayMotion> late;  // motion of channel D, delayed
    if (decay.delay_d_s != 0) {
        late.emplace(decay, decay.delay_d_s);
    }
    CarrierNoise about_carrier(decay);
    const PickOffs pick_offs(decay);
    GaussianNoise noise(decay.seed);
    std::array recorders{Recorder(decay.lost), Recorder(decay.lost)};
    std::vector<double> c;
    std::vector<double> d;
    for (std::int64_t begin = 0; begin < frames; begin += at_once) {
        TRY(job.go_on());
        c.clear();
        d.clear();
        const std::int64_t end = std::min(begin + at_once, frames);
        for (std::int64_t k = begin; k < end; ++k) {
            Eigen::Vector2cd z = motion.next();
            if (late) {
                z(1) = late->next()(1);
            }
            about_carrier.disturb(z, k);
            const auto [of_c, of_d] = pick_offs.signals(z, k);
            c.push_back(of_c);
            d.push_back(of_d);
            if (decay.noise > 0) {
                const auto [noise_c, noise_d] = noise.next();
                c.back() += decay.noise * noise_c;
                d.back() += decay.noise * noise_d;
            }
        }
        recorders[0].record(c);
        recorders[1].record(d);
        TRY(take(c, d));
        job.report(static_cast<double>(end) / static_cast<double>(frames));
    }
    return {};
}

}  // namespace

Result<double> find_full_scale(const FreeDecay& decay, const JobControl& job) {
    TRY(check(decay));
    if (decay.bits == 0 || decay.full_scale > 0) {
        return decay.bits == 0 ? 0 : decay.full_scale;
    }
    double peak = 0;
    const auto look = [&peak](const std::vector<double>& c, const std::vector<double>& d) {
        peak = std::max({peak, largest(c), largest(d)});
        return Status{};
    };
    TRY(run(decay, look, job));
    if (peak <= 0) {
        return impossible("a record of zeros has no full scale; give one");
    }
    return 1.25 * peak;
}

Status simulate(const FreeDecay& decay, double full_scale, const DecaySink& sink,
                const JobControl& job) {
    TRY(check(decay));
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
    const auto full_scale = TRY(find_full_scale(decay, job));
    const std::int64_t frames = frame_count(decay);
    if (frames > most_in_memory) {
        return impossible(integer_text(frames) +
                          " samples are more than fit into memory; the most is " +
                          integer_text(most_in_memory));
    }
    SimulatedDecay samples;
    samples.full_scale = full_scale;
    try {
        // Reserved, not filled, because filling gigabytes would ignore the stop token.
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
    TRY(simulate(decay, full_scale, collect, job));
    return samples;
}

}  // namespace vybeg
