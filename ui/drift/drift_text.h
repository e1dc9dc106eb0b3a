#pragma once

#include "core/drift/whole_angle_drift.h"
#include "ui/plots/xy_plot.h"
#include "ui/widgets/quantity_table.h"
#include "ui/words/display_units.h"

#include <QStringList>

#include <vector>

namespace vybeg::ui {

// The drift of whole-angle logs as plot, tables and sentences in the interface's language. Angles
// in the units of display, their rates in rad/s or degrees per hour.

// d theta_A/dt less the turn against theta_A over half a turn: means of ranges with their standard
// deviations, and the harmonics with their band, where all of them have a common value. The range
// of the values is that of the means: where no wave was the band may be boundless.
XYPlot wholeAnglePlot(const WholeAngleDrift& drift, const DisplayUnits& units);
inline constexpr std::size_t whole_angle_means = 0;  // its series

// Of one of its logs, and that it is left out.
QString logName(const WholeAngleDrift& drift, std::size_t log);

// Turn and harmonics, and the data of each log: a column for all logs and, of several, one for
// each.
QStringList logHeaders(const WholeAngleDrift& drift);
std::vector<QuantityRow> logRows(const WholeAngleDrift& drift, const DisplayUnits& units);

// Damping and split, one column: values or the reasons for their absence.
std::vector<QuantityRow> heldRows(const HeldResonator& resonator, const DisplayUnits& units);

// Whether the logs agree, a sentence for each harmonic; of one log, that it is not known.
QStringList agreementTexts(const WholeAngleDrift& drift);

// What u holds.
QString channelsText(const ChannelTolerance& channels);

}  // namespace vybeg::ui
