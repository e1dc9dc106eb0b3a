#include "core/residuals/residual_samples.h"

#include "core/analysis/prepare.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

constexpr std::int64_t most_frames = std::int64_t{1} << 20;
constexpr std::int64_t block_frames = std::int64_t{1} << 16;

struct Frames {
    std::int64_t first = 0;
    std::int64_t end = 0;

    std::int64_t count() const { return std::max<std::int64_t>(end - first, 0); }
};

// Rounded up; b > 0.
std::int64_t divided_up(std::int64_t a, std::int64_t b) {
    return a / b + (a % b > 0 ? 1 : 0);
}

// The first frame that is at least as near to the centre of a window as to that of the one before.
std::int64_t own_begin(const WindowPlan& plan, std::int64_t window) {
    return divided_up(2 * plan.start(window) - plan.hop + plan.length - 1, 2);
}

// Frames whose residual is that of a window.
Frames own_frames(const WindowPlan& plan, std::int64_t window) {
    Frames own{plan.start(window), plan.start(window) + plan.length};
    if (window > 0) {
        own.first = std::max(own.first, own_begin(plan, window));
    }
    if (window + 1 < plan.count) {
        own.end = std::min(own.end, own_begin(plan, window + 1));
    }
    return own;
}

// A window that has the frame, or the first one after it.
std::int64_t window_about(const WindowPlan& plan, std::int64_t frame) {
    const std::int64_t before =
        (2 * (frame - plan.first) + plan.hop - plan.length) / (2 * plan.hop);
    std::int64_t window = std::clamp<std::int64_t>(before - 1, 0, plan.count - 1);
    while (window + 1 < plan.count && own_frames(plan, window).end <= frame) {
        ++window;
    }
    return window;
}

// The wave (6) of a window.
class Wave {
public:
    Wave(const Analysis& analysis, std::int64_t window, double rate_hz) {
        const auto row = static_cast<std::size_t>(window);
        const auto value = [&](SlowVariable variable) {
            return analysis.track.values(variable)[row];
        };
        const double zero = analysis.settings.calibration.angle_zero_deg * std::numbers::pi / 90;
        const double angle = value(SlowVariable::two_theta_A) + zero;
        const double a_A = value(SlowVariable::a_A);
        double a_B = value(SlowVariable::a_B);
        if (has(analysis.track.flags()[row], Flag::no_quadrature)) {
            a_B = 0;
        }
        cos_c_ = a_A * std::cos(angle);
        sin_c_ = -a_B * std::sin(angle);
        cos_d_ = a_A * std::sin(angle);
        sin_d_ = a_B * std::cos(angle);
        alpha_ = value(SlowVariable::alpha);
        step_ = 2 * std::numbers::pi * value(SlowVariable::f) / rate_hz;
        centre_ = static_cast<double>(analysis.plan.start(window)) +
                  0.5 * static_cast<double>(analysis.plan.length - 1);
    }

    bool exists() const { return std::isfinite(cos_c_ + sin_c_ + alpha_ + step_); }

    void subtract(std::int64_t frame, double& c, double& d) const {
        const double tau = step_ * (static_cast<double>(frame) - centre_) - alpha_;
        const double cosine = std::cos(tau);
        const double sine = std::sin(tau);
        c -= cos_c_ * cosine + sin_c_ * sine;
        d -= cos_d_ * cosine + sin_d_ * sine;
    }

private:
    double cos_c_ = 0;
    double sin_c_ = 0;
    double cos_d_ = 0;
    double sin_d_ = 0;
    double alpha_ = 0;
    double step_ = 0;
    double centre_ = 0;
};

class Collector {
public:
    Collector(const Recording& recording, const Analysis& analysis, const SampleSource& source,
              ResidualSamples& found)
        : analysis_(analysis), rate_hz_(recording.rate_hz), source_(source), found_(found) {}

    // Frames of one block; `only`: with the wave of this window.
    Status take(const Frames& block, std::optional<std::int64_t> only) {
        c_.resize(static_cast<std::size_t>(block.count()));
        d_.resize(c_.size());
        if (Status read = source_.read(block.first, c_, d_); !read) {
            return read;
        }
        const WindowPlan& plan = analysis_.plan;
        found_.examined += block.count();
        std::int64_t at = block.first;
        for (std::int64_t window = only.value_or(window_about(plan, at));
             at < block.end && window < plan.count; ++window) {
            Frames own = only ? block : own_frames(plan, window);
            if (own.first >= block.end) {
                break;
            }
            own = {std::max(own.first, at), std::min(own.end, block.end)};
            if (own.count() > 0) {
                found_.without += own.first - at;
                take_window(own, block.first, Wave(analysis_, window, rate_hz_));
                at = own.end;
            }
        }
        found_.without += block.end - at;
        return {};
    }

private:
    void take_window(const Frames& frames, std::int64_t first, const Wave& wave) {
        if (!wave.exists()) {
            found_.without += frames.count();
            in_run_ = false;
            return;
        }
        if (frames.first != next_) {
            in_run_ = false;
        }
        for (std::int64_t frame = frames.first; frame < frames.end; ++frame) {
            double c = c_[static_cast<std::size_t>(frame - first)];
            double d = d_[static_cast<std::size_t>(frame - first)];
            if (!std::isfinite(c) || !std::isfinite(d)) {
                ++found_.without;
                in_run_ = false;
                continue;
            }
            wave.subtract(frame, c, d);
            if (!in_run_) {
                found_.run_begins.push_back(found_.c.size());
                in_run_ = true;
            }
            found_.c.push_back(c);
            found_.d.push_back(d);
        }
        next_ = frames.end;
    }

    const Analysis& analysis_;
    double rate_hz_;
    const SampleSource& source_;
    ResidualSamples& found_;
    std::vector<double> c_;
    std::vector<double> d_;
    bool in_run_ = false;
    std::int64_t next_ = -1;  // frame that continues the run
};

Frames frames_of(const ResidualRange& range, const WindowPlan& plan, double rate_hz) {
    if (range.window) {
        return {plan.start(*range.window), plan.start(*range.window) + plan.length};
    }
    const Frames all{plan.first, plan.start(plan.count - 1) + plan.length};
    const auto frame_at = [&](double seconds) {
        return std::clamp(seconds * rate_hz, static_cast<double>(all.first),
                          static_cast<double>(all.end));
    };
    const auto last = static_cast<std::int64_t>(std::floor(frame_at(range.time.to_s) + 1e-6));
    return {static_cast<std::int64_t>(std::ceil(frame_at(range.time.from_s) - 1e-6)),
            std::min(last + 1, all.end)};
}

}  // namespace

Result<ResidualSamples> residual_samples(const Recording& recording, const Analysis& analysis,
                                         const ResidualRange& range, const JobControl& job) {
    // Carrier and offsets are in the settings as used, so that nothing is searched again.
    const Result<Prepared> prepared = prepare(recording, analysis.settings, job.silent());
    if (!prepared) {
        return prepared.error();
    }
    const Frames all = frames_of(range, analysis.plan, recording.rate_hz);
    ResidualSamples found;
    found.frames = all.count();
    const auto expected = static_cast<std::size_t>(std::min(all.count(), most_frames));
    found.c.reserve(expected);
    found.d.reserve(expected);
    const bool whole = all.count() <= most_frames;
    const std::int64_t blocks =
        whole ? divided_up(all.count(), block_frames) : most_frames / block_frames;
    Collector collector(recording, analysis, *prepared->ahead, found);
    for (std::int64_t b = 0; b < blocks; ++b) {
        if (job.cancelled()) {
            return Error{ErrorCode::interrupted, "", {}};
        }
        const std::int64_t first =
            all.first +
            (whole ? b * block_frames : (all.count() - block_frames) / (blocks - 1) * b);
        const Frames block{first, std::min(first + block_frames, all.end)};
        if (const Status taken = collector.take(block, range.window); !taken) {
            return taken.error();
        }
        job.report(static_cast<double>(b + 1) / static_cast<double>(blocks));
    }
    return found;
}

}  // namespace vybeg
