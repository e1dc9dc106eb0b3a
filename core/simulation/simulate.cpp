#include "core/simulation/simulate.h"

#include "core/base/number_text.h"
#include "core/numerics/phase.h"
#include "core/simulation/decay_motion.h"
#include "core/simulation/noise.h"
#include "core/windows/window_plan.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
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

constexpr std::int64_t at_once = 16384;  // frames for the sink

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

constexpr std::int64_t most_rows = std::int64_t{1} << 26;  // 9 GB of track
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// Relative to the amplitude: four digits above the rounding of the compared values.
constexpr double vanishing = 1e-12;

// Ellipse of (C, D) = ellipse (cos wt, sin wt): rotation, two signed half-axes and a phase.
struct Axes {
    double long_axis = 0;   // a_A
    double short_axis = 0;  // a_B, its sign is the sense of rotation
    double angle = 0;       // 2theta_A
    double phase = 0;       // alpha, chosen together with the angle
};

Axes axes_of(const Eigen::Matrix2d& ellipse) {
    const Eigen::JacobiSVD<Eigen::Matrix2d> svd(ellipse, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Axes axes;
    axes.long_axis = svd.singularValues()(0);
    axes.short_axis = std::copysign(svd.singularValues()(1), ellipse.determinant());
    axes.angle = std::atan2(svd.matrixU()(1, 0), svd.matrixU()(0, 0));
    axes.phase = std::atan2(svd.matrixV()(1, 0), svd.matrixV()(0, 0));
    return axes;
}

double phase_lead(const Eigen::Vector2cd& phasors) {
    const double least = vanishing * phasors.norm();
    if (std::abs(phasors(0)) <= least || std::abs(phasors(1)) <= least) {
        return nan;
    }
    return wrap(std::arg(phasors(1)) - std::arg(phasors(0)));
}

// The angle unwrapped modulo pi from the row before it, the first into (-pi/2, pi/2].
double unwrapped(double angle, const std::optional<double>& previous) {
    if (previous) {
        return nearest_branch(angle, *previous, pi);
    }
    const double nearest = nearest_branch(angle, 0, pi);
    return nearest <= -pi / 2 ? nearest + pi : nearest;
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
    SimulatedDecay samples;
    samples.full_scale = full_scale;
    samples.c.reserve(static_cast<std::size_t>(frame_count(decay)));
    samples.d.reserve(samples.c.capacity());
    const DecaySink collect = [&samples](std::span<const double> c, std::span<const double> d) {
        samples.c.insert(samples.c.end(), c.begin(), c.end());
        samples.d.insert(samples.d.end(), d.begin(), d.end());
        return Status{};
    };
    TRY(simulate(decay, full_scale, collect, job));
    return samples;
}

Result<Track> true_track(const FreeDecay& decay, std::int64_t window) {
    TRY(check(decay));
    const std::int64_t frames = motion_frame_count(decay);
    if (window < 1 || window > frames) {
        return impossible("its truth needs a window of 1 to " + integer_text(frames) + " samples");
    }
    const WindowPlan plan = plan_windows(0, frames, window, window);
    if (plan.count > most_rows) {
        return impossible("its truth would have " + integer_text(plan.count) +
                          " windows; the most is " + integer_text(most_rows));
    }
    DecayMotion motion(decay);
    Track track(static_cast<std::size_t>(plan.count));
    std::optional<double> previous;
    for (std::size_t row = 0; row < track.rows(); ++row) {
        const auto start = static_cast<double>(plan.start(static_cast<std::int64_t>(row)));
        const double centre = start + 0.5 * static_cast<double>(window - 1);
        const Eigen::Vector2cd phasors = motion.at_frame(centre);
        Eigen::Matrix2d ellipse;
        ellipse << phasors.real(), -phasors.imag();
        const Axes axes = axes_of(ellipse);
        const auto put = [&track, row](SlowVariable variable, double value) {
            track.put(row, variable, value, 0);
        };
        track.time_s()[row] = plan.centre_s(static_cast<std::int64_t>(row), decay.rate_hz);
        put(SlowVariable::a_A, axes.long_axis);
        put(SlowVariable::a_B, axes.short_axis);
        put(SlowVariable::f, motion.frequency_hz(centre, phasors));
        put(SlowVariable::delta_phi_CD, phase_lead(phasors));
        put(SlowVariable::rms, std::numbers::sqrt2 * decay.noise);
        put(SlowVariable::orthogonality, 0);
        if (axes.long_axis - std::abs(axes.short_axis) <= vanishing * axes.long_axis) {
            set(track.flags()[row], Flag::circular);
            continue;  // the track was made with NaN in the angles
        }
        const double angle = unwrapped(axes.angle, previous);
        const bool odd = std::abs(std::remainder(angle - axes.angle, 2 * pi)) > pi / 2;
        put(SlowVariable::two_theta_A, angle);
        put(SlowVariable::alpha, wrap(odd ? axes.phase + pi : axes.phase));
        previous = angle;
    }
    return track;
}

SoftwareLockIn::SoftwareLockIn(const LockIn& filter, double f_ref_hz, double rate_hz,
                               std::int64_t samples_per_row)
    : filter_(filter),
      f_ref_hz_(f_ref_hz),
      rate_hz_(rate_hz),
      samples_per_row_(samples_per_row),
      keep_(std::exp(-1 / (rate_hz * filter.tau_s()))) {
    for (auto& stages : stages_) {
        stages.assign(static_cast<std::size_t>(filter.order), 0);
    }
}

void SoftwareLockIn::take(std::span<const double> c, std::span<const double> d) {
    for (std::size_t k = 0; k < c.size(); ++k, ++frame_) {
        const double turns = turns_at(static_cast<double>(frame_), f_ref_hz_, rate_hz_);
        const Complex reference = std::polar(2.0, -2 * std::numbers::pi * turns);
        const std::array samples{c[k], d[k]};
        for (std::size_t channel = 0; channel < samples.size(); ++channel) {
            Complex z = samples[channel] * reference;
            for (Complex& stage : stages_[channel]) {
                stage += (1 - keep_) * (z - stage);
                z = stage;
            }
            if (frame_ % samples_per_row_ == 0) {
                rows_[channel].push_back(z);
            }
        }
    }
}

std::string SoftwareLockIn::table() const {
    // To 1e-6 of a step.
    const double settled_s = (14 + 2.5 * filter_.order) * filter_.tau_s();
    std::string text = "t (s),Xc,Yc,Xd,Yd,F (Hz)\n";
    for (std::size_t k = 0; k < rows_[0].size(); ++k) {
        const double t = static_cast<double>(k) * static_cast<double>(samples_per_row_) / rate_hz_;
        if (t < settled_s) {
            continue;
        }
        text += round_trip_text(t);
        for (const Complex z : {rows_[0][k], rows_[1][k]}) {
            text += ',' + round_trip_text(z.real()) + ',' + round_trip_text(z.imag());
        }
        text += ',' + round_trip_text(f_ref_hz_) + '\n';
    }
    return text;
}

}  // namespace vybeg
