#include "ui/resonator/parameter_text.h"

#include "core/resonator/results/resonator_parameters.h"
#include "ui/panels/reading.h"
#include "ui/words/error_text.h"
#include "ui/words/unit_text.h"

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

// The last word of a title is the symbol.
constexpr std::array<Texts, 12> parameter_texts{{
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

}  // namespace

QuantityCell valueCell(double value, double sd, double u) {
    return {valueText(value, sd, u), {exactText(value), exactText(sd), exactText(u)}, {}};
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
    if (QLatin1String(unit) == QLatin1String("rad")) {
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

QString modeTitle(int index, const std::string& parameter) {
    return ResonatorWords::tr("Mode %1: %2").arg(index + 1).arg(symbolOf(parameter));
}

QString directionTitle(int index, const std::string& parameter) {
    return ResonatorWords::tr("Run %1: %2 of its direction")
        .arg(index + 1)
        .arg(symbolOf(parameter));
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

}  // namespace vybeg::ui
