#include "core/residuals/signal_curves.h"

#include "core/analysis/prepare.h"
#include "core/residuals/window_wave.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

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

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
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
    excerpt.fit_c.assign(size, std::numeric_limits<double>::quiet_NaN());
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
