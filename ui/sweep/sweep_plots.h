#pragma once

#include "core/sweep/window_sweep.h"
#include "ui/plots/xy_plot.h"
#include "ui/words/display_units.h"

#include <QCoreApplication>

#include <optional>

namespace vybeg::ui {

// Texts of the page Windows in the language of the window.
struct SweepWords {
    Q_DECLARE_TR_FUNCTIONS(Sweep)
};

// What is shown of a sweep.
struct SweepView {
    std::size_t variable = 0;           // of main_slow_variables
    std::optional<std::size_t> chosen;  // of WindowSweep::lengths
    DisplayUnits units;
    QString channel_unit;
};

// Factor from stored to displayed values, and the unit; decibels do not apply to deviations.
double sweepFactor(const WindowSweep& sweep, const SweepView& view, std::size_t variable);
QString sweepUnit(const SweepView& view, std::size_t variable);

// Scatter, stated deviation, bound, shift by motion and leakage of one variable over the length of
// the window, both axes logarithmic. Series 0: the scatter, with a point for each length.
XYPlot scatterPlot(const WindowSweep* sweep, const SweepView& view);
// Root mean square of the residual and the noise per sample from it. Series 0: the noise.
XYPlot residualPlot(const WindowSweep* sweep, const SweepView& view);

}  // namespace vybeg::ui
