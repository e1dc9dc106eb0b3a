#include "core/residuals/fitted_wave.h"

#include "core/residuals/window_wave.h"

#include <cmath>
#include <limits>
#include <optional>

namespace vybeg {
namespace {

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
