#pragma once

#include "core/analysis/measurement_list.h"
#include "core/base/diagnostic.h"
#include "core/resonator/results/resonator_parameters.h"
#include "ui/values/recording_set.h"
#include "ui/widgets/quantity_table.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace vybeg::ui {

// The conditions of a recording in a measurement list, a line each: "gyro: G7", "bias: 100 V", ...
QStringList conditionsText(const RecordingRef& recording);

// An identification as tables: names and units in the interface's language, values rounded by their
// standard deviations, reasons for missing values. Angles in the units of display, their rates in
// rad/s or degrees per hour.

// Columns of the value, of u where it differs from the standard deviation, of the limit and of the
// change since a passport, some without any text; no rows for the free model.
QStringList resonatorHeaders();
std::vector<QuantityRow> resonatorRows(const Identification& found, const DisplayUnits& units,
                                       const std::vector<ParameterLimit>& limits = {},
                                       const std::vector<Difference>& differences = {},
                                       const Theme& theme = lightTheme());
// The given parameters, of the free model its modes, with the expanded uncertainty U = 2u; a
// parameter with limits is there without a value, too. Where there are limits, a second column has
// them.
std::vector<QuantityRow> resultRows(const Identification& found, const DisplayUnits& units,
                                    const std::vector<ParameterLimit>& limits);
// Titles of the parameters that the recordings do not show.
QStringList absentTitles(const Identification& found, const DisplayUnits& units);
// By how much errors of a usual size falsify the given parameters: a row for each error, a column
// for each parameter, in one unit and power of ten.
QStringList sensitivityHeaders(const Identification& found, const DisplayUnits& units);
std::vector<QuantityRow> sensitivityRows(const Identification& found, const DisplayUnits& units);
// One column; one row with the reason if the modes are not separated.
std::vector<QuantityRow> modeRows(const ResonatorFit& fit);
// One column: mean and harmonics of the drift function, or the reason for its absence.
std::vector<QuantityRow> driftRows(const Identification& found, const DisplayUnits& units);
// "Mean drift 0.005(15), cos 4θ_A 7.396(15), … °/h".
QString driftSentence(const std::vector<QuantityRow>& rows, const DisplayUnits& units);
// In place of a parameter that is not given, with a mark of the reason: "taken as zero *".
QString absenceWord(const ResonatorParameter& parameter, const Reason& reason,
                    const DisplayUnits& units);

QString modelText(ResonatorModel model);
// "Structured model; χ²/ν = 1.01".
QString fitText(const ResonatorFit& fit);

// The source of a part of u, e.g. "Delay (assumed)" where its tolerance is not stated.
QString toleranceName(ErrorSource source, const IdentifySettings& settings);
// The tolerances in u, a text for each, e.g. "Delay (assumed): 10 ns".
QStringList toleranceTexts(const IdentifySettings& settings);
bool anyAssumed(const IdentifySettings& settings);
// The clock that the frequencies follow, where its tolerance is not stated; or empty.
QString clockText(const IdentifySettings& settings);
// What ± and u hold, and whose clock the frequencies follow; in short.
QString uncertaintyText(const Identification& found);
QString uncertaintyWords(const Identification& found);

// What of the calibration a result shows to be another one than it was identified with.
struct FoundCalibration {
    std::optional<Estimate> kappa;
    std::optional<double> delay_d_s;  // the whole one, to two digits of the change
    bool offsets = false;             // the channels have some, and none are taken out
};
FoundCalibration foundCalibration(const Identification& found);
// Links that offer it: "kappa", "delay", "offset".
QString calibrationOffers(const FoundCalibration& found);

// Findings in the recordings, each with the names of the recordings, the worst first.
std::vector<Finding> recordingFindings(const SetResult& outcome);

}  // namespace vybeg::ui
