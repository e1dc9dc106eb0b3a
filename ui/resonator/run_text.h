#pragma once

#include "core/analysis/identify.h"
#include "ui/widgets/quantity_table.h"
#include "ui/words/display_units.h"

#include <vector>

namespace vybeg::ui {

// Values of the recordings, a row for each quantity: by themselves, or concise in the unit and
// power of ten that its name has, for QuantityTable::setColumns(), with reasons and u as tips.
enum class RunForm { apart, column };
// Motion of the wave.
std::vector<QuantityRow> waveRows(const Identification& found, const DisplayUnits& units,
                                  RunForm form = RunForm::apart);
// What the fit found of the recordings.
std::vector<QuantityRow> runRows(const Identification& found, const DisplayUnits& units,
                                 RunForm form = RunForm::apart);

}  // namespace vybeg::ui
