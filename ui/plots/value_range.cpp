#include "ui/plots/value_range.h"

#include <algorithm>
#include <cmath>

namespace vybeg::ui {
namespace {

// Least number of columns for the detection of spikes.
constexpr std::size_t too_few_to_judge = 20;

// Quantile: value below which a share of the list lies.
double quantile(std::vector<double> list, double share) {
    const auto index = static_cast<std::ptrdiff_t>(share * static_cast<double>(list.size() - 1));
    std::nth_element(list.begin(), list.begin() + index, list.end());
    return list[static_cast<std::size_t>(index)];
}

// Range from low to high without spikes: values beyond twice the range of 99 % of the columns are
// excluded.
AxisRange withoutSpikes(const std::vector<double>& lows, const std::vector<double>& highs) {
    const double low = *std::min_element(lows.begin(), lows.end());
    const double high = *std::max_element(highs.begin(), highs.end());
    if (lows.size() < too_few_to_judge) {
        return {low, high};
    }
    const double usual_low = quantile(lows, 0.01);
    const double usual_high = quantile(highs, 0.99);
    const double reach = 2 * (usual_high - usual_low);
    return reach > 0
               ? AxisRange{std::max(low, usual_low - reach), std::min(high, usual_high + reach)}
               : AxisRange{low, high};
}

}  // namespace

AxisRange displayedInterval(const DisplayScale& scale, double low, double high) {
    const double a = scale.value(low);
    const double b = scale.value(high);
    if (scale.decibels && low <= 0 && high >= 0) {
        const double top = std::max(a, b);
        return {top - 60, top};
    }
    return {std::min(a, b), std::max(a, b)};
}

void ValueRange::add(const std::vector<CurveColumn>& columns, const DisplayScale& scale,
                     bool bands) {
    for (const CurveColumn& column : columns) {
        if (column.empty()) {
            continue;
        }
        const AxisRange values = displayedInterval(scale, column.min, column.max);
        if (!std::isfinite(values.lower) || !std::isfinite(values.upper)) {
            continue;  // zero in decibels
        }
        lows_.push_back(values.lower);
        highs_.push_back(values.upper);
        if (bands) {
            const AxisRange band = displayedInterval(scale, column.band_min, column.band_max);
            band_lows_.push_back(std::isfinite(band.lower) ? band.lower : values.lower);
            band_highs_.push_back(std::isfinite(band.upper) ? band.upper : values.upper);
        }
    }
}

std::optional<AxisRange> ValueRange::range(bool logarithmic) const {
    if (lows_.empty()) {
        return std::nullopt;
    }
    AxisRange range = withoutSpikes(lows_, highs_);
    if (!band_lows_.empty()) {
        // A band may double the range of the data, and the range may always be three band widths
        // high.
        const double tail = band_lows_.size() < too_few_to_judge ? 0 : 0.05;
        const AxisRange band{quantile(band_lows_, tail), quantile(band_highs_, 1 - tail)};
        const double width = quantile(band_highs_, 0.5) - quantile(band_lows_, 0.5);
        const double room = std::max(0.5 * range.span(), std::min(width, band.span()));
        range = {std::clamp(band.lower, range.lower - room, range.lower),
                 std::clamp(band.upper, range.upper, range.upper + room)};
    }
    if (logarithmic) {
        if (!(range.upper > 0)) {
            return std::nullopt;
        }
        const double lower = std::max(range.lower, 1e-6 * range.upper);
        const double margin = std::max(std::pow(range.upper / lower, 0.06), 1.0005);
        return AxisRange{lower / margin, range.upper * margin};
    }
    // For constant data an axis that hides the rounding of their last digits.
    const double least = 1e-12 * std::max(std::abs(range.lower), std::abs(range.upper));
    if (range.span() <= least) {
        const double half = range.upper != 0 ? 1e-6 * std::abs(range.upper) : 1;
        return AxisRange{range.lower - half, range.upper + half};
    }
    const double margin = 0.08 * range.span();
    return AxisRange{range.lower - margin, range.upper + margin};
}

}  // namespace vybeg::ui
