#include "ui/words/display_units.h"

#include "core/base/number_text.h"
#include "core/output/quantity_text.h"

#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace vybeg::ui {

QString groupedDigits(const QString& number) {
    constexpr qsizetype group = 3;
    constexpr qsizetype undivided = 4;
    QString text;
    bool fraction = false;
    for (qsizetype begin = 0, end = 0; begin < number.size(); begin = end) {
        while (end < number.size() && number[end].isDigit()) {
            ++end;
        }
        const qsizetype digits = end - begin;
        for (qsizetype k = 0; k < digits; ++k) {
            if (k > 0 && digits > undivided && (fraction ? k : digits - k) % group == 0) {
                text += QChar(0x202f);
            }
            text += number[begin + k];
        }
        if (end < number.size()) {
            fraction = number[end] == '.' || number[end] == ',';
            text += number[end++];
        }
    }
    return text;
}

QString numberLabel(double value, int decimals) {
    // What rounds to zero is zero, not minus zero.
    const double shown = std::abs(value) < 0.5 * std::pow(10., -decimals) ? 0 : value;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return groupedDigits(locale.toString(shown, 'f', decimals)).replace('-', QChar(0x2212));
}

QString countLabel(std::int64_t count) {
    return numberLabel(static_cast<double>(count), 0);
}

QString powerOfTen(int exponent) {
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = QStringLiteral("10");
    for (const QChar c : QString::number(exponent)) {
        text += c == '-' ? QChar(0x207b) : digits[c.digitValue()];
    }
    return text;
}

QString numberText(const QString& of_core) {
    static const QRegularExpression number(
        QStringLiteral("^(-?)(\\d+(?:\\.\\d+)?)(?:e([-+]?\\d+))?$"));
    const QRegularExpressionMatch match = number.match(of_core);
    if (!match.hasMatch()) {
        return of_core;
    }
    const QString power = match.captured(3).isEmpty()
                              ? QString()
                              : QStringLiteral("·") + powerOfTen(match.captured(3).toInt());
    return (match.captured(1).isEmpty() ? QString() : QStringLiteral("−")) +
           groupedDigits(match.captured(2).replace(QLatin1Char('.'), QLocale().decimalPoint())) +
           power;
}

QString shortNumberText(double value, int digits) {
    return numberText(QString::fromStdString(short_text(value, digits)));
}

QString siPrefix(int exponent) {
    static constexpr std::array<const char*, 10> prefixes{
        QT_TRANSLATE_NOOP("SiPrefix", "f"), QT_TRANSLATE_NOOP("SiPrefix", "p"),
        QT_TRANSLATE_NOOP("SiPrefix", "n"), QT_TRANSLATE_NOOP("SiPrefix", "µ"),
        QT_TRANSLATE_NOOP("SiPrefix", "m"), "",
        QT_TRANSLATE_NOOP("SiPrefix", "k"), QT_TRANSLATE_NOOP("SiPrefix", "M"),
        QT_TRANSLATE_NOOP("SiPrefix", "G"), QT_TRANSLATE_NOOP("SiPrefix", "T")};
    const int place = exponent / 3 + 5;
    const char* prefix = prefixes[static_cast<std::size_t>(place)];
    return *prefix ? QCoreApplication::translate("SiPrefix", prefix) : QString();
}

QString secondsText(double seconds) {
    const int place = seconds > 0 ? static_cast<int>(std::floor(std::log10(seconds))) : 0;
    const int exponent = std::clamp(3 * static_cast<int>(std::floor(place / 3.)), -9, 0);
    return numberLabel(seconds * std::pow(10., -exponent), std::max(0, 2 + exponent - place)) +
           QLatin1Char(' ') + siPrefix(exponent) + unitText("s");
}

namespace {

QString textOf(const QuantityText& quantity) {
    QString text = numberText(QString::fromStdString(quantity.value));
    if (!quantity.sd.empty()) {
        text += QStringLiteral(" ± ") + numberText(QString::fromStdString(quantity.sd));
    }
    const auto power = [](int exponent) {
        return exponent == 0 ? QString() : QStringLiteral("·") + powerOfTen(exponent);
    };
    if (quantity.exponent != 0) {
        text = (quantity.sd.empty() ? text : QStringLiteral("(%1)").arg(text)) +
               power(quantity.exponent);
    }
    return quantity.u.empty() ? text
                              : QStringLiteral("%1 (u %2)")
                                    .arg(text, numberText(QString::fromStdString(quantity.u)) +
                                                   power(quantity.u_exponent));
}

struct Unit {
    const char* name = "";
    bool takes_prefix = false;
    double factor = 1;        // from stored to displayed values
    const char* before = "";  // the symbol
    const char* behind = "";
};

// In the order of the enumerations.
constexpr std::array<Unit, 2> amplitude_units{Unit{},
                                              {QT_TRANSLATE_NOOP("DisplayUnits", "dB"), false}};
constexpr std::array<Unit, 2> angle_units{Unit{QT_TRANSLATE_NOOP("DisplayUnits", "rad"), true},
                                          {"°", false, 180 / std::numbers::pi}};
constexpr std::array<Unit, 4> frequency_units{
    Unit{QT_TRANSLATE_NOOP("DisplayUnits", "Hz"), true, 1, "", "/2π"},
    {QT_TRANSLATE_NOOP("DisplayUnits", "rad/s"), true, 2 * std::numbers::pi},
    {QT_TRANSLATE_NOOP("DisplayUnits", "Hz"), true, 1, "", "/2π − f_0"},
    {QT_TRANSLATE_NOOP("DisplayUnits", "ppm"), false, 1, "Δ", "/ω_0"}};

Unit unitOf(SlowVariable variable, const DisplayUnits& units) {
    switch (info(variable).quantity) {
        case Quantity::amplitude: return amplitude_units[static_cast<std::size_t>(units.amplitude)];
        case Quantity::angle: return angle_units[static_cast<std::size_t>(units.angle)];
        case Quantity::frequency: return frequency_units[static_cast<std::size_t>(units.frequency)];
        case Quantity::ratio: break;
    }
    return {};
}

bool isSingleAngle(SlowVariable variable, const DisplayUnits& units) {
    return variable == SlowVariable::two_theta_A && units.wave_angle != WaveAngle::doubled;
}

// For lupdate: those that files name most.
[[maybe_unused]] constexpr const char* units_of_files[] = {QT_TRANSLATE_NOOP("DisplayUnits", "V"),
                                                           QT_TRANSLATE_NOOP("DisplayUnits", "mV")};

// One that a file names, too: others than these are as they are.
QString translatedUnit(const QString& unit) {
    return unit.isEmpty() ? unit
                          : QCoreApplication::translate("DisplayUnits", unit.toUtf8().constData());
}

}  // namespace

double DisplayScale::onBranch(double stored) const {
    return period > 0 ? stored - period * std::floor((stored - middle) / period + 0.5) : stored;
}

double DisplayScale::value(double stored) const {
    return decibels ? 20 * std::log10(std::abs(stored)) : (onBranch(stored) - origin) * factor;
}

double DisplayScale::sd(double stored, double sd) const {
    return decibels ? 20 / std::numbers::ln10 * sd / std::abs(stored) : std::abs(factor) * sd;
}

DisplayScale displayScale(SlowVariable variable, const DisplayUnits& units, double f0_hz) {
    const Quantity quantity = info(variable).quantity;
    const bool ppm = units.frequency == FrequencyUnit::deviation_ppm;
    DisplayScale scale;
    scale.decibels = quantity == Quantity::amplitude && units.amplitude == AmplitudeUnit::decibels;
    scale.logarithmic = variable == SlowVariable::a_A && units.log_a_A && !scale.decibels;
    scale.factor = unitOf(variable, units).factor;
    if (quantity == Quantity::frequency &&
        (ppm || units.frequency == FrequencyUnit::deviation_hertz)) {
        scale.origin = f0_hz;
        scale.factor = ppm && f0_hz > 0 ? 1e6 / f0_hz : 1;
    }
    if (isSingleAngle(variable, units)) {
        const bool whole = units.wave_angle == WaveAngle::continuous;
        scale.factor /= 2;
        scale.period = whole ? 0 : std::numbers::pi;
        scale.middle = units.wave_angle == WaveAngle::from_zero ? std::numbers::pi / 2 : 0;
    }
    return scale;
}

QString displaySymbol(SlowVariable variable, const DisplayUnits& units) {
    const Unit unit = unitOf(variable, units);
    const char* symbol = isSingleAngle(variable, units) ? "θ_A" : info(variable).symbol;
    return QString::fromUtf8(unit.before) + QString::fromUtf8(symbol) +
           QString::fromUtf8(unit.behind);
}

QString displayUnit(SlowVariable variable, const DisplayUnits& units, const QString& of_file) {
    const char* name = unitOf(variable, units).name;
    const bool amplitude = info(variable).quantity == Quantity::amplitude;
    return translatedUnit(*name ? QString::fromUtf8(name) : amplitude ? of_file : QString());
}

bool takesPrefix(SlowVariable variable, const DisplayUnits& units, const QString& of_file) {
    const Unit unit = unitOf(variable, units);
    return *unit.name ? unit.takes_prefix : takesPrefix(displayUnit(variable, units, of_file));
}

bool takesPrefix(const QString& of_file) {
    return of_file.size() == 1;
}

QString displayMeaning(SlowVariable variable) {
    return QCoreApplication::translate("SlowVariable", info(variable).meaning);
}

bool isWrapped(SlowVariable variable) {
    return variable == SlowVariable::delta_phi_CD || variable == SlowVariable::alpha;
}

QString threeDigits(double value) {
    constexpr int digits = 3;
    if (!std::isfinite(value) || value == 0) {
        return valueText(value, 0);
    }
    const double rounded = *parse_number(short_text(value, digits));
    // The deviation whose only digit is in the place of the last one.
    const double last = std::floor(std::log10(std::abs(rounded))) - (digits - 1);
    QuantityText quantity = quantity_text(rounded, 3 * std::pow(10.0, last));
    quantity.sd.clear();
    return textOf(quantity);
}

namespace {

// A deviation in units of its last digit, in brackets; empty without one.
QString inLastDigit(std::string sd, int zeros) {
    std::erase(sd, '.');
    sd.erase(0, std::min(sd.find_first_not_of('0'), sd.size()));
    return sd.empty() ? QString()
                      : QStringLiteral("(%1%2)").arg(QString::fromStdString(sd),
                                                     QString(std::max(0, zeros), '0'));
}

}  // namespace

QString conciseText(double value, double sd) {
    if (!std::isfinite(value)) {
        return QStringLiteral("—");
    }
    QuantityText quantity = quantity_text(value, sd);
    const QString deviation = inLastDigit(std::exchange(quantity.sd, {}), 0);
    const int exponent = std::exchange(quantity.exponent, 0);
    const QString text = textOf(quantity) + deviation;
    return exponent == 0 ? text : text + QStringLiteral("·") + powerOfTen(exponent);
}

QString conciseText(double value, double sd, int power) {
    if (!std::isfinite(value)) {
        return QStringLiteral("—");
    }
    const QuantityText quantity = quantity_text(value, sd);
    const std::size_t point = std::min(quantity.value.find('.'), quantity.value.size() - 1);
    const int shift = quantity.exponent - power;
    const int decimals = static_cast<int>(quantity.value.size() - 1 - point) - shift;
    const double rounded = parse_number(quantity.value).value_or(value) * std::pow(10., shift);
    return numberLabel(rounded, std::max(0, decimals)) + inLastDigit(quantity.sd, -decimals);
}

QString valueText(double value, double sd, double u) {
    if (!std::isfinite(value)) {
        return QStringLiteral("—");
    }
    return textOf(quantity_text(value, sd, u));
}

QString uncertaintyLabel(double value, double sd, double u) {
    const QuantityText quantity = quantity_text(value, sd, u);
    const bool own = !quantity.u.empty();
    return textOf(
        {own ? quantity.u : quantity.sd, {}, own ? quantity.u_exponent : quantity.exponent});
}

QString exactText(double value) {
    return std::isnan(value) ? QString()
                             : QLocale().toString(value, 'g', QLocale::FloatingPointShortest);
}

QString unitText(const char* unit) {
    // Those that core/ gives with its parameters and in its warnings.
    static constexpr std::array<const char*, 9> known{
        QT_TRANSLATE_NOOP("Resonator", "Hz"),
        QT_TRANSLATE_NOOP("Resonator", "s"),
        QT_TRANSLATE_NOOP("Resonator", "1/s"),
        QT_TRANSLATE_NOOP("Resonator", "Hz per squared unit"),
        QT_TRANSLATE_NOOP("Resonator", "rad"),
        QT_TRANSLATE_NOOP("Resonator", "deg"),
        QT_TRANSLATE_NOOP("Resonator", "deg/h"),
        QT_TRANSLATE_NOOP("Resonator", "ns"),
        QT_TRANSLATE_NOOP("Resonator", "ppm")};
    for (const char* each : known) {
        if (QLatin1String(each) == QLatin1String(unit)) {
            return ResonatorWords::tr(each);
        }
    }
    return QString::fromLatin1(unit);
}

QString withUnit(const QString& name, const QString& unit) {
    return unit.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, unit);
}

QString commonUnit(const QStringList& units) {
    return !units.isEmpty() && units.count(units.first()) == units.size() ? units.first()
                                                                          : QString();
}

QString fileUnit(const Recording& recording) {
    const auto unit = [&](int channel) {
        return QString::fromStdString(
            recording.channels[static_cast<std::size_t>(channel - 1)].unit);
    };
    return commonUnit({unit(recording.channel_c), unit(recording.channel_d)});
}

QString channelUnit(const Recording& recording) {
    return translatedUnit(fileUnit(recording));
}

}  // namespace vybeg::ui
