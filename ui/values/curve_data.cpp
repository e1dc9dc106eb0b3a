#include "ui/values/curve_data.h"

#include "ui/words/display_units.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg::ui {
void append(CurveColumn& column, const CurveColumn& next) {
    column.missing = column.missing || next.missing;
    if (next.empty()) {
        return;
    }
    if (column.empty()) {
        column.time_first = next.time_first;
        column.first = next.first;
    } else {
        column.wraps = column.wraps || std::abs(next.first - column.last) > std::numbers::pi;
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

CurveData::CurveData(std::shared_ptr<const Analysis> analysis, SlowVariable variable)
    : analysis_(std::move(analysis)),
      variable_(variable),
      time_(analysis_->track.time_s()),
      value_(analysis_->track.values(variable)),
      sd_(analysis_->track.sds(variable)),
      wrapped_(isWrapped(variable)) {
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

double CurveData::sd(std::size_t row) const {
    return sd_.empty() ? std::numeric_limits<double>::quiet_NaN() : sd_[row];
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
            sum.wraps = sum.wraps || std::abs(value - sum.last) > std::numbers::pi;
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
        if (wrapped_ && value < 0) {
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
            append(column, levels_[level - 1][row / size]);
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
                        !(wrapped_ && std::abs(value_[row] - before) > std::numbers::pi);
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

}  // namespace vybeg::ui
