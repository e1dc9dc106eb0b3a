#include "ui/values/curve_data.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>

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

void append(CurveColumn& column, const CurveColumn& next, double half_turn) {
    column.missing = column.missing || next.missing;
    if (next.empty()) {
        return;
    }
    if (column.empty()) {
        column.time_first = next.time_first;
        column.first = next.first;
    } else {
        column.wraps = column.wraps || std::abs(next.first - column.last) > half_turn;
    }
    column.wraps = column.wraps || next.wraps;
    column.time_last = next.time_last;
    column.last = next.last;
    column.min = std::min(column.min, next.min);
    column.max = std::max(column.max, next.max);
    column.sum += next.sum;
    column.count += next.count;
    column.band_min = std::min(column.band_min, next.band_min);
    column.band_max = std::max(column.band_max, next.band_max);
    column.negative_max = std::max(column.negative_max, next.negative_max);
    column.positive_min = std::min(column.positive_min, next.positive_min);
}

CurveData::CurveData(std::shared_ptr<const Analysis> analysis, SlowVariable variable,
                     const DisplayScale& scale)
    : analysis_(std::move(analysis)),
      variable_(variable),
      time_(analysis_->track.time_s()),
      value_(analysis_->track.values(variable)),
      sd_(analysis_->track.sds(variable)),
      wrapped_(isWrapped(variable)) {
    if (variable == SlowVariable::delta_phi_CD) {
        joinTurns();
    }
    if (scale.period > 0) {
        wrapped_ = true;
        half_turn_ = scale.period / 2;
        middle_ = scale.middle;
        std::ranges::transform(value_, std::back_inserter(joined_),
                               [&scale](double value) { return scale.onBranch(value); });
        value_ = joined_;
    }
    for (std::size_t size = fan; size <= rows(); size *= fan) {
        std::vector<CurveColumn> level;
        level.reserve(rows() / size);
        for (std::size_t begin = 0; begin + size <= rows(); begin += size) {
            level.push_back(summarise(begin, begin + size));
        }
        levels_.push_back(std::move(level));
    }
    empty_ = std::none_of(value_.begin(), value_.end(), [](double v) { return std::isfinite(v); });
}

// A difference of phases about pi, whose track has values near pi and near -pi, is one curve; alpha
// goes round.
void CurveData::joinTurns() {
    constexpr double together = 0.5;  // length of the mean of the unit vectors
    bool turns = false;
    double last = std::nan("");
    for (const double value : value_) {
        if (std::isfinite(value)) {
            turns = turns || std::abs(value - last) > std::numbers::pi;
            last = value;
        }
    }
    if (!turns) {
        return;
    }
    std::complex<double> sum;
    double count = 0;
    for (const double value : value_) {
        if (std::isfinite(value)) {
            sum += std::polar(1., value);
            ++count;
        }
    }
    if (std::abs(sum) < together * count) {
        return;
    }
    // One branch, where noise would choose it.
    constexpr double turn = 2 * std::numbers::pi;
    constexpr double about_pi = 0.9 * std::numbers::pi;
    middle_ = std::arg(sum) < -about_pi ? std::arg(sum) + turn : std::arg(sum);
    joined_.assign(value_.begin(), value_.end());
    for (double& value : joined_) {
        value -= turn * std::round((value - middle_) / turn);
    }
    value_ = joined_;
}

// The time-critical loop of drawing, reduced to the needs of a row.
void CurveData::addRows(CurveColumn& column, std::size_t begin, std::size_t end) const {
    CurveColumn sum = column;
    const bool banded = !sd_.empty();
    std::size_t last_row = end;
    for (std::size_t row = begin; row < end; ++row) {
        const double value = value_[row];
        if (!std::isfinite(value)) {
            sum.missing = true;
            continue;
        }
        if (sum.empty()) {
            sum.time_first = time_[row];
            sum.first = value;
        } else if (wrapped_) {
            sum.wraps = sum.wraps || std::abs(value - sum.last) > half_turn_;
        }
        sum.last = value;
        last_row = row;
        sum.min = std::min(sum.min, value);
        sum.max = std::max(sum.max, value);
        sum.sum += value;
        ++sum.count;
        const double sd = banded && std::isfinite(sd_[row]) ? sd_[row] : 0;
        sum.band_min = std::min(sum.band_min, value - sd);
        sum.band_max = std::max(sum.band_max, value + sd);
        if (wrapped_ && value < middle_) {
            sum.negative_max = std::max(sum.negative_max, value);
        } else if (wrapped_) {
            sum.positive_min = std::min(sum.positive_min, value);
        }
    }
    if (last_row < end) {
        sum.time_last = time_[last_row];
    }
    column = sum;
}

CurveColumn CurveData::summarise(std::size_t begin, std::size_t end) const {
    CurveColumn column;
    std::size_t row = begin;
    while (row < end) {
        // The largest block that begins here.
        std::size_t size = 1;
        std::size_t level = 0;
        while (level < levels_.size() && row % (size * fan) == 0 && row + size * fan <= end) {
            size *= fan;
            ++level;
        }
        if (level == 0) {
            // Up to where the next block begins.
            size = std::min(fan - row % fan, end - row);
            addRows(column, row, row + size);
        } else {
            append(column, levels_[level - 1][row / size], half_turn_);
            column.wraps = column.wraps && wrapped_;
        }
        row += size;
    }
    return column;
}

std::vector<CurveColumn> CurveData::columns(const AxisRange& time, int count) const {
    std::vector<CurveColumn> result;
    const auto row_at = [&](double t) {
        return static_cast<std::size_t>(std::lower_bound(time_.begin(), time_.end(), t) -
                                        time_.begin());
    };
    std::size_t row = row_at(time.lower);
    row -= std::min<std::size_t>(row, 1);
    const std::size_t stop = std::min(rows(), row_at(time.upper) + 1);
    const double width = time.span() / count;
    // With fewer than two windows per column each window is drawn separately.
    const bool single = stop - std::min(stop, row) < 2 * static_cast<std::size_t>(count);
    bool before_has_value = false;
    double before = 0;
    std::size_t usual = stop - std::min(stop, row);  // estimated rows of a column
    while (row < stop) {
        std::size_t end = row + 1;
        if (!single) {
            const double next = (std::floor(time_[row] / width) + 1) * width;
            // Most columns have as many rows as the one before, give or take one.
            const std::size_t near =
                std::min(row + usual - std::min<std::size_t>(usual, 2), stop - 1);
            const std::size_t far = std::min(row + usual + 2, stop);
            const bool between = time_[near] < next && (far == stop || time_[far] >= next);
            const auto first = time_.begin() + static_cast<std::ptrdiff_t>(between ? near : row);
            const auto last = time_.begin() + static_cast<std::ptrdiff_t>(between ? far : stop);
            end = std::max(row + 1, static_cast<std::size_t>(std::lower_bound(first, last, next) -
                                                             time_.begin()));
            usual = end - row;
        }
        CurveColumn column = summarise(row, end);
        column.joined = before_has_value && std::isfinite(value_[row]) &&
                        !(wrapped_ && std::abs(value_[row] - before) > half_turn_);
        if (column.empty()) {
            column.time_first = time_[row];
            column.time_last = time_[end - 1];
        }
        before_has_value = std::isfinite(value_[end - 1]);
        before = value_[end - 1];
        result.push_back(column);
        row = end;
    }
    return result;
}

std::size_t CurveData::nearest(double time_s) const {
    const auto after = std::lower_bound(time_.begin(), time_.end(), time_s);
    if (after == time_.begin()) {
        return 0;
    }
    if (after == time_.end()) {
        return rows() - 1;
    }
    const auto before = after - 1;
    return static_cast<std::size_t>((time_s - *before <= *after - time_s ? before : after) -
                                    time_.begin());
}

Curves curvesOf(const std::shared_ptr<const Analysis>& analysis) {
    Curves curves;
    for (const SlowVariable variable : all_slow_variables) {
        curves.push_back(std::make_shared<const CurveData>(analysis, variable));
    }
    return curves;
}

bool covers(const Analysis& analysis, double time_s) {
    const auto times = analysis.track.time_s();
    if (times.size() < 2) {
        return !times.empty();
    }
    const double window_s = (times[1] - times[0]) * static_cast<double>(analysis.plan.length) /
                            static_cast<double>(analysis.plan.hop);
    return time_s >= times.front() - window_s && time_s <= times.back() + window_s;
}

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
