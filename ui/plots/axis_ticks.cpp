#include "ui/plots/axis_ticks.h"

#include "ui/words/display_units.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {
namespace {

int decade(double x) {
    return static_cast<int>(std::floor(std::log10(x) + 1e-9));
}

// Decimal places of a multiple of `step`.
int decimalsOf(double step) {
    for (int decimals = 0; decimals < 15; ++decimals) {
        const double scaled = step * std::pow(10., decimals);
        if (std::abs(scaled - std::round(scaled)) < 1e-6 * scaled) {
            return decimals;
        }
    }
    return 15;
}

// The steps from about `least` on, ascending, a few decades of them.
std::vector<double> stepsFrom(double least, TickSteps steps) {
    std::vector<double> list;
    for (int power = decade(least); power < decade(least) + 4; ++power) {
        const double unit = std::pow(10., power);
        if (steps == TickSteps::degrees && power == 1) {
            list.insert(list.end(), {10, 15, 30, 45});
        } else if (steps == TickSteps::degrees && power == 2) {
            list.insert(list.end(), {90, 180, 360, 720});
        } else {
            list.insert(list.end(), {unit, 2 * unit, 5 * unit});
        }
    }
    std::erase_if(list, [&](double step) { return step < least * (1 - 1e-9); });
    return list;
}

void chooseOffset(AxisTicks& ticks, const AxisRange& range, double step) {
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    constexpr int most_digits = 5;
    if (decade(largest) - decade(step) + 1 > most_digits) {
        const int power = static_cast<int>(std::ceil(std::log10(range.span()) - 1e-9));
        const double unit = std::pow(10., power);
        ticks.offset = std::round(0.5 * (range.lower + range.upper) / unit) * unit;
        ticks.offset_decimals = std::max(0, -power);
    }
    const double shown =
        std::max(std::abs(range.lower - ticks.offset), std::abs(range.upper - ticks.offset));
    // With an offset every small number gets a prefix; without one 0.05 remains as it is.
    const double small = ticks.offset != 0 ? 1 : 0.01;
    if (shown < small || shown >= 1e5) {
        const int exponent = 3 * static_cast<int>(std::floor(decade(shown) / 3.));
        ticks.exponent = std::clamp(exponent, -15, 12);
    }
}

AxisTicks ticksOfStep(const AxisRange& range, double step) {
    AxisTicks ticks;
    chooseOffset(ticks, range, step);
    const double unit = std::pow(10., ticks.exponent);
    const int decimals = decimalsOf(step / unit);
    // Counted from the offset, so that positions far from zero keep their precision.
    const double slack = 1e-9 * range.span();
    const auto first =
        static_cast<long long>(std::ceil((range.lower - ticks.offset - slack) / step));
    const auto last =
        static_cast<long long>(std::floor((range.upper - ticks.offset + slack) / step));
    for (long long k = first; k <= last; ++k) {
        const double relative = static_cast<double>(k) * step;
        ticks.positions.push_back(ticks.offset + relative);
        ticks.labels.push_back(numberLabel(relative / unit, decimals));
    }
    const double mantissa = step / std::pow(10., decade(step));
    const int parts = std::abs(mantissa - 2) < 1e-6 ? 4 : 5;
    for (long long k = (first - 1) * parts; k <= (last + 1) * parts; ++k) {
        const double position = ticks.offset + static_cast<double>(k) * step / parts;
        if (k % parts != 0 && range.contains(position)) {
            ticks.between.push_back(position);
        }
    }
    return ticks;
}

bool labelsFit(const AxisTicks& ticks, double pixels_apart, const TickRoom& room) {
    return std::all_of(ticks.labels.begin(), ticks.labels.end(), [&](const QString& label) {
        return room.extent(label) + room.gap <= pixels_apart;
    });
}

AxisTicks firstAndLast(AxisTicks ticks) {
    ticks.positions = {ticks.positions.front(), ticks.positions.back()};
    ticks.labels = {ticks.labels.first(), ticks.labels.last()};
    return ticks;
}

// Linear ticks of less than a decade, without those too close to a neighbour.
AxisTicks thinned(const AxisTicks& all, const AxisRange& range, const TickRoom& room) {
    AxisTicks ticks = all;
    ticks.positions.clear();
    ticks.labels.clear();
    const double scale = room.length / std::log(range.upper / range.lower);
    double free_from = -1e300;
    for (qsizetype i = 0; i < all.labels.size(); ++i) {
        const double position = all.positions[static_cast<std::size_t>(i)];
        const double pixel = scale * std::log(position / range.lower);
        const double half = 0.5 * room.extent(all.labels[i]);
        if (pixel - half >= free_from) {
            ticks.positions.push_back(position);
            ticks.labels.push_back(all.labels[i]);
            free_from = pixel + half + room.gap;
        }
    }
    return ticks;
}

}  // namespace

QString AxisTicks::offsetText() const {
    if (offset == 0) {
        return {};
    }
    return (offset > 0 ? QStringLiteral(" − ") : QStringLiteral(" + ")) +
           numberLabel(std::abs(offset), offset_decimals);
}

AxisTicks linearTicks(const AxisRange& range, const TickRoom& room, TickSteps steps) {
    const double span = range.span();
    if (!(span > 0) || !std::isfinite(span) || room.length < 1) {
        return {};
    }
    // A single tick does not show the scale, so short axes get two that are closer than the
    // spacing, or the first and the last of a step too fine to label all.
    constexpr double closest = 8;
    AxisTicks coarsest_pair;
    AxisTicks ends;
    for (const double step : stepsFrom(span * std::min(1., closest / room.length), steps)) {
        AxisTicks ticks = ticksOfStep(range, step);
        const double apart = step / span * room.length;
        const bool pair = ticks.positions.size() >= 2;
        if (!labelsFit(ticks, apart, room)) {
            const double between = apart * static_cast<double>(ticks.positions.size() - 1);
            if (pair && labelsFit(ticks, between, room)) {
                ends = firstAndLast(std::move(ticks));
            }
            continue;
        }
        if (pair) {
            coarsest_pair = std::move(ticks);
        }
        if (apart >= room.spacing) {
            break;
        }
    }
    return coarsest_pair.positions.empty() ? ends : coarsest_pair;
}

AxisTicks logTicks(const AxisRange& range, const TickRoom& room) {
    if (!(range.lower > 0) || !(range.span() > 0) || !std::isfinite(range.upper)) {
        return {};
    }
    const double decades = std::log10(range.upper / range.lower);
    if (decades < 1) {
        return thinned(linearTicks(range, room), range, room);
    }
    const double per_decade = room.length / decades;
    const double need = std::max(room.spacing, room.extent(QStringLiteral("10⁻³")) + room.gap);
    const int stride = std::max(1, static_cast<int>(std::ceil(need / per_decade)));
    const bool finer = per_decade * std::log10(2.) > need;
    AxisTicks ticks;
    for (int power = decade(range.lower); power <= decade(range.upper); ++power) {
        const double unit = std::pow(10., power);
        for (int digit = 1; digit < 10; ++digit) {
            const double position = digit * unit;
            if (position < range.lower * (1 - 1e-9) || position > range.upper * (1 + 1e-9)) {
                continue;
            }
            const bool labelled =
                digit == 1 ? power % stride == 0 : finer && (digit == 2 || digit == 5);
            if (!labelled) {
                ticks.between.push_back(position);
                continue;
            }
            ticks.positions.push_back(position);
            const bool plain = -3 <= power && power <= 4;
            ticks.labels.push_back(
                plain ? numberLabel(position, std::max(0, -power))
                      : (digit == 1 ? QString() : QStringLiteral("%1·").arg(digit)) +
                            powerOfTen(power));
        }
    }
    return ticks;
}

QString scaledUnit(const QString& unit, bool takes_prefix, int exponent) {
    if (exponent == 0) {
        return unit;
    }
    if (takes_prefix) {
        return siPrefix(exponent) + unit;
    }
    const QString factor = QStringLiteral("×") + powerOfTen(exponent);
    return unit.isEmpty() ? factor : factor + ' ' + unit;
}

QString timeAxisName(const AxisTicks& ticks) {
    const QString second = QCoreApplication::translate("DisplayUnits", "s");
    const QString offset = ticks.offset == 0 ? QString() : ticks.offsetText() + ' ' + second;
    return QStringLiteral("t") + offset + QStringLiteral(", ") +
           scaledUnit(second, true, ticks.exponent);
}

}  // namespace vybeg::ui
