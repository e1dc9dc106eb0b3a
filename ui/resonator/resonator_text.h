#pragma once

#include "ui/values/run_set.h"
#include "ui/widgets/quantity_table.h"
#include "ui/words/display_units.h"

#include <vector>

namespace vybeg::ui {

// An identification as tables: names and units in the interface's language, values rounded by their
// standard deviations, sentences where there is no value. Angles in the units of display, their
// rates in rad/s or degrees per hour.

// One column for each recording: what its wave did.
std::vector<QuantityRow> waveRows(const Identification& found, const DisplayUnits& units);
// One column: the value. Of the free model, none.
std::vector<QuantityRow> resonatorRows(const Identification& found, const DisplayUnits& units);
// What usual errors of the channels would change, a column each; parameters that are given.
QStringList sensitivityHeaders();
std::vector<QuantityRow> sensitivityRows(const Identification& found, const DisplayUnits& units);
// One column; one row with the reason where the modes cannot be told apart.
std::vector<QuantityRow> modeRows(const ResonatorFit& fit);
// One column for each recording.
std::vector<QuantityRow> runRows(const Identification& found, const DisplayUnits& units);
// One column: mean and harmonics of the drift function, or why it is not known.
std::vector<QuantityRow> driftRows(const Identification& found, const DisplayUnits& units);

// Sentences about the result.
QStringList warningTexts(const ResonatorOutcome& outcome);

// What was found in the recordings, each with their names.
QStringList findingTexts(const ResonatorOutcome& outcome);

}  // namespace vybeg::ui
