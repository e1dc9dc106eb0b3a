#include "core/windows/window_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {

WindowPlan plan_windows(std::int64_t first, std::int64_t end, std::int64_t length,
                        std::int64_t hop) {
    const std::int64_t room = end - first - length;
    return {first, length, hop, room < 0 ? 0 : room / hop + 1};
}

double orthogonality_residual(std::int64_t n, double f_hz, double rate_hz) {
    // Half a turn of 2 w dt is pi f / rate * 2; reduced to whole turns first, so that long windows
    // keep their digits.
    const double step = 2 * f_hz / rate_hz;  // half-periods per sample
    const double whole = static_cast<double>(n) * step;
    const double sine = std::sin(std::numbers::pi * std::remainder(whole, 2.0));
    const double denominator =
        static_cast<double>(n) * std::sin(std::numbers::pi * std::remainder(step, 2.0));
    return denominator == 0 ? 1 : std::abs(sine / denominator);
}

std::int64_t least_window(double f_hz, double rate_hz) {
    // cos and sin are indistinguishable where f meets its image, at 0 and at half the rate.
    const double nearest_hz = std::min(f_hz, rate_hz / 2 - f_hz);
    constexpr double longest = 1e15;  // of any recording; a carrier at half the rate has no window
    const double samples =
        nearest_hz > 0 ? std::min(std::ceil(0.75 * rate_hz / nearest_hz), longest) : longest;
    return std::max<std::int64_t>(5, static_cast<std::int64_t>(samples));
}

std::int64_t snap_window(std::int64_t n, double f_hz, double rate_hz) {
    const auto reach = static_cast<std::int64_t>(rate_hz / (2 * f_hz));
    const std::int64_t least = least_window(f_hz, rate_hz);
    std::int64_t best = std::max(n, least);
    for (std::int64_t distance = 1; distance <= reach; ++distance) {
        for (const std::int64_t candidate : {n - distance, n + distance}) {
            if (candidate >= least && orthogonality_residual(candidate, f_hz, rate_hz) <
                                          orthogonality_residual(best, f_hz, rate_hz)) {
                best = candidate;
            }
        }
    }
    return best;
}

std::int64_t window_of_periods(double periods, double f_hz, double rate_hz) {
    return std::llround(periods * rate_hz / f_hz);
}

}  // namespace vybeg
