#pragma once

#include "ui/plots/xy_plot.h"
#include "ui/values/run_set.h"
#include "ui/words/display_units.h"

namespace vybeg::ui {

// An identification as plots. Runs have the colours of their order in the set.

// d theta_A/dt against theta_A over the period of 90 degrees: the points measured, the harmonics
// fitted to them with their band, and the curve of the fitted resonator.
XYPlot driftPlot(const ResonatorOutcome& outcome, const DisplayUnits& units);

// Condition (30) of each run over time; of the structured model alone.
XYPlot balancePlot(const ResonatorOutcome& outcome);

// Which of a run's slow variables.
enum class TrackVariable { a_A, a_B, two_theta_A };

// The runs of an identification (lines) beside those of a passport (dashed).
XYPlot trackPlot(const ResonatorOutcome& outcome, const Passport& passport, TrackVariable variable,
                 const DisplayUnits& units);

}  // namespace vybeg::ui
