#include "core/numerics/kaiser.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {

double kaiser_window(double x, double beta) {
    const double inside = 1 - x * x;
    if (inside < 0) {
        return 0;
    }
    return std::cyl_bessel_i(0.0, beta * std::sqrt(inside)) / std::cyl_bessel_i(0.0, beta);
}

std::vector<double> kaiser_weights(std::size_t size, double beta) {
    std::vector<double> weights(size);
    const double highest = std::cyl_bessel_i(0.0, beta);
    for (std::size_t j = 0; j < (size + 1) / 2; ++j) {
        const double x = 2 * (static_cast<double>(j) + 0.5) / static_cast<double>(size) - 1;
        weights[j] = std::cyl_bessel_i(0.0, beta * std::sqrt(1 - x * x)) / highest;
        weights[size - 1 - j] = weights[j];
    }
    return weights;
}

double blackman_harris(double angle) {
    return 0.35875 - 0.48829 * std::cos(angle) + 0.14128 * std::cos(2 * angle) -
           0.01168 * std::cos(3 * angle);
}

double sinc(double x) {
    const double angle = std::numbers::pi * x;
    return angle == 0 ? 1 : std::sin(angle) / angle;
}

KaiserDesign kaiser_design(double attenuation_db, double transition) {
    // The order of a transition of nearly zero does not fit into an integer; this is long enough
    // for any recording.
    constexpr double longest = 0x1p53;
    const double order =
        (attenuation_db - 7.95) / (2.285 * 2 * std::numbers::pi * transition);  // 2 M
    return {.beta = 0.1102 * (attenuation_db - 8.7),
            .half_length = static_cast<std::int64_t>(std::ceil(std::min(order / 2, longest)))};
}

std::vector<double> band_pass_taps(double low, double high, const KaiserDesign& design) {
    std::vector<double> taps;
    taps.reserve(static_cast<std::size_t>(design.half_length) + 1);
    for (std::int64_t m = 0; m <= design.half_length; ++m) {
        const auto t = static_cast<double>(m);
        const double ideal = 2 * high * sinc(2 * high * t) - 2 * low * sinc(2 * low * t);
        taps.push_back(ideal *
                       kaiser_window(t / static_cast<double>(design.half_length), design.beta));
    }
    return taps;
}

}  // namespace vybeg
