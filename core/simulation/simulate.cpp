#include "core/simulation/simulate.h"

#include "core/base/number_text.h"
#include "core/simulation/decay_motion.h"
#include "core/simulation/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <new>
#include <numbers>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

double bent(double signal, double cubic) {
    return signal + cubic * signal * signal * signal;
}

// Pick-off signals of the wave: errors of the channels, modes beside, cubic, offsets, hum, as
// defined in FreeDecay. The phasor of D already contains its delay.
class PickOffs {
public:
    explicit PickOffs(const FreeDecay& decay)
        : decay_(decay),
          from_c_(std::sin(decay.skew_deg * pi / 180), decay.crosstalk),
          drifts_(decay.phase_drift_rad != 0 || decay.gain_drift != 0) {}

    // Signals of both channels at a frame, from the phasors with their carrier.
    std::pair<double, double> signals(const Eigen::Vector2cd& z, std::int64_t frame) const {
        const auto at = static_cast<double>(frame);
        Complex of_d = z(1) + decay_.same_projection * (z(0) - z(1));
        if (drifts_) {
            const double share = at / (decay_.rate_hz * decay_.seconds);
            of_d *=
                (1 + decay_.gain_drift * share) * std::polar(1.0, decay_.phase_drift_rad * share);
        }
        if (from_c_ != Complex{}) {
            of_d += from_c_ * z(0);
        }
        double c = z(0).real();
        double d = of_d.real() / decay_.kappa;
        for (const ModeBeside& mode : decay_.modes_beside) {
            const double left = std::exp(-at / (decay_.rate_hz * mode.tau_s));
            const double phase = 2 * pi * turns_at(at, mode.f_hz, decay_.rate_hz);
            c += mode.a_C * left * std::cos(phase - mode.phase_C);
            d += mode.a_D * left * std::cos(phase - mode.phase_D);
        }
        if (decay_.pick_off_cubic != 0) {
            c = bent(c, decay_.pick_off_cubic);
            d = bent(d, decay_.pick_off_cubic);
        }
        c += decay_.offset_c;
        d += decay_.offset_d;
        if (decay_.hum != 0) {
            const double phase = 2 * pi * turns_at(at, decay_.hum_hz, decay_.rate_hz);
            const double hum = decay_.hum * std::cos(phase - decay_.hum_phase);
            c += hum;
            d += hum;
        }
        return {c, d};
    }

private:
    FreeDecay decay_;
    Complex from_c_;  // sin skew + i crosstalk
    bool drifts_;
};

// Loses and doubles samples of one channel. Blocks are consecutive from frame 0 on.
class Recorder {
public:
    explicit Recorder(const std::vector<LostSamples>& lost) : lost_(lost) {}

    // The recorded samples of the next block.
    void record(std::vector<double>& samples) {
        if (next_ == lost_.size()) {
            return;
        }
        passed_.clear();
        for (const double sample : samples) {
            const std::int64_t frame = frame_++;
            const bool inside = next_ < lost_.size() && frame >= lost_[next_].frame;
            if (!inside) {
                passed_.push_back(sample);
                continue;
            }
            const LostSamples& fault = lost_[next_];
            if (fault.count < 0) {
                passed_.push_back(sample);
                twice_.push_back(sample);
            }
            if (frame + 1 == fault.frame + std::abs(fault.count)) {
                passed_.insert(passed_.end(), twice_.begin(), twice_.end());
                twice_.clear();
                ++next_;
            }
        }
        std::swap(samples, passed_);
    }

private:
    std::vector<LostSamples> lost_;
    std::size_t next_ = 0;        // present or next fault
    std::int64_t frame_ = 0;      // of the next sample
    std::vector<double> twice_;   // of the present doubling
    std::vector<double> passed_;  // kept to reuse its memory
};

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
