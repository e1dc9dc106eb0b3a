#include "core/residuals/line_filter.h"

#include "core/recording/conditioning/filtered_source.h"

#include <algorithm>
#include <cmath>

namespace vybeg {
namespace {

// Two digits, rounded down.
double rounded_down(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::floor(value / unit) * unit;
}

}  // namespace

std::optional<Band> filter_without(double line_hz, const SignalSettings& settings,
                                   const Recording& recording) {
    const double f0 = *settings.f0_hz;
    const double half_rate = recording.rate_hz / 2;
    const double far = std::abs(line_hz - f0);
    if (!(far > 0)) {
        return std::nullopt;
    }
    // The stopband begins half the band's width beyond an edge, provided that there is room.
    const double reach = rounded_down(std::min({0.49 * far, 0.5 * f0, 0.5 * (half_rate - f0)}));
    Band band{f0 - reach, f0 + reach};
    if (reach >= 20) {
        band = {std::round(band.low_hz), std::round(band.high_hz)};
    }
    if (settings.filter) {
        if (line_hz < settings.filter->low_hz || line_hz > settings.filter->high_hz) {
            return std::nullopt;
        }
        band = {std::max(band.low_hz, settings.filter->low_hz),
                std::min(band.high_hz, settings.filter->high_hz)};
    }
    const bool possible =
        0 < band.low_hz && band.low_hz < f0 && f0 < band.high_hz && band.high_hz < half_rate;
    if (!possible ||
        10 * band_pass_reach(band.low_hz, band.high_hz, recording.rate_hz) > recording.frames()) {
        return std::nullopt;
    }
    return band;
}

}  // namespace vybeg
