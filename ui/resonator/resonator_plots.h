#pragma once

#include "ui/plots/xy_plot.h"
#include "ui/values/run_set.h"
#include "ui/words/display_units.h"

namespace vybeg::ui {

// An identification as plots. Runs have the colours of their order in the set.

// d theta_A/dt against theta_A over the period of 90 degrees: measured points, fitted harmonics
// with their band, and the curve of the fitted resonator.
XYPlot driftPlot(const ResonatorOutcome& outcome, const DisplayUnits& units);

// Condition (30) of each run over time; structured model only.
XYPlot balancePlot(const ResonatorOutcome& outcome);

// Slow variable of a run to plot.
enum class TrackVariable { a_A, a_B, two_theta_A };

// Runs of an identification (lines) and of a passport (dashed).
XYPlot trackPlot(const ResonatorOutcome& outcome, const Passport& passport, TrackVariable variable,
                 const DisplayUnits& units);

}  // namespace vybeg::ui
