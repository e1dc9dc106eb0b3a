#pragma once

#include "ui/charts/round_plot.h"
#include "ui/plots/xy_plot.h"
#include "ui/values/recording_set.h"
#include "ui/words/display_units.h"

namespace vybeg::ui {

// An identification as plots. Runs have the colours of their order in the set.

// d theta_A/dt against theta_A over the period of 90 degrees: measured points, fitted harmonics
// with their band, and the curve of the fitted resonator.
XYPlot driftPlot(const SetResult& outcome, const DisplayUnits& units);

// What condition (30) is drawn against.
enum class BalanceAxis { time, angle };

// Condition (30) of each run; structured model only.
XYPlot balancePlot(const SetResult& outcome, BalanceAxis axis, const DisplayUnits& units);

// The rim from above: electrodes, axes of stiffness and damping with their standard deviations, and
// the wave of each recording at its start. Empty for the free model.
RoundPlot rimPlot(const SetResult& outcome);

// a_A, a_B or 2theta_A of the runs of an identification (lines) and of a passport (dashed).
XYPlot trackPlot(const SetResult& outcome, const Passport& passport, SlowVariable variable,
                 const DisplayUnits& units);

}  // namespace vybeg::ui
