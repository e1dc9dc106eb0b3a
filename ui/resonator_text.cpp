#include "ui/resonator_text.h"

#include "core/report/identify_json.h"
#include "core/resonator/resonator_parameters.h"
#include "ui/error_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <array>
#include <cmath>
#include <numbers>

namespace vybeg::ui {

namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double hour_s = 3600;

struct Texts {
    const char* name;  // as in resonator_parameters.h
    const char* title;
    const char* tip;
};

constexpr std::array<Texts, 10> parameter_texts{{
    {"f_mean_hz", QT_TRANSLATE_NOOP("Resonator", "Mean frequency f"),
     QT_TRANSLATE_NOOP("Resonator", "Of both modes, mean of the runs")},
    {"split_hz", QT_TRANSLATE_NOOP("Resonator", "Frequency split Δf"),
     QT_TRANSLATE_NOOP("Resonator", "f_p − f_q of the two modes, never negative")},
    {"theta_w_rad", QT_TRANSLATE_NOOP("Resonator", "Stiffness axis θ_w"),
     QT_TRANSLATE_NOOP("Resonator", "Axis of the mode with the higher frequency")},
    {"tau_s", QT_TRANSLATE_NOOP("Resonator", "Decay time τ"),
     QT_TRANSLATE_NOOP("Resonator", "In which the amplitude falls to 1/e")},
    {"q", QT_TRANSLATE_NOOP("Resonator", "Quality factor Q"),
     QT_TRANSLATE_NOOP("Resonator", "Q = π f τ, from the coherent fit")},
    {"damping_anisotropy_per_s", QT_TRANSLATE_NOOP("Resonator", "Damping anisotropy g"),
     QT_TRANSLATE_NOOP("Resonator", "Difference of 1/τ of both axes of damping, never negative")},
    {"theta_tau_rad", QT_TRANSLATE_NOOP("Resonator", "Damping axis θ_τ"),
     QT_TRANSLATE_NOOP("Resonator", "Axis of larger damping")},
    {"angle_rate_rad_s", QT_TRANSLATE_NOOP("Resonator", "Rotation −kΩ"),
     QT_TRANSLATE_NOOP("Resonator", "Drift of θ_A that is the same at every angle")},
    {"kappa", QT_TRANSLATE_NOOP("Resonator", "Gain ratio κ"),
     QT_TRANSLATE_NOOP("Resonator", "D = κ S_D")},
    {"frequency_per_power", QT_TRANSLATE_NOOP("Resonator", "Frequency against power"),
     QT_TRANSLATE_NOOP("Resonator", "Change of f per squared unit of amplitude")},
}};

QString translated(const char* text) {
    return QCoreApplication::translate("Resonator", text);
}

QString unitText(const char* unit) {
    // Those that core/ gives with its parameters.
    static constexpr std::array<const char*, 4> known{
        QT_TRANSLATE_NOOP("Resonator", "Hz"), QT_TRANSLATE_NOOP("Resonator", "s"),
        QT_TRANSLATE_NOOP("Resonator", "1/s"),
        QT_TRANSLATE_NOOP("Resonator", "Hz per squared unit")};
    for (const char* each : known) {
        if (QLatin1String(each) == QLatin1String(unit)) {
            return translated(each);
        }
    }
    return QString::fromLatin1(unit);
}

QString withUnit(const QString& name, const QString& unit) {
    return unit.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, unit);
}

QString exactText(double value) {
    return std::isnan(value) ? QString()
                             : QLocale().toString(value, 'g', QLocale::FloatingPointShortest);
}

QuantityCell valueCell(double value, double sd) {
    return {valueText(value, sd), {exactText(value), exactText(sd)}, {}};
}

QuantityCell cellOf(const Estimate& estimate, double factor = 1) {
    if (!estimate.given()) {
        const QString reason = reasonText(estimate.reason);
        return {reason, {reason, QString()}, {}};
    }
    return valueCell(factor * estimate.value, std::abs(factor) * estimate.sd);
}

// What one row shows of a parameter.
struct Shown {
    QString title;
    QString tip;
    QString unit;
    double factor = 1;
};

Shown shownAs(const std::string& name, const char* unit, bool is_axis, const DisplayUnits& units) {
    Shown shown;
    for (const Texts& texts : parameter_texts) {
        if (name == texts.name) {
            shown.title = translated(texts.title);
            shown.tip = translated(texts.tip);
        }
    }
    if (is_axis) {
        shown.unit = angleUnit(units);
        shown.factor = angleFactor(units);
    } else if (QLatin1String(unit) == QLatin1String("rad/s")) {
        shown.unit = angleRateUnit(units);
        shown.factor = angleRateFactor(units);
    } else {
        shown.unit = unitText(unit);
    }
    return shown;
}

// One sentence is enough for all the numbers that lack for the same reason.
void sayOnce(std::vector<QuantityRow>& rows) {
    for (std::size_t k = 1; k < rows.size(); ++k) {
        for (std::size_t first = 0; first < k; ++first) {
            QuantityCell& cell = rows[k].cells.front();
            const bool is_sentence = cell.exact.front() == cell.text;
            if (is_sentence && cell.text == rows[first].cells.front().text) {
                const QString other = rows[first].name.section(QLatin1Char(','), 0, 0);
                cell.text = translated(QT_TRANSLATE_NOOP("Resonator", "As above: %1"))
                                .arg(other.section(QLatin1Char(' '), -1));
                break;
            }
        }
    }
}

bool isAxis(const std::string& name) {
    for (const ResonatorParameter& parameter : resonator_parameters) {
        if (name == parameter.name) {
            return parameter.period > 0;
        }
    }
    return false;
}

// "Mode 1: f".
QString modeTitle(int index, const std::string& parameter) {
    const QString symbol = parameter == "f_hz"    ? QStringLiteral("f")
                           : parameter == "tau_s" ? QStringLiteral("τ")
                                                  : QStringLiteral("Q");
    return translated(QT_TRANSLATE_NOOP("Resonator", "Mode %1: %2")).arg(index + 1).arg(symbol);
}

// Of a difference, "modes[0].f_hz".
QString modeTitle(const std::string& name) {
    const auto digit = std::string("modes[").size();
    return modeTitle(name.at(digit) - '0', name.substr(digit + 3));
}

// Signed, with one decimal; nought has no sign.
QString deviationsText(double deviations) {
    const QString size = QLocale().toString(std::abs(deviations), 'f', 1);
    if (std::abs(deviations) < 0.05) {
        return size;
    }
    return (deviations < 0 ? QChar(0x2212) : QLatin1Char('+')) + size;
}

QuantityCell verdictCell(const Difference& difference, const Theme& theme) {
    // Sign, word and an Okabe-Ito colour: any one of them is enough.
    switch (difference.verdict) {
        case Verdict::unchanged: {
            const QString word = translated(QT_TRANSLATE_NOOP("Resonator", "unchanged"));
            return {QStringLiteral("= ") + word, {word}, readable(QColor("#009e73"), theme)};
        }
        case Verdict::changed: {
            const QString word = translated(QT_TRANSLATE_NOOP("Resonator", "changed"));
            return {QStringLiteral("≠ ") + word, {word}, readable(QColor("#d55e00"), theme)};
        }
        case Verdict::not_comparable: break;
    }
    const QString word = translated(QT_TRANSLATE_NOOP("Resonator", "not comparable"));
    return {QStringLiteral("? ") + word, {word}, theme.mutedText};
}

}  // namespace

QString angleUnit(const DisplayUnits& units) {
    return units.angle == AngleUnit::degrees ? QStringLiteral("°")
                                             : translated(QT_TRANSLATE_NOOP("Resonator", "rad"));
}

double angleFactor(const DisplayUnits& units) {
    return units.angle == AngleUnit::degrees ? degrees : 1;
}

QString angleRateUnit(const DisplayUnits& units) {
    return units.angle == AngleUnit::degrees ? translated(QT_TRANSLATE_NOOP("Resonator", "°/h"))
                                             : translated(QT_TRANSLATE_NOOP("Resonator", "rad/s"));
}

double angleRateFactor(const DisplayUnits& units) {
    return units.angle == AngleUnit::degrees ? degrees * hour_s : 1;
}

std::vector<QuantityRow> resonatorRows(const Identification& found, const DisplayUnits& units) {
    std::vector<QuantityRow> rows;
    if (found.fit.model == ResonatorModel::free) {
        return rows;
    }
    for (const ResonatorParameter& parameter : resonator_parameters) {
        const Shown shown = shownAs(parameter.name, parameter.unit, parameter.period > 0, units);
        rows.push_back({withUnit(shown.title, shown.unit),
                        shown.tip,
                        {cellOf(found.fit.resonator.*parameter.member, shown.factor)}});
    }
    sayOnce(rows);
    return rows;
}

std::vector<QuantityRow> modeRows(const ResonatorFit& fit) {
    std::vector<QuantityRow> rows;
    if (fit.modes.empty()) {
        const QString reason = reasonText(fit.no_modes);
        rows.push_back({translated(QT_TRANSLATE_NOOP("Resonator", "Modes")),
                        {},
                        {{reason, {reason, QString()}, {}}}});
        return rows;
    }
    for (std::size_t k = 0; k < fit.modes.size(); ++k) {
        for (const ModeParameter& parameter : mode_parameters) {
            rows.push_back(
                {withUnit(modeTitle(static_cast<int>(k), parameter.name), unitText(parameter.unit)),
                 {},
                 {cellOf(fit.modes[k].*parameter.member)}});
        }
    }
    return rows;
}

std::vector<QuantityRow> runRows(const Identification& found, const DisplayUnits& units) {
    const QString hertz = unitText("Hz");
    const QString amplitude = translated(QT_TRANSLATE_NOOP("Resonator", "rec. units"));
    std::vector<QuantityRow> rows;
    const auto add = [&](const QString& title, const QString& unit, const char* tip,
                         const auto& cell) {
        QuantityRow row{withUnit(title, unit), translated(tip), {}};
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
    add(translated(QT_TRANSLATE_NOOP("Resonator", "Frequency offset")), hertz,
        QT_TRANSLATE_NOOP("Resonator", "From the mean frequency of the runs"),
        estimate(&RunEstimate::f_offset_hz, 1));
    add(translated(QT_TRANSLATE_NOOP("Resonator", "Start angle θ_A")), angleUnit(units),
        QT_TRANSLATE_NOOP("Resonator", "Angle of the working wave at the start"),
        estimate(&RunEstimate::two_theta_A_rad, angleFactor(units) / 2));
    add(QStringLiteral("a_A"), amplitude,
        QT_TRANSLATE_NOOP("Resonator", "Amplitude of the working wave at the start"),
        estimate(&RunEstimate::a_A, 1));
    add(QStringLiteral("a_B"), amplitude,
        QT_TRANSLATE_NOOP("Resonator", "Amplitude of the quadrature wave at the start"),
        estimate(&RunEstimate::a_B, 1));
    add(QStringLiteral("Δf sin 4(θ_A − θ_w)"), hertz,
        QT_TRANSLATE_NOOP("Resonator",
                          "What of the frequency split makes the quadrature of this run grow"),
        estimate(&RunEstimate::split_sin_hz, 1));
    add(translated(QT_TRANSLATE_NOOP("Resonator", "Q from the envelope")), {},
        QT_TRANSLATE_NOOP("Resonator", "Quality factor from the power of the waves alone"),
        estimate(&RunEstimate::q_envelope, 1));
    if (found.fit.model == ResonatorModel::structured) {
        add(translated(QT_TRANSLATE_NOOP("Resonator", "Q coherent")), {},
            QT_TRANSLATE_NOOP("Resonator", "Quality factor from the coherent fit of all runs"),
            [&found](std::size_t) { return cellOf(found.fit.resonator.q); });
    }
    add(translated(QT_TRANSLATE_NOOP("Resonator", "Frequency drift")),
        unitText("Hz") + "/" + unitText("s"),
        QT_TRANSLATE_NOOP("Resonator", "Of this run, over time"),
        estimate(&RunEstimate::drift_hz_per_s, 1));
    add(translated(QT_TRANSLATE_NOOP("Resonator", "Noise σ")), amplitude,
        QT_TRANSLATE_NOOP("Resonator", "Standard deviation per sample and channel"),
        [&found](std::size_t k) {
            return valueCell(found.runs[k].noise_sd, std::numeric_limits<double>::quiet_NaN());
        });
    add(translated(QT_TRANSLATE_NOOP("Resonator", "Windows used")), {},
        QT_TRANSLATE_NOOP("Resonator", "Without gaps and faults, of all; samples in each"),
        [&found](std::size_t k) {
            const QLocale locale;
            const IdentifiedRun& run = found.runs[k];
            const QString text = translated(QT_TRANSLATE_NOOP("Resonator", "%1 of %2, n = %3"))
                                     .arg(locale.toString(static_cast<qint64>(run.windows_used)),
                                          locale.toString(static_cast<qint64>(run.windows)),
                                          locale.toString(static_cast<qint64>(run.window)));
            return QuantityCell{text, {text, QString()}, {}};
        });
    return rows;
}

std::vector<QuantityRow> driftRows(const DriftFunction& drift, const DisplayUnits& units) {
    const QString names[] = {translated(QT_TRANSLATE_NOOP("Resonator", "Mean drift")),
                             QStringLiteral("cos 4θ_A"), QStringLiteral("sin 4θ_A"),
                             QStringLiteral("cos 8θ_A"), QStringLiteral("sin 8θ_A")};
    std::vector<QuantityRow> rows;
    const double factor = angleRateFactor(units);
    for (Eigen::Index k = 0; k < drift.coefficients.size(); ++k) {
        rows.push_back({withUnit(names[k], angleRateUnit(units)),
                        {},
                        {valueCell(factor * drift.coefficients[k],
                                   factor * std::sqrt(drift.covariance(k, k)))}});
    }
    return rows;
}

QStringList differenceHeaders() {
    return {translated(QT_TRANSLATE_NOOP("Resonator", "Verdict")),
            translated(QT_TRANSLATE_NOOP("Resonator", "Difference, sd")),
            translated(QT_TRANSLATE_NOOP("Resonator", "Passport")),
            translated(QT_TRANSLATE_NOOP("Resonator", "Now"))};
}

std::vector<QuantityRow> differenceRows(const std::vector<Difference>& differences,
                                        const DisplayUnits& units, const Theme& theme) {
    std::vector<QuantityRow> rows;
    for (const Difference& difference : differences) {
        const bool of_mode = difference.name.starts_with("modes[");
        const Shown shown =
            shownAs(difference.name, difference.unit, isAxis(difference.name), units);
        const double sds =
            difference.change < 0 ? -difference.deviations() : difference.deviations();
        const bool known = difference.verdict != Verdict::not_comparable;
        const QuantityCell deviations{known ? deviationsText(sds) : QStringLiteral("—"),
                                      {known ? exactText(sds) : QString()},
                                      {}};
        rows.push_back(
            {withUnit(of_mode ? modeTitle(difference.name) : shown.title, shown.unit),
             shown.tip,
             {verdictCell(difference, theme), deviations, cellOf(difference.then, shown.factor),
              cellOf(difference.now, shown.factor)}});
    }
    return rows;
}

QStringList warningTexts(const ResonatorOutcome& outcome) {
    QStringList texts;
    for (const auto& [diagnostic, input] : all_warnings(outcome.identification)) {
        const QString text = diagnosticText(diagnostic);
        texts << (input < 0 ? text
                            : QStringLiteral("%1: %2").arg(
                                  QString::fromStdString(
                                      outcome.inputs[static_cast<std::size_t>(input)].name),
                                  text));
    }
    return texts;
}

}  // namespace vybeg::ui
