#pragma once

#include "core/analysis/analysis.h"
#include "ui/words/display_units.h"

#include <QString>

#include <cstddef>
#include <limits>

namespace vybeg::ui {

// A number in displayed units; NaN: none.
struct Reading {
    double value = std::numeric_limits<double>::quiet_NaN();
    double sd = std::numeric_limits<double>::quiet_NaN();
};

// Row of the window with the nearest centre. Precondition: the track is not empty.
std::size_t nearestRow(const Track& track, double time_s);

// The value of a window.
Reading readingAt(const Analysis& analysis, SlowVariable variable, std::size_t row,
                  const DisplayUnits& units);

// The difference between two windows, without deviation where they share samples. Wrapped angles
// differ by half a turn at most.
Reading differenceOf(const Analysis& analysis, SlowVariable variable, std::size_t from,
                     std::size_t to, const DisplayUnits& units);

// With the interface's decimal sign and all digits, for a spreadsheet; empty for NaN.
QString exactText(double value);

}  // namespace vybeg::ui
