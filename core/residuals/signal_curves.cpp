#include "core/residuals/signal_curves.h"

#include "core/analysis/prepare.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Consecutive frames [first, end).
struct Frames {
    std::int64_t first = 0;
    std::int64_t end = 0;
};

// Rounded up; b > 0.
std::int64_t divided_up(std::int64_t a, std::int64_t b) {
    return a / b + (a % b > 0 ? 1 : 0);
}

// The first frame that is at least as near to the centre of a window as to that of the one before.
std::int64_t own_begin(const WindowPlan& plan, std::int64_t window) {
    return divided_up(2 * plan.start(window) - plan.hop + plan.length - 1, 2);
}

// Frames that belong to a window: those of its samples whose nearest centre is its own; halfway
// between two centres the later window's.
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

// The window that a frame belongs to, or the first one after it; after all the last one.
std::int64_t window_about(const WindowPlan& plan, std::int64_t frame) {
    const std::int64_t before =
        (2 * (frame - plan.first) + plan.hop - plan.length) / (2 * plan.hop);
    std::int64_t window = std::clamp<std::int64_t>(before - 1, 0, plan.count - 1);
    while (window + 1 < plan.count && own_frames(plan, window).end <= frame) {
        ++window;
    }
    return window;
}

// Samples of both channels, or of a wave; recording units.
struct SignalPair {
    double c = 0;
    double d = 0;
};

// The wave (6) of a window, from its row of the track. Precondition: the track has all rows of the
// plan.
class WindowWave {
public:
    WindowWave(const Analysis& analysis, std::int64_t window, double rate_hz) {
        const auto row = static_cast<std::size_t>(window);
        const auto value = [&](SlowVariable variable) {
            return analysis.track.values(variable)[row];
        };
        const double zero = analysis.settings.calibration.two_theta_zero();
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

    // Whether the window has a wave with an angle.
    bool exists() const { return std::isfinite(cos_c_ + sin_c_ + alpha_ + step_); }
    // NaN of a wave that does not exist. `frame` may lie between samples.
    SignalPair at(double frame) const {
        const double tau = step_ * (frame - centre_) - alpha_;
        const double cosine = std::cos(tau);
        const double sine = std::sin(tau);
        return {cos_c_ * cosine + sin_c_ * sine, cos_d_ * cosine + sin_d_ * sine};
    }
    SignalPair amplitudes() const {
        return {std::hypot(cos_c_, sin_c_), std::hypot(cos_d_, sin_d_)};
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

// The waves of the windows, or that of `only`.
void fit(const Analysis& analysis, std::optional<std::int64_t> only, SignalExcerpt& excerpt) {
    const WindowPlan& plan = analysis.plan;
    const std::int64_t end = excerpt.first + std::ssize(excerpt.c);
    if (plan.count == 0) {
        return;
    }
    for (std::int64_t window = only.value_or(window_about(plan, excerpt.first));
         window < plan.count; ++window) {
        Frames own = only ? Frames{excerpt.first, end} : own_frames(plan, window);
        if (own.first >= end || (only && window != only)) {
            break;
        }
        own = {std::max(own.first, excerpt.first), std::min(own.end, end)};
        const WindowWave wave(analysis, window, excerpt.rate_hz);
        for (std::int64_t frame = own.first; frame < own.end; ++frame) {
            const auto k = static_cast<std::size_t>(frame - excerpt.first);
            const SignalPair value = wave.at(static_cast<double>(frame));
            excerpt.fit_c[k] = value.c;
            excerpt.fit_d[k] = value.d;
        }
    }
}

constexpr int windows_in_column = 8;

void append(SignalCurve& curve, double time_s, const SignalPair& pair) {
    curve.time_s.push_back(time_s);
    curve.c.push_back(pair.c);
    curve.d.push_back(pair.d);
}

// The number of the window that has the frame; none between windows and beyond them.
std::optional<std::int64_t> window_with(const WindowPlan& plan, double frame) {
    const double begin = static_cast<double>(plan.first) - 0.5;
    const double end = static_cast<double>(plan.start(plan.count - 1) + plan.length) - 0.5;
    if (plan.count == 0 || !(frame >= begin && frame < end)) {
        return std::nullopt;
    }
    const auto nearest = static_cast<std::int64_t>(std::floor(frame + 0.5));
    const std::int64_t window = window_about(plan, nearest);
    const Frames own = own_frames(plan, window);
    return own.first <= nearest && nearest < own.end ? std::optional(window) : std::nullopt;
}

SignalPair mean_amplitudes(const Analysis& analysis, double rate_hz, double from_s, double to_s) {
    SignalPair sum;
    int found = 0;
    std::int64_t last = -1;
    for (int k = 0; k < windows_in_column; ++k) {
        const double time = from_s + (k + 0.5) / windows_in_column * (to_s - from_s);
        const auto window = window_with(analysis.plan, time * rate_hz);
        if (!window || *window == last) {
            continue;
        }
        last = *window;
        const WindowWave wave(analysis, *window, rate_hz);
        if (wave.exists()) {
            const SignalPair own = wave.amplitudes();
            sum = {sum.c + own.c, sum.d + own.d};
            ++found;
        }
    }
    return found > 0 ? SignalPair{sum.c / found, sum.d / found} : SignalPair{nan, nan};
}

}  // namespace

Result<SignalSource> signal_source(const Recording& recording,
                                   std::shared_ptr<const Analysis> analysis,
                                   const JobControl& job) {
    if (!analysis) {
        return SignalSource{recording.source, recording.rate_hz, nullptr};
    }
    // Carrier and offsets are in the settings as used, so that nothing is searched again.
    const auto prepared = TRY(prepare(recording, analysis->settings, job.silent()));
    return SignalSource{prepared.ahead, recording.rate_hz, std::move(analysis)};
}

Result<SignalExcerpt> signal_excerpt(const SignalSource& source, std::int64_t first,
                                     std::int64_t count, const JobControl& job,
                                     std::optional<std::int64_t> window) {
    TRY(job.go_on());
    SignalExcerpt excerpt;
    excerpt.first = std::clamp<std::int64_t>(first, 0, source.samples->frames());
    excerpt.rate_hz = source.rate_hz;
    const std::int64_t end = std::clamp(first + count, excerpt.first, source.samples->frames());
    const auto size = static_cast<std::size_t>(end - excerpt.first);
    excerpt.c.resize(size);
    excerpt.d.resize(size);
    if (size > 0) {
        TRY(source.samples->read(excerpt.first, excerpt.c, excerpt.d));
    }
    excerpt.fit_c.assign(size, nan);
    excerpt.fit_d = excerpt.fit_c;
    if (source.analysis) {
        fit(*source.analysis, window, excerpt);
    }
    return excerpt;
}

SignalCurve wave_curve(const Analysis& analysis, double rate_hz, double from_s, double to_s,
                       int count) {
    SignalCurve curve;
    std::optional<std::int64_t> window;
    std::optional<WindowWave> wave;
    for (int k = 0; k < count; ++k) {
        const double time = from_s + k * ((to_s - from_s) / (count - 1));
        const double frame = time * rate_hz;
        const auto here = window_with(analysis.plan, frame);
        if (here && here != window) {
            wave.emplace(analysis, *here, rate_hz);
        }
        window = here;
        append(curve, time, window ? wave->at(frame) : SignalPair{nan, nan});
    }
    return curve;
}

SignalCurve amplitude_curve(const Analysis& analysis, double rate_hz, double from_s, double to_s,
                            int count) {
    SignalCurve curve;
    const double width = (to_s - from_s) / count;
    const double first = std::floor(from_s / width);
    for (double column = first; column * width < to_s; ++column) {
        append(curve, (column + 0.5) * width,
               mean_amplitudes(analysis, rate_hz, column * width, (column + 1) * width));
    }
    return curve;
}

}  // namespace vybeg
