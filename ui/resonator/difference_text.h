#pragma once

#include "core/analysis/passport.h"
#include "ui/widgets/quantity_table.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <string>
#include <vector>

namespace vybeg::ui {

// Columns of a comparison: verdict, difference in combined uncertainties, in its unit and in
// percent, then, now.
QStringList differenceHeaders();
std::vector<QuantityRow> differenceRows(const std::vector<Difference>& differences,
                                        const DisplayUnits& units, const Theme& theme);

// "= unchanged".
QString verdictText(Verdict verdict);

// The symbol of a difference: "Δf" of "split_hz", "Modes" of any of theirs.
QString differenceSymbol(const std::string& name);

// Reasons of parameters that are not comparable, one sentence per reason.
QStringList incomparableTexts(const std::vector<Difference>& differences);

}  // namespace vybeg::ui
