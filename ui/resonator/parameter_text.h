#pragma once

#include "core/analysis/passport.h"
#include "core/resonator/model/reason.h"
#include "ui/widgets/quantity_table.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <limits>
#include <string>
#include <vector>

namespace vybeg::ui {

// Texts and cells of the tables of a resonator.

// Display of a parameter of resonator_parameters.h, of a mode ("modes[0].f_hz", "Mode 1: f") or of
// the direction of a run ("runs[0].direction.f_hz"): stored values times `factor`.
struct Shown {
    QString title;
    QString tip;
    QString unit;
    double factor = 1;
};

Shown shownAs(const std::string& name, const char* unit, const DisplayUnits& units);

QuantityCell valueCell(double value, double sd,
                       double u = std::numeric_limits<double>::quiet_NaN());
// A text as a cell.
QuantityCell sentenceCell(const QString& text);
// The value, or the reason for its absence.
QuantityCell cellOf(const Estimate& estimate, double factor = 1);
// "≠ +0.8 ± 0.1": a change since the passport, its sign and colour those of the verdict.
QuantityCell changeCell(const Difference& difference, double factor, const Theme& theme);
// The power of ten of a column whose greatest number has no more than so many digits.
int columnPower(double most, int digits);
QuantityRow rowOf(const Shown& shown, std::vector<QuantityCell> cells = {});

// Displayed unit and factor of angles (rad) and of their rates (rad/s).
QString angleUnit(const DisplayUnits& units);
double angleFactor(const DisplayUnits& units);
QString angleRateUnit(const DisplayUnits& units);
double angleRateFactor(const DisplayUnits& units);

// Columns of a comparison: verdict, difference in combined uncertainties, in its unit and in
// percent, value of the passport; the present one is in the tables of the parameters.
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
