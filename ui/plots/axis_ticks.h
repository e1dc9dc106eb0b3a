#pragma once

#include "ui/values/zoom_state.h"

#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

namespace vybeg::ui {

// Room for the tick labels of an axis.
struct TickRoom {
    double length = 0;                             // of the axis, pixels
    double spacing = 0;                            // least distance of two labelled ticks, pixels
    double gap = 0;                                // least distance between two labels, pixels
    std::function<double(const QString&)> extent;  // of a label along the axis, pixels
};

enum class TickSteps { decimal, degrees };

// Ticks of an axis. A label shows (position - offset) / 10^exponent: an axis of 5300.0001 ... 0002
// reads "100 ... 200", offset 5300, exponent -6. The exponent is a multiple of 3.
struct AxisTicks {
    std::vector<double> positions;
    std::vector<double> between;  // unlabelled ones
    QStringList labels;           // as many as positions
    double offset = 0;
    int offset_decimals = 0;  // decimal places of the offset
    int exponent = 0;

    // Suffix of the axis name, e.g. " − 5300"; empty without an offset.
    QString offsetText() const;
};

// Ticks of a linear axis: the finest step of 1, 2, 5 (degrees also 15, 30, 45, 90) with room for
// its labels. Labels have at most five digits; longer ones count from an offset.
AxisTicks linearTicks(const AxisRange& range, const TickRoom& room,
                      TickSteps steps = TickSteps::decimal);

// Ticks of a logarithmic axis, 0 < lower: decades, in between 2 and 5 where there is room, linear
// steps over less than a decade.
AxisTicks logTicks(const AxisRange& range, const TickRoom& room);

// Unit after the name: "mHz" for Hz and -3 if the unit takes prefixes, otherwise "×10⁻³ °".
QString scaledUnit(const QString& unit, bool takes_prefix, int exponent);

// Name of a time axis with offset and prefix: "t − 13.4 s, ms".
QString timeAxisName(const AxisTicks& ticks);

}  // namespace vybeg::ui
