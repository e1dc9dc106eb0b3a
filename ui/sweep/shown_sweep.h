#pragma once

#include "core/sweep/window_sweep.h"
#include "ui/plots/xy_plot.h"
#include "ui/widgets/quantity_table.h"
#include "ui/words/display_units.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace vybeg::ui {

// The choices of a view of a sweep.
struct SweepView {
    std::size_t variable = 0;           // of main_slow_variables
    std::optional<std::size_t> chosen;  // of WindowSweep::lengths
    DisplayUnits units;
    QString channel_unit;
};

// Scatter, stated deviation, bound, shift by motion and leakage of one variable over the length of
// the window, both axes logarithmic. Series 0: the scatter, with a point for each length.
XYPlot scatterPlot(const WindowSweep* sweep, const SweepView& view);
// Root mean square of the residual and the noise per sample from it. Series 0: the noise.
XYPlot residualPlot(const WindowSweep* sweep, const SweepView& view);

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
