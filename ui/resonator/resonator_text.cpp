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

// Replaces a repeated reason by a reference to its first row.
void collapseRepeatedReasons(std::vector<QuantityRow>& rows) {
    for (std::size_t k = 1; k < rows.size(); ++k) {
        for (std::size_t first = 0; first < k; ++first) {
            QuantityCell& cell = rows[k].cells.front();
            const bool is_sentence = cell.exact.front() == cell.text;
            if (is_sentence && cell.text == rows[first].cells.front().text) {
                const QString other = rows[first].name.section(QLatin1Char(','), 0, 0);
                cell.text = ResonatorWords::tr("The same as for %1")
                                .arg(other.section(QLatin1Char(' '), -1));
                break;
            }
        }
    }
}

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
    const int thousands = std::clamp(static_cast<int>(std::floor(digit / 3.)), -5, 4);
    const int power = digit < -3 || digit > 3 ? 3 * thousands : 0;
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
    collapseRepeatedReasons(rows);
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

std::vector<QuantityRow> waveRows(const Identification& found, const DisplayUnits& units) {
    // As wave_parameters.
    static constexpr std::array<std::pair<const char*, const char*>, 4> texts{{
        {QT_TRANSLATE_NOOP("Resonator", "Frequency of the wave"),
         QT_TRANSLATE_NOOP("Resonator", "Mean rate of its phase, by power of both channels")},
        {QT_TRANSLATE_NOOP("Resonator", "Decay time of the wave"),
         QT_TRANSLATE_NOOP("Resonator", "Of √(a_A² + a_B²)")},
        {QT_TRANSLATE_NOOP("Resonator", "Drift dθ_A/dt"),
         QT_TRANSLATE_NOOP("Resonator", "Mean rate of the angle of the working wave")},
        {QT_TRANSLATE_NOOP("Resonator", "Quadrature growth d(a_B/a_A)/dt"),
         QT_TRANSLATE_NOOP("Resonator", "Mean rate of the ratio of both waves")},
    }};
    static_assert(texts.size() == wave_parameters.size());
    std::vector<QuantityRow> rows;
    for (std::size_t k = 0; k < wave_parameters.size(); ++k) {
        const WaveParameter& parameter = wave_parameters[k];
        Shown shown = shownAs(parameter.name, parameter.unit, units);
        shown.title = ResonatorWords::tr(texts[k].first);
        shown.tip = ResonatorWords::tr(texts[k].second);
        QuantityRow row = rowOf(shown);
        for (const IdentifiedRun& run : found.runs) {
            row.cells.push_back(cellOf(run.wave.*parameter.member, shown.factor));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

QStringList sensitivityHeaders(const Identification& found, const DisplayUnits& units) {
    QStringList headers;
    for (const Changes& column : allChanges(found, units)) {
        headers << column.head;
    }
    return headers;
}

std::vector<QuantityRow> sensitivityRows(const Identification& found, const DisplayUnits& units) {
    // As usual_errors.
    static constexpr std::array<const char*, 11> texts{
        QT_TRANSLATE_NOOP("Resonator", "0.1° of non-orthogonality"),
        QT_TRANSLATE_NOOP("Resonator", "10 ns of delay"),
        QT_TRANSLATE_NOOP("Resonator", "10⁻⁴ rad of phase drift"),
        QT_TRANSLATE_NOOP("Resonator", "10⁻⁴ of gain drift"),
        QT_TRANSLATE_NOOP("Resonator", "0.001 of κ"),
        QT_TRANSLATE_NOOP("Resonator", "10⁻⁴ of crosstalk"),
        QT_TRANSLATE_NOOP("Resonator", "10 µHz by amplitude"),
        QT_TRANSLATE_NOOP("Resonator", "1 % of damping by amplitude"),
        QT_TRANSLATE_NOOP("Resonator", "0.1 % of gain by amplitude"),
        QT_TRANSLATE_NOOP("Resonator", "10 µHz between the axes by amplitude"),
        QT_TRANSLATE_NOOP("Resonator", "10⁻⁶ rad/s of the 8th harmonic of drift"),
    };
    static_assert(texts.size() == usual_errors.size());
    const std::vector<Changes> columns = allChanges(found, units);
    std::vector<QuantityRow> rows;
    for (std::size_t k = 0; k < texts.size() && !columns.empty(); ++k) {
        QuantityRow row{ResonatorWords::tr(texts[k]), {}, {}};
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

std::vector<QuantityRow> runRows(const Identification& found, const DisplayUnits& units) {
    const QString hertz = unitText("Hz");
    const QString amplitude = ResonatorWords::tr("rec. units");
    std::vector<QuantityRow> rows;
    const auto add = [&](const QString& title, const QString& unit, const QString& tip,
                         const auto& cell) {
        QuantityRow row{withUnit(title, unit), tip, {}};
        for (std::size_t k = 0; k < found.runs.size(); ++k) {
            row.cells.push_back(cell(k));
        }
        rows.push_back(std::move(row));
    };
    const auto estimate = [&](Estimate RunEstimate::*member, double factor) {
        return [&found, member, factor](std::size_t k) {
            return cellOf(found.fit.runs[k].*member, factor);
        };
    };
    add(ResonatorWords::tr("Frequency offset"), hertz,
        ResonatorWords::tr("From the mean frequency of the recordings"),
        estimate(&RunEstimate::f_offset_hz, 1));
    add(ResonatorWords::tr("Start angle θ_A"), angleUnit(units),
        ResonatorWords::tr("Angle of the working wave at the start"),
        estimate(&RunEstimate::two_theta_A_rad, angleFactor(units) / 2));
    add(QStringLiteral("a_A"), amplitude,
        ResonatorWords::tr("Amplitude of the working wave at the start"),
        estimate(&RunEstimate::a_A, 1));
    add(QStringLiteral("a_B"), amplitude,
        ResonatorWords::tr("Amplitude of the quadrature wave at the start"),
        estimate(&RunEstimate::a_B, 1));
    add(QStringLiteral("Δf sin 4(θ_A − θ_w)"), hertz,
        ResonatorWords::tr(
            "What of the frequency split makes the quadrature of this recording grow"),
        estimate(&RunEstimate::split_sin_hz, 1));
    add(ResonatorWords::tr("f of this direction"), hertz,
        ResonatorWords::tr("Of a wave that stays in the direction in which this one starts"),
        estimate(&RunEstimate::direction_f_hz, 1));
    add(ResonatorWords::tr("τ of this direction"), unitText("s"),
        ResonatorWords::tr("Of a wave that stays in the direction in which this one starts"),
        estimate(&RunEstimate::direction_tau_s, 1));
    add(ResonatorWords::tr("Q of this wave"), {},
        ResonatorWords::tr("Of its envelope alone: the power of this recording. Q of the resonator "
                           "is the mean of all directions"),
        estimate(&RunEstimate::q_envelope, 1));
    const bool varies = std::ranges::any_of(
        found.fit.runs, [](const RunEstimate& run) { return run.law && run.q_envelope.given(); });
    if (varies) {
        add(ResonatorWords::tr("Q over the amplitude"), {},
            ResonatorWords::tr("Amplitude at which Q of this wave holds; Q at the largest and at "
                               "the smallest amplitude"),
            [&found](std::size_t k) {
                const RunEstimate& run = found.fit.runs[k];
                if (!run.law || !run.q_envelope.given()) {
                    return sentenceCell({});
                }
                const QBand band = q_band(*run.law, run.q_envelope.value);
                const auto text = [](double x) { return shortNumberText(x, 3); };
                return sentenceCell(ResonatorWords::tr("at %1; %2 at %3, %4 at %5")
                                        .arg(text(band.amplitude), text(band.q_at_largest),
                                             text(band.largest), text(band.q_at_smallest),
                                             text(band.smallest)));
            });
    }
    if (found.fit.model == ResonatorModel::structured) {
        add(ResonatorWords::tr("Q coherent"), {},
            ResonatorWords::tr("Quality factor from the coherent fit of all recordings"),
            [&found](std::size_t) { return cellOf(found.fit.resonator.q); });
    }
    add(ResonatorWords::tr("Frequency drift"), unitText("Hz") + "/" + unitText("s"),
        ResonatorWords::tr("Of this recording, over time"),
        estimate(&RunEstimate::drift_hz_per_s, 1));
    add(ResonatorWords::tr("Noise σ"), amplitude,
        ResonatorWords::tr("Standard deviation per sample and channel"), [&found](std::size_t k) {
            const double sd = found.runs[k].noise_sd;
            return QuantityCell{threeDigits(sd), {exactText(sd), QString(), QString()}, {}};
        });
    add(ResonatorWords::tr("Windows used"), {},
        ResonatorWords::tr("Without gaps and faults, of all; samples in each"),
        [&found](std::size_t k) {
            const IdentifiedRun& run = found.runs[k];
            return sentenceCell(ResonatorWords::tr("%1 of %2, n = %3")
                                    .arg(countLabel(run.windows_used), countLabel(run.windows),
                                         countLabel(run.window)));
        });
    return rows;
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

QString toleranceName(ErrorSource source, const IdentifySettings& settings) {
    // As tolerance_names.
    static constexpr std::array<const char*, tolerance_names.size()> names{
        QT_TRANSLATE_NOOP("Resonator", "Gain ratio"),
        QT_TRANSLATE_NOOP("Resonator", "Non-orthogonality"),
        QT_TRANSLATE_NOOP("Resonator", "Delay"),
        QT_TRANSLATE_NOOP("Resonator", "Crosstalk"),
        QT_TRANSLATE_NOOP("Resonator", "Phase drift"),
        QT_TRANSLATE_NOOP("Resonator", "Gain drift"),
        QT_TRANSLATE_NOOP("Resonator", "Sample rate"),
        QT_TRANSLATE_NOOP("Resonator", "Spread")};
    static_assert(names.back() != nullptr);
    const QString name = ResonatorWords::tr(names[static_cast<std::size_t>(source)]);
    const auto used = tolerances_in_use(settings.tolerance, settings.signal.calibration.kappa);
    const bool assumed = std::ranges::any_of(used, [source](const ToleranceInUse& each) {
        return each.parameter.source == source && each.assumed;
    });
    return assumed ? ResonatorWords::tr("%1 (assumed)").arg(name) : name;
}

QStringList toleranceTexts(const IdentifySettings& settings) {
    constexpr int digits = 3;
    QStringList texts;
    for (const ToleranceInUse& each :
         tolerances_in_use(settings.tolerance, settings.signal.calibration.kappa)) {
        const ErrorSource source = each.parameter.source;
        const bool delay = source == delay_error;
        const QString number = shortNumberText(each.value * (delay ? 1e9 : 1), digits);
        const QString unit = source == skew_error ? QStringLiteral("°")
                             : *each.parameter.unit == '\0'
                                 ? QString()
                                 : QLatin1Char(' ') + unitText(delay ? "ns" : each.parameter.unit);
        texts << QStringLiteral("%1: %2%3").arg(toleranceName(source, settings), number, unit);
    }
    return texts;
}

bool anyAssumed(const IdentifySettings& settings) {
    return std::ranges::any_of(
        tolerances_in_use(settings.tolerance, settings.signal.calibration.kappa),
        &ToleranceInUse::assumed);
}

QString clockText(const IdentifySettings& settings) {
    return settings.tolerance.rate_ppm
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

FoundCalibration foundCalibration(const Identification& found) {
    constexpr double certain = 3;
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
            warning.args[0].text == tolerance_names[delay_error] && warning.args[1].unit == "ns") {
            if (const auto late_ns = parse_number(warning.args[1].text)) {
                other.delay_d_s = calibrated.delay_d_s + *late_ns * 1e-9;
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
