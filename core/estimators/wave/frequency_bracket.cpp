#include "core/estimators/wave/frequency_bracket.h"

#include <algorithm>
#include <numbers>

namespace vybeg {

FrequencyBracket main_lobe(double f0_hz, double rate_hz, std::int64_t n) {
    constexpr double pi = std::numbers::pi;
    const double w0 = 2 * pi * f0_hz / rate_hz;
    const double lobe = 2 * pi / static_cast<double>(n);
    // Within half a lobe of 0 or of half the rate cos and sin are nearly equal in the window, and
    // the fit is singular. A carrier in this range keeps half of its distance to the edge.
    const double edge = lobe / 2;
    return {std::max(w0 - lobe, std::min(edge, w0 / 2)), w0,
            std::min(w0 + lobe, std::max(pi - edge, (w0 + pi) / 2))};
}

}  // namespace vybeg
