#include "core/analysis/filtered_noise.h"

#include "core/numerics/kaiser.h"
#include "core/recording/conditioning/filtered_source.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

// Response at a frequency (cycles per sample) of a symmetric filter, from half of it.
double gain_at(const std::vector<double>& half, double frequency) {
    // Clenshaw's recurrence for the sum of h[m] cos(m x).
    const double x = 2 * std::cos(2 * std::numbers::pi * frequency);
    double next = 0;
    double after = 0;
    for (std::size_t m = half.size() - 1; m > 0; --m) {
        const double here = 2 * half[m] + x * next - after;
        after = next;
        next = here;
    }
    return half[0] + 0.5 * x * next - after;
}

}  // namespace

FilteredNoise filtered_noise(const Band& band, double f_hz, std::int64_t window, double rate_hz) {
    constexpr double most_lags = 256;
    constexpr double least = 1e-3;
    const std::vector<double> half = band_pass_response(band.low_hz, band.high_hz, rate_hz);
    const double h = static_cast<double>(window) / rate_hz;
    const double width = band.high_hz - band.low_hz;
    const auto lags =
        static_cast<std::size_t>(std::clamp(std::ceil(16 / (width * h)), 4.0, most_lags));
    // The band with its transitions, in steps that resolve the longest lag and the band's edges.
    const double from = std::max(band.low_hz - width, 0.0);
    const double to = std::min(band.high_hz + width, rate_hz / 2);
    const double step = std::min(1 / (8 * h * static_cast<double>(lags)), width / 64);
    std::vector<double> sums(lags, 0.0);
    const double centre = gain_at(half, f_hz / rate_hz);
    for (double f = from + step / 2; f < to; f += step) {
        const double gain = gain_at(half, f / rate_hz) / centre * sinc((f - f_hz) * h);
        for (std::size_t lag = 0; lag < lags; ++lag) {
            sums[lag] += gain * gain *
                         std::cos(2 * std::numbers::pi * (f - f_hz) * h * static_cast<double>(lag));
        }
    }
    FilteredNoise noise;
    noise.variance = sums[0] * step * h;
    for (double& sum : sums) {
        noise.correlation.push_back(sum / sums[0]);
    }
    while (noise.correlation.size() > 1 && std::abs(noise.correlation.back()) < least) {
        noise.correlation.pop_back();
    }
    return noise;
}

}  // namespace vybeg
