#include "core/analysis/phasor_window_length.h"

#include <algorithm>
#include <cmath>

namespace vybeg {

std::int64_t least_phasor_window(double f0_hz, double rate_hz) {
    return std::max<std::int64_t>(16, static_cast<std::int64_t>(std::ceil(2 * rate_hz / f0_hz)));
}

std::int64_t default_phasor_window(std::int64_t frames, double f0_hz, double rate_hz) {
    constexpr double wish_s = 0.015;
    constexpr double periods = 12;
    const auto wish =
        static_cast<std::int64_t>(std::llround(std::max(wish_s, periods / f0_hz) * rate_hz));
    return std::max(
        {std::min(wish, frames / 64), frames / 16384 + 1, least_phasor_window(f0_hz, rate_hz)});
}

}  // namespace vybeg
