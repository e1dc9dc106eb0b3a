#include "ui/panels/reading.h"

#include "core/track/trend.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg::ui {

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
    if (std::max(from, to) - std::min(from, to) >=
        windows_apart(analysis.plan.length, analysis.plan.hop)) {
        difference.sd = std::hypot(a.sd, b.sd);
    }
    return difference;
}

QString exactText(double value) {
    return std::isnan(value) ? QString()
                             : QLocale().toString(value, 'g', QLocale::FloatingPointShortest);
}

}  // namespace vybeg::ui
