#include "ui/resonator/parameter_text.h"

#include "core/resonator/results/resonator_parameters.h"
#include "ui/words/display_units.h"
#include "ui/words/error_text.h"

#include <QCoreApplication>

#include <algorithm>
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

// The last word of a title is the symbol.
constexpr std::array<Texts, 12> parameter_texts{{
    {"f_mean_hz", QT_TRANSLATE_NOOP("Resonator", "Mean frequency f"),
     QT_TRANSLATE_NOOP("Resonator", "Of both modes, mean of the recordings")},
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
    {"non_orthogonality_rad", QT_TRANSLATE_NOOP("Resonator", "Non-orthogonality ε"),
     QT_TRANSLATE_NOOP("Resonator", "Angle between the pick-offs less 90 degrees")},
    {"delay_s", QT_TRANSLATE_NOOP("Resonator", "Delay δ"),
     QT_TRANSLATE_NOOP("Resonator", "By how much channel D comes late")},
    {"frequency_per_power", QT_TRANSLATE_NOOP("Resonator", "Amplitude dependence β"),
     QT_TRANSLATE_NOOP("Resonator", "Change of f per squared unit of amplitude")},
}};

static_assert(parameter_texts.size() == resonator_parameters.size());

QString symbolOf(const std::string& parameter) {
    return parameter == "f_hz"    ? QStringLiteral("f")
           : parameter == "tau_s" ? QStringLiteral("τ")
                                  : QStringLiteral("Q");
}

// "Mode 1: f" of "modes[0].f_hz", "Recording 11: f of its direction" of "runs[10].direction.f_hz".
QString numberedTitle(const std::string& name) {
    const int place = std::stoi(name.substr(name.find('[') + 1));
    return (name.starts_with("modes[") ? ResonatorWords::tr("Mode %1: %2")
                                       : ResonatorWords::tr("Recording %1: %2 of its direction"))
        .arg(place + 1)
        .arg(symbolOf(name.substr(name.rfind('.') + 1)));
}

}  // namespace

QuantityCell valueCell(double value, double sd, double u) {
    return {valueText(value, sd, u),
            {exactText(value), exactText(sd), exactText(u)},
            {},
            conciseText(value, sd)};
}

QuantityCell sentenceCell(const QString& text) {
    return {text, {text, QString(), QString()}, {}};
}

QuantityCell cellOf(const Estimate& estimate, double factor) {
    if (!estimate.given()) {
        return sentenceCell(reasonText(estimate.reason));
    }
    return valueCell(factor * estimate.value, std::abs(factor) * estimate.sd,
                     std::abs(factor) * estimate.u);
}

Shown shownAs(const std::string& name, const char* unit, const DisplayUnits& units) {
    Shown shown;
    for (const Texts& texts : parameter_texts) {
        if (name == texts.name) {
            shown.title = ResonatorWords::tr(texts.title);
            shown.tip = ResonatorWords::tr(texts.tip);
        }
    }
    if (name.find('[') != std::string::npos) {
        shown.title = numberedTitle(name);
    }
    if (QLatin1String(unit) == QLatin1String("rad")) {
        shown.unit = angleUnit(units);
        shown.factor = angleFactor(units);
    } else if (QLatin1String(unit) == QLatin1String("rad/s")) {
        shown.unit = angleRateUnit(units);
        shown.factor = angleRateFactor(units);
    } else if (name == "split_hz") {
        shown.unit = siPrefix(-3) + unitText("Hz");
        shown.factor = 1e3;
    } else {
        shown.unit = unitText(unit);
    }
    return shown;
}

int columnPower(double most, int digits) {
    const int digit = most > 0 ? static_cast<int>(std::floor(std::log10(most))) : 0;
    const int thousands = std::clamp(static_cast<int>(std::floor(digit / 3.)), -5, 4);
    return digit < -3 || digit >= digits ? 3 * thousands : 0;
}

QuantityRow rowOf(const Shown& shown, std::vector<QuantityCell> cells) {
    return {withUnit(shown.title, shown.unit), shown.tip, std::move(cells)};
}

QString angleUnit(const DisplayUnits& units) {
    return units.angle == AngleUnit::degrees ? QStringLiteral("°") : ResonatorWords::tr("rad");
}

double angleFactor(const DisplayUnits& units) {
    return units.angle == AngleUnit::degrees ? degrees : 1;
}

QString angleRateUnit(const DisplayUnits& units) {
    return units.angle == AngleUnit::degrees ? ResonatorWords::tr("°/h")
                                             : ResonatorWords::tr("rad/s");
}

double angleRateFactor(const DisplayUnits& units) {
    return units.angle == AngleUnit::degrees ? degrees * hour_s : 1;
}

namespace {

// Signed, with one decimal; zero has no sign.
QString deviationsText(double deviations) {
    const QString size = numberLabel(std::abs(deviations), 1);
    if (std::abs(deviations) < 0.05) {
        return size;
    }
    return (deviations < 0 ? QChar(0x2212) : QLatin1Char('+')) + size;
}

// Percent, or ppm for small values.
QuantityCell relativeCell(double relative) {
    if (std::isnan(relative)) {
        return {QStringLiteral("—"), {QString()}, {}};
    }
    const bool small = std::abs(relative) < 1e-4;
    QString text = shortNumberText(std::abs(relative) * (small ? 1e6 : 1e2), 3);
    if (relative != 0) {
        text.prepend(relative < 0 ? QChar(0x2212) : QLatin1Char('+'));
    }
    return {text + QLatin1Char(' ') + (small ? unitText("ppm") : QStringLiteral("%")),
            {exactText(relative)},
            {}};
}

// Reasons are below the table, because its columns are too narrow.
QuantityCell sideCell(const Estimate& estimate, double factor) {
    QuantityCell cell = cellOf(estimate, factor);
    if (!estimate.given()) {
        cell.text = QStringLiteral("—");
    }
    return cell;
}

QString verdictWord(Verdict verdict) {
    switch (verdict) {
        case Verdict::unchanged: return ResonatorWords::tr("unchanged");
        case Verdict::changed: return ResonatorWords::tr("changed");
        case Verdict::not_comparable: break;
    }
    return ResonatorWords::tr("not comparable");
}

// Sign, word and an Okabe-Ito colour are redundant.
QColor verdictColor(Verdict verdict, const Theme& theme) {
    return verdict == Verdict::unchanged ? readable(QColor("#009e73"), theme)
           : verdict == Verdict::changed ? readable(QColor("#d55e00"), theme)
                                         : theme.mutedText;
}

QString verdictSign(Verdict verdict) {
    return verdict == Verdict::unchanged ? QStringLiteral("= ")
           : verdict == Verdict::changed ? QStringLiteral("≠ ")
                                         : QStringLiteral("? ");
}

QString whyText(const Difference& difference) {
    switch (difference.why) {
        case Incomparable::now_unknown: return reasonText(difference.now.reason);
        case Incomparable::then_unknown:
            return ResonatorWords::tr("in the passport: %1")
                .arg(reasonText(difference.then.reason));
        default:
            return QCoreApplication::translate("Reason", incomparable_sentence(difference.why));
    }
}

}  // namespace

QString verdictText(Verdict verdict) {
    return verdictSign(verdict) + verdictWord(verdict);
}

QuantityCell changeCell(const Difference& difference, double factor, const Theme& theme) {
    const Verdict verdict = difference.verdict;
    const bool known = difference.known();
    const QString text = known ? valueText(factor * difference.change, factor * difference.u)
                               : verdictWord(verdict);  // beyond a bound
    return {verdict == Verdict::not_comparable ? QString() : verdictSign(verdict) + text,
            {known ? exactText(factor * difference.change) : QString()},
            verdictColor(verdict, theme)};
}

QString differenceSymbol(const std::string& name) {
    const QString title = shownAs(name, "", {}).title;
    return name.starts_with("modes[")  ? ResonatorWords::tr("Modes")
           : name.starts_with("runs[") ? title
                                       : title.section(QLatin1Char(' '), -1);
}

QStringList incomparableTexts(const std::vector<Difference>& differences) {
    std::vector<std::pair<QString, QStringList>> reasons;  // and the names of their parameters
    for (const Difference& difference : differences) {
        if (difference.known()) {
            continue;
        }
        const QString reason = whyText(difference);
        const QString symbol = differenceSymbol(difference.name);
        const auto same =
            std::ranges::find(reasons, reason, &std::pair<QString, QStringList>::first);
        if (same == reasons.end()) {
            reasons.push_back({reason, {symbol}});
        } else if (!same->second.contains(symbol)) {
            same->second << symbol;
        }
    }
    QStringList texts;
    for (const auto& [reason, symbols] : reasons) {
        texts << QStringLiteral("%1: %2").arg(symbols.join(QStringLiteral(", ")), reason);
    }
    return texts;
}

QStringList differenceHeaders() {
    return {ResonatorWords::tr("Verdict"), ResonatorWords::tr("Difference, u"),
            ResonatorWords::tr("Difference"), ResonatorWords::tr("Relative"),
            ResonatorWords::tr("Passport")};
}

std::vector<QuantityRow> differenceRows(const std::vector<Difference>& differences,
                                        const DisplayUnits& units, const Theme& theme) {
    const double significant = changed_from(count_compared(differences));
    std::vector<QuantityRow> rows;
    for (const Difference& difference : differences) {
        const Shown shown = shownAs(difference.name, difference.unit, units);
        const double sds =
            difference.change < 0 ? -difference.deviations() : difference.deviations();
        const bool known = difference.known();
        const QuantityCell deviations{known ? deviationsText(sds) : QStringLiteral("—"),
                                      {known ? exactText(sds) : QString()},
                                      {}};
        const double factor = shown.factor;
        const QuantityCell change = valueCell(factor * difference.change, factor * difference.u);
        // Significant, but too small to matter to the engineer.
        const bool limited =
            difference.verdict == Verdict::unchanged && difference.deviations() >= significant;
        const QString word =
            limited ? ResonatorWords::tr("within the limit") : verdictWord(difference.verdict);
        rows.push_back(rowOf(shown, {{verdictSign(difference.verdict) + word,
                                      {word},
                                      verdictColor(difference.verdict, theme)},
                                     deviations,
                                     change,
                                     relativeCell(difference.relative),
                                     sideCell(difference.then, factor)}));
    }
    return rows;
}

}  // namespace vybeg::ui
