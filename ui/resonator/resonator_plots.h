#pragma once

#include "ui/charts/round_plot.h"
#include "ui/document/document.h"
#include "ui/plots/xy_plot.h"
#include "ui/values/recording_set.h"
#include "ui/words/display_units.h"

#include <optional>
#include <vector>

namespace vybeg::ui {

// The number of the curveStyle() that ledger and tracks give a recording; none without an analysis.
std::optional<int> styleOf(const Document& document, RecordingId recording);

// An identification as plots. Recordings have these numbers of curveStyle(), without them those of
// their order in the set.
using RunStyles = std::vector<int>;
// Those of ledger and tracks.
RunStyles runStyles(const Document& document, const SetResult& outcome);

// d theta_A/dt against theta_A over the period of 90 degrees: measured points, fitted harmonics
// with their band, and the curve of the fitted resonator.
XYPlot driftPlot(const SetResult& outcome, const DisplayUnits& units, const RunStyles& styles = {});

// What condition (30) is drawn against.
enum class BalanceAxis { time, angle };

// Condition (30) of each run; structured model only.
XYPlot balancePlot(const SetResult& outcome, BalanceAxis axis, const DisplayUnits& units,
                   const RunStyles& styles = {});

// The rim from above: electrodes, axes of stiffness and damping with their standard deviations, and
// the wave of each recording at its start. Empty for the free model.
RoundPlot rimPlot(const SetResult& outcome, const RunStyles& styles = {});

// a_A, a_B or 2theta_A of the runs of an identification and, in a shade further from the
// background, of a passport.
XYPlot trackPlot(const SetResult& outcome, const Passport& passport, SlowVariable variable,
                 const DisplayUnits& units, const RunStyles& styles = {});

}  // namespace vybeg::ui
