#include "ui/resonator/resonator_text.h"

#include "core/base/number_text.h"
#include "core/output/identify_json.h"
#include "core/resonator/results/resonator_parameters.h"
#include "ui/panels/measuring.h"
#include "ui/plots/axis_ticks.h"
#include "ui/resonator/parameter_text.h"
#include "ui/words/error_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vybeg::ui {

QStringList conditionsText(const RecordingRef& recording) {
    QStringList lines;
    const auto add = [&lines](const QString& name, const QString& text) {
        if (!text.isEmpty()) {
            lines << QStringLiteral("%1: %2").arg(name, text);
        }
    };
    const auto number = [](const std::optional<double>& value, const QString& with_unit) {
        return value ? with_unit.arg(shortNumberText(*value, 6)) : QString();
    };
    const Conditions& told = recording.conditions;
    add(ResonatorWords::tr("gyro"), QString::fromStdString(told.gyro));
    add(ResonatorWords::tr("date"), QString::fromStdString(told.date));
    add(ResonatorWords::tr("bias voltage"), number(told.bias_v, ResonatorWords::tr("%1 V")));
    add(ResonatorWords::tr("temperature"), number(told.temperature_c, ResonatorWords::tr("%1 °C")));
    if (told.exchanged) {
        lines << ResonatorWords::tr("the amplifiers are exchanged");
    }
    add(ResonatorWords::tr("operator"), QString::fromStdString(told.operator_name));
    add(ResonatorWords::tr("comment"), QString::fromStdString(told.comment));
    for (const auto& [column, field] : recording.others) {
        add(QString::fromStdString(column), QString::fromStdString(field));
    }
    return lines;
}

namespace {

// Change of a parameter, in its standard deviations, below which it is not shown.
constexpr double negligible = 0.01;
constexpr int limit_digits = 8;

// Names of a tolerance and of an error of usual size.
struct SourceWords {
    const char* tolerance;
    const char* usual;
};
constexpr std::array<SourceWords, error_sources> source_words{{
    {QT_TRANSLATE_NOOP("Resonator", "Gain ratio"), QT_TRANSLATE_NOOP("Resonator", "0.001 of κ")},
    {QT_TRANSLATE_NOOP("Resonator", "Non-orthogonality"),
     QT_TRANSLATE_NOOP("Resonator", "0.1° of non-orthogonality")},
    {QT_TRANSLATE_NOOP("Resonator", "Delay"), QT_TRANSLATE_NOOP("Resonator", "10 ns of delay")},
    {QT_TRANSLATE_NOOP("Resonator", "Crosstalk"),
     QT_TRANSLATE_NOOP("Resonator", "10⁻⁴ of crosstalk")},
    {QT_TRANSLATE_NOOP("Resonator", "Phase drift"),
     QT_TRANSLATE_NOOP("Resonator", "10⁻⁴ rad of phase drift")},
    {QT_TRANSLATE_NOOP("Resonator", "Gain drift"),
     QT_TRANSLATE_NOOP("Resonator", "10⁻⁴ of gain drift")},
    {QT_TRANSLATE_NOOP("Resonator", "Sample rate"), ""},
    {QT_TRANSLATE_NOOP("Resonator", "Spread"), ""},
    {"", QT_TRANSLATE_NOOP("Resonator", "10 µHz by amplitude")},
    {"", QT_TRANSLATE_NOOP("Resonator", "1 % of damping by amplitude")},
    {"", QT_TRANSLATE_NOOP("Resonator", "0.1 % of gain by amplitude")},
    {"", QT_TRANSLATE_NOOP("Resonator", "10 µHz between the axes by amplitude")},
    {"", QT_TRANSLATE_NOOP("Resonator", "10⁻⁶ rad/s of the 8th harmonic of drift")},
}};
static_assert(source_words.back().usual != nullptr);

// What errors of usual size would change of a parameter: a column of one unit and power of ten, of
// which the greatest change has three digits.
struct Changes {
    QString head;
    std::vector<QuantityCell> cells;  // as usual_errors
};

Changes changesOf(const Shown& shown, const Estimate& estimate, const BySource& sensitivity) {
    std::array<double, usual_errors.size()> changes{};
    double most = 0;
    for (std::size_t k = 0; k < changes.size(); ++k) {
        changes[k] = shown.factor * usual_errors[k].size * sensitivity[usual_errors[k].source];
        most = std::max(most, std::abs(changes[k]));
    }
    const double least = std::abs(shown.factor) * negligible * estimate.sd;
    most = most > least ? most : 0;
    const int digit = most > 0 ? static_cast<int>(std::floor(std::log10(most))) : 0;
    constexpr int most_digits = 4;
    const int power = columnPower(most, most_digits);
    const int decimals = std::max(0, 2 - digit + power);
    const double unit = std::pow(10., power);
    Changes column{withUnit(shown.title.section(QLatin1Char(' '), -1),
                            scaledUnit(shown.unit, shown.unit == unitText("Hz"), power)),
                   {}};
    for (const double change : changes) {
        const double scaled = change / unit;
        const bool seen =
            std::abs(change) > least && std::abs(scaled) >= 0.5 * std::pow(10., -decimals);
        column.cells.push_back({seen ? numberLabel(scaled, decimals) : QStringLiteral("≈ 0"),
                                {exactText(scaled)},
                                {}});
    }
    return column;
}

std::vector<Changes> allChanges(const Identification& found, const DisplayUnits& units) {
    std::vector<Changes> columns;
    for (std::size_t k = 0; k < found.fit.sensitivities.size(); ++k) {
        const ResonatorParameter& parameter = resonator_parameters[k];
        const Estimate& estimate = found.fit.resonator.*parameter.member;
        if (estimate.given()) {
            columns.push_back(changesOf(shownAs(parameter.name, parameter.unit, units), estimate,
                                        found.fit.sensitivities[k]));
        }
    }
    return columns;
}

// "✓ ≤ 0.001": a limit and whether the parameter keeps it, by a sign and a colour; without a limit
// empty.
QuantityCell limitCell(const ResonatorParameter& parameter, const Estimate& estimate,
                       const std::vector<ParameterLimit>& limits, double factor,
                       const Theme& theme) {
    const ParameterLimit* limit = limit_of(limits, parameter.name);
    if (!limit) {
        return {{}, {QString()}, {}};
    }
    struct Look {
        const char* sign;
        QColor color;
    };
    const std::array looks{Look{"?", {}}, Look{"✓", theme.kept}, Look{"✗", theme.broken}};
    QString text;
    for (const auto& [sign, value] :
         {std::pair{" ≥ ", limit->lower}, std::pair{" ≤ ", limit->upper}}) {
        if (value) {
            text += sign + shortNumberText(factor * *value, limit_digits);
        }
    }
    const Look& look = looks.at(static_cast<std::size_t>(conformity(estimate, *limit)));
    text.prepend(QString::fromUtf8(look.sign));
    return {text, {text}, look.color};
}

// One row with the reason if the modes are not separated.
template <class Cell>
std::vector<QuantityRow> rowsOfModes(const ResonatorFit& fit, const Cell& cell) {
    std::vector<QuantityRow> rows;
    if (fit.modes.empty()) {
        rows.push_back({ResonatorWords::tr("Modes"), {}, {sentenceCell(reasonText(fit.no_modes))}});
    }
    for (std::size_t k = 0; k < fit.modes.size(); ++k) {
        for (const ModeParameter& parameter : mode_parameters) {
            const std::string name = "modes[" + std::to_string(k) + "]." + parameter.name;
            rows.push_back(
                rowOf(shownAs(name, parameter.unit, {}), {cell(fit.modes[k].*parameter.member)}));
        }
    }
    return rows;
}

}  // namespace

QStringList resonatorHeaders() {
    return {ResonatorWords::tr("Value"), QStringLiteral("u"), ResonatorWords::tr("Limits"),
            ResonatorWords::tr("Since the passport")};
}

std::vector<QuantityRow> resonatorRows(const Identification& found, const DisplayUnits& units,
                                       const std::vector<ParameterLimit>& limits,
                                       const std::vector<Difference>& differences,
                                       const Theme& theme) {
    std::vector<QuantityRow> rows;
    if (found.fit.model == ResonatorModel::free) {
        return rows;
    }
    const bool any_u =
        std::ranges::any_of(resonator_parameters, [&found](const ResonatorParameter& parameter) {
            const Estimate& estimate = found.fit.resonator.*parameter.member;
            return estimate.given() && estimate.uncertainty() > estimate.sd;
        });
    for (const ResonatorParameter& parameter : resonator_parameters) {
        const Shown shown = shownAs(parameter.name, parameter.unit, units);
        const double factor = shown.factor;
        const Estimate& estimate = found.fit.resonator.*parameter.member;
        QuantityCell value = cellOf(estimate, factor);
        QuantityCell u;
        if (estimate.given()) {
            value.text = valueText(factor * estimate.value, factor * estimate.sd);
            u.text = any_u ? uncertaintyLabel(factor * estimate.value, factor * estimate.sd,
                                              factor * estimate.u)
                           : QString();
        }
        const auto change = std::ranges::find(differences, parameter.name, &Difference::name);
        rows.push_back(
            rowOf(shown, {value, u, limitCell(parameter, estimate, limits, factor, theme),
                          change == differences.end() ? QuantityCell{{}, {QString()}, {}}
                                                      : changeCell(*change, factor, theme)}));
    }
    return rows;
}

std::vector<QuantityRow> resultRows(const Identification& found, const DisplayUnits& units,
                                    const std::vector<ParameterLimit>& limits) {
    const auto expanded = [](const Estimate& estimate, double factor) {
        const double u = 2 * std::abs(factor) * estimate.uncertainty();
        return estimate.given() ? valueCell(factor * estimate.value, u)
                                : sentenceCell(QStringLiteral("—"));
    };
    std::vector<QuantityRow> rows;
    if (found.fit.model == ResonatorModel::free) {
        return rowsOfModes(found.fit,
                           [&](const Estimate& estimate) { return expanded(estimate, 1); });
    }
    for (const ResonatorParameter& parameter : resonator_parameters) {
        const Estimate& estimate = found.fit.resonator.*parameter.member;
        if (!estimate.given() && !limit_of(limits, parameter.name)) {
            continue;
        }
        const Shown shown = shownAs(parameter.name, parameter.unit, units);
        rows.push_back(rowOf(shown, {expanded(estimate, shown.factor)}));
        if (!limits.empty()) {
            rows.back().cells.push_back(
                limitCell(parameter, estimate, limits, shown.factor, lightTheme()));
        }
    }
    return rows;
}

QStringList absentTitles(const Identification& found, const DisplayUnits& units) {
    QStringList titles;
    for (const ResonatorParameter& parameter : resonator_parameters) {
        const Estimate& estimate = found.fit.resonator.*parameter.member;
        if (found.fit.model == ResonatorModel::structured && !estimate.given()) {
            titles << shownAs(parameter.name, parameter.unit, units).title;
        }
    }
    return titles;
}

QStringList sensitivityHeaders(const Identification& found, const DisplayUnits& units) {
    QStringList headers;
    for (const Changes& column : allChanges(found, units)) {
        headers << column.head;
    }
    return headers;
}

std::vector<QuantityRow> sensitivityRows(const Identification& found, const DisplayUnits& units) {
    const std::vector<Changes> columns = allChanges(found, units);
    std::vector<QuantityRow> rows;
    for (std::size_t k = 0; k < usual_errors.size() && !columns.empty(); ++k) {
        QuantityRow row{ResonatorWords::tr(source_words[usual_errors[k].source].usual), {}, {}};
        for (const Changes& column : columns) {
            row.cells.push_back(column.cells[k]);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<QuantityRow> modeRows(const ResonatorFit& fit) {
    return rowsOfModes(fit, [](const Estimate& estimate) { return cellOf(estimate); });
}

std::vector<QuantityRow> driftRows(const Identification& found, const DisplayUnits& units) {
    const DriftFunction& drift = found.drift;
    const QString names[] = {ResonatorWords::tr("Mean drift"), QStringLiteral("cos 4θ_A"),
                             QStringLiteral("sin 4θ_A"), QStringLiteral("cos 8θ_A"),
                             QStringLiteral("sin 8θ_A")};
    std::vector<QuantityRow> rows;
    if (drift.order == 0) {
        rows.push_back({ResonatorWords::tr("Harmonics"),
                        {},
                        {sentenceCell(reasonText(no_drift_function(found)))}});
    }
    const double factor = angleRateFactor(units);
    for (Eigen::Index k = 0; k < drift.coefficients.size(); ++k) {
        rows.push_back(
            {withUnit(names[k], angleRateUnit(units)), {}, {cellOf(drift.coefficient(k), factor)}});
    }
    return rows;
}

QString driftSentence(const std::vector<QuantityRow>& rows, const DisplayUnits& units) {
    QStringList harmonics;
    for (const QuantityRow& row : rows) {
        const QString name = row.name.section(QLatin1Char(','), 0, 0);
        harmonics << QString(name).replace(QLatin1Char(' '), QChar(0xa0)) + QChar(0xa0) +
                         row.cells.front().concise;
    }
    return harmonics.join(QStringLiteral(", ")) + QChar(0xa0) + angleRateUnit(units);
}

QString absenceWord(const ResonatorParameter& parameter, const Reason& reason,
                    const DisplayUnits& units) {
    const Shown shown = shownAs(parameter.name, parameter.unit, units);
    const auto atMost = [&] {
        constexpr int digits = 3;
        const double most = parse_number(reason.args.at(0).text).value_or(std::nan(""));
        return QStringLiteral("≤ ") + shortNumberText(shown.factor * most, digits);
    };
    QString word = QStringLiteral("—");
    if (reason.code == ReasonCode::held) {
        word = ResonatorWords::tr("taken as zero");
    } else if (reason.code == ReasonCode::as_given) {
        word = ResonatorWords::tr("as given");
    } else if (reason.code == ReasonCode::not_nonlinear) {
        word = atMost();
    } else if (reason.code == ReasonCode::within_noise) {
        // An axis has the bound of what it is the axis of.
        word =
            english(reason.args.at(1)) == parameter.unit ? atMost() : ResonatorWords::tr("no axis");
    }
    return word + QStringLiteral(" *");
}

QString modelText(ResonatorModel model) {
    return model == ResonatorModel::structured ? ResonatorWords::tr("Structured model")
                                               : ResonatorWords::tr("Free model");
}

QString fitText(const ResonatorFit& fit) {
    return QStringLiteral("%1; χ²/ν = %2")
        .arg(modelText(fit.model), shortNumberText(fit.chi2_per_dof, 3));
}

QString toleranceName(ErrorSource source, const IdentifySettings& settings) {
    const QString name = ResonatorWords::tr(source_words[source].tolerance);
    const auto used = tolerances_in_use(settings.tolerance, settings.signal.calibration.kappa);
    const bool assumed = std::ranges::any_of(used, [source](const ToleranceInUse& each) {
        return each.error.source == source && each.assumed;
    });
    return assumed ? ResonatorWords::tr("%1 (assumed)").arg(name) : name;
}

QStringList toleranceTexts(const IdentifySettings& settings) {
    constexpr int digits = 3;
    QStringList texts;
    for (const ToleranceInUse& each :
         tolerances_in_use(settings.tolerance, settings.signal.calibration.kappa)) {
        const ToleratedError& error = each.error;
        const QString number = shortNumberText(each.value / error.shown, digits);
        const QString unit = error.source == skew_error ? QStringLiteral("°")
                             : *error.unit == '\0'      ? QString()
                                                   : QLatin1Char(' ') + unitText(error.shown_unit);
        texts
            << QStringLiteral("%1: %2%3").arg(toleranceName(error.source, settings), number, unit);
    }
    return texts;
}

bool anyAssumed(const IdentifySettings& settings) {
    return std::ranges::any_of(
        tolerances_in_use(settings.tolerance, settings.signal.calibration.kappa),
        &ToleranceInUse::assumed);
}

QString clockText(const IdentifySettings& settings) {
    return settings.tolerance[rate_error]
               ? QString()
               : ResonatorWords::tr("Frequencies by the clock of the recorder.");
}

QString uncertaintyText(const Identification& found) {
    const QStringList tolerances = toleranceTexts(found.settings);
    QString text = ResonatorWords::tr("± is the statistical standard deviation.");
    if (!tolerances.isEmpty()) {
        text +=
            QLatin1Char(' ') +
            ResonatorWords::tr("u, where it differs, holds the tolerances (Calibration) too: %1.")
                .arg(tolerances.join(QStringLiteral("; ")));
    }
    return QStringLiteral("%1 %2").arg(text, clockText(found.settings)).trimmed();
}

QString uncertaintyWords(const Identification& found) {
    const QString tolerances = toleranceTexts(found.settings).isEmpty() ? QString()
                               : anyAssumed(found.settings)
                                   ? ResonatorWords::tr("u: with the tolerances, some assumed.")
                                   : ResonatorWords::tr("u: with the tolerances.");
    return QStringLiteral("%1 %2 %3")
        .arg(ResonatorWords::tr("± and (): standard deviation."), tolerances,
             clockText(found.settings))
        .simplified();
}

FoundCalibration foundCalibration(const Identification& found) {
    constexpr double certain = 3;
    const ToleratedError& delay = tolerated_errors[delay_error];
    FoundCalibration other;
    const Calibration& calibrated = found.settings.signal.calibration;
    const Estimate& kappa = found.fit.resonator.kappa;
    if (kappa.given() && std::abs(kappa.value - calibrated.kappa) > certain * kappa.uncertainty()) {
        other.kappa = kappa;
    }
    for (const Diagnostic& warning : found.fit.warnings) {
        // A rotation may be one of the base.
        const bool of_channels = warning.kind == DiagnosticKind::quadrature_by_channel ||
                                 warning.kind == DiagnosticKind::misfit_channel ||
                                 warning.kind == DiagnosticKind::prior_left;
        if (!other.delay_d_s && of_channels && warning.args.size() > 1 &&
            warning.args[0].text == delay.name && warning.args[1].unit == delay.shown_unit) {
            if (const auto late_ns = parse_number(warning.args[1].text)) {
                other.delay_d_s = calibrated.delay_d_s + *late_ns * delay.shown;
            }
        }
    }
    const bool taken_out =
        calibrated.offset_auto || calibrated.offset_c != 0 || calibrated.offset_d != 0;
    other.offsets = !taken_out && std::ranges::any_of(found.runs, [](const IdentifiedRun& run) {
        return std::ranges::find(run.diagnostics, DiagnosticKind::offset, &Diagnostic::kind) !=
               run.diagnostics.end();
    });
    return other;
}

QString calibrationOffers(const FoundCalibration& found) {
    QStringList links;
    const auto add = [&links](const char* offer, const QString& text) {
        links << QStringLiteral("<a href=\"%1\">%2</a>").arg(QLatin1String(offer), text);
    };
    if (found.kappa) {
        add("kappa", ResonatorWords::tr("Calibrate with κ = %1")
                         .arg(valueText(found.kappa->value, found.kappa->sd)));
    }
    if (found.delay_d_s) {
        add("delay", ResonatorWords::tr("Calibrate with δ = %1 µs")
                         .arg(shortNumberText(*found.delay_d_s * 1e6, 4)));
    }
    if (found.offsets) {
        add("offset", ResonatorWords::tr("Remove the offsets of the channels"));
    }
    return links.join(QStringLiteral("<br>"));
}

std::vector<Finding> recordingFindings(const SetResult& outcome) {
    std::vector<NamedWarnings> all;
    for (std::size_t k = 0; k < outcome.identification.runs.size(); ++k) {
        all.emplace_back(outcome.set.recordings[k].name(),
                         outcome.identification.runs[k].diagnostics);
    }
    return findings_of(all);
}

}  // namespace vybeg::ui
