#include "ui/panels/reading.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg::ui {

namespace {

std::size_t apartIn(const Analysis& analysis) {
    return windows_apart(analysis.plan.length, analysis.plan.hop);
}

TrendOf kindOf(SlowVariable variable) {
    return variable == SlowVariable::a_A ? TrendOf::logarithm : TrendOf::value;
}

}  // namespace

std::size_t nearestRow(const Track& track, double time_s) {
    const auto times = track.time_s();
    const auto after = std::ranges::lower_bound(times, time_s);
    auto row = static_cast<std::size_t>(after - times.begin());
    if (row == times.size() || (row > 0 && time_s - times[row - 1] < times[row] - time_s)) {
        --row;
    }
    return row;
}

Reading readingAt(const Analysis& analysis, SlowVariable variable, std::size_t row,
                  const DisplayUnits& units) {
    const DisplayScale scale = displayScale(variable, units, analysis.f0_hz());
    const double stored = analysis.track.values(variable)[row];
    Reading reading;
    reading.value = scale.value(stored);
    if (info(variable).has_sd) {
        reading.sd = scale.sd(stored, analysis.track.sds(variable)[row]);
    }
    return reading;
}

Reading differenceOf(const Analysis& analysis, SlowVariable variable, std::size_t from,
                     std::size_t to, const DisplayUnits& units) {
    const Reading a = readingAt(analysis, variable, from, units);
    const Reading b = readingAt(analysis, variable, to, units);
    Reading difference;
    difference.value = b.value - a.value;
    if (isWrapped(variable)) {
        const double turn =
            2 * std::numbers::pi * displayScale(variable, units, analysis.f0_hz()).factor;
        difference.value = std::remainder(difference.value, turn);
    }
    if (std::max(from, to) - std::min(from, to) >= apartIn(analysis)) {
        difference.sd = std::hypot(a.sd, b.sd);
    }
    return difference;
}

std::optional<Trend> trendOf(const Analysis& analysis, SlowVariable variable, double from_s,
                             double to_s) {
    return line_trend(analysis.track, variable, std::min(from_s, to_s), std::max(from_s, to_s),
                      apartIn(analysis), kindOf(variable));
}

Reading rateOf(const Analysis& analysis, SlowVariable variable, const Trend& trend,
               const DisplayUnits& units) {
    const DisplayScale scale = displayScale(variable, units, analysis.f0_hz());
    const double middle = trendValue(variable, trend, trend.centre_s);
    // Of an exponential: its logarithm's rate times its value.
    const double stored = kindOf(variable) == TrendOf::logarithm ? middle : 1;
    // A change of one second's rate, as a deviation at the middle is converted, with its sign.
    const double rate = scale.sd(middle, std::abs(trend.slope_per_s) * stored);
    return {std::copysign(rate, trend.slope_per_s),
            scale.sd(middle, trend.sd_slope_per_s * stored)};
}

std::optional<Beat> beatOf(const Analysis& analysis, SlowVariable variable, double from_s,
                           double to_s) {
    return find_beat(analysis.track, variable, std::min(from_s, to_s), std::max(from_s, to_s),
                     apartIn(analysis));
}

Reading amplitudeOf(const Analysis& analysis, SlowVariable variable, const Beat& beat,
                    const DisplayUnits& units) {
    const DisplayScale scale = displayScale(variable, units, analysis.f0_hz());
    return {scale.sd(beat.value, beat.amplitude), scale.sd(beat.value, beat.sd_amplitude)};
}

double trendValue(SlowVariable variable, const Trend& trend, double time_s) {
    const double value = trend.at(time_s);
    return kindOf(variable) == TrendOf::logarithm ? std::exp(value) : value;
}

QString spreadsheetNumber(double value) {
    return std::isnan(value) ? QString()
                             : QLocale().toString(value, 'g', QLocale::FloatingPointShortest);
}

}  // namespace vybeg::ui
