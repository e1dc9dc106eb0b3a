#pragma once

#include "core/sweep/window_sweep.h"
#include "ui/sweep/sweep_plots.h"
#include "ui/widgets/quantity_table.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace vybeg::ui {

// E.g. "n = 60, 1.80 ms, 9.54 periods".
QString lengthText(const WindowSweep& sweep, std::size_t length);
// The recommended window and why, or why there is none.
QString adviceText(const WindowSweep& sweep, const SweepView& view);
// Lengths that the recording does not permit, with the reason; empty without such.
QString refusedText(const WindowSweep& sweep);
// One length and the values of the variable that is shown.
QString pointText(const WindowSweep& sweep, std::size_t length, const SweepView& view);

// A row for each length, of the variable that is shown.
QStringList sweepHeaders(const WindowSweep& sweep, const SweepView& view);
std::vector<QuantityRow> sweepRows(const WindowSweep& sweep, const SweepView& view);
// All variables as tab-separated text, in the decimal sign of the interface's language.
QString sweepTable(const WindowSweep& sweep, const SweepView& view);

}  // namespace vybeg::ui
