#pragma once

#include "core/base/describe.h"
#include "core/recording/samples/recording.h"
#include "core/track/track.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <limits>

namespace vybeg::ui {

// Runs of more than four digits of a number, before and after its decimal sign, in groups of
// three: "5300.000 171 7". The gap is a narrow no-break space, which number fields read over.
QString groupedDigits(const QString& number);

// Numbers beside an axis: the default locale's decimal sign, a true minus, digits in
// groups.
QString numberLabel(double value, int decimals);
// A number of things.
QString countLabel(std::int64_t count);
// A number as core/ writes it ("-2.03e+04", "12345.6"), so: "−2.03·10⁴", "12 345.6". Other texts as
// they are.
QString numberText(const QString& of_core);
// With so many significant digits at most; numbers below a million have no power of ten for their
// size.
QString shortNumberText(double value, int digits);

// "10⁻³".
QString powerOfTen(int exponent);

// A time with three digits: "2.72 ms".
QString secondsText(double seconds);

// The SI prefix of an exponent that is a multiple of 3 in [-15, 12], translated: "m" for -3.
QString siPrefix(int exponent);

enum class FrequencyUnit { hertz, radians_per_second, deviation_hertz, deviation_ppm };
enum class AngleUnit { radians, degrees };
enum class AmplitudeUnit { recording, decibels };
// 2theta_A as it is stored, or theta_A: continuous, or the one in [-45, 45) or in [0, 90) degrees
// of the angles 90 degrees apart that are, with alpha carried along, the same motion.
enum class WaveAngle { doubled, continuous, about_zero, from_zero };

// In which units and on which scale the engineer reads the slow variables.
struct DisplayUnits {
    FrequencyUnit frequency = FrequencyUnit::hertz;
    AngleUnit angle = AngleUnit::radians;
    WaveAngle wave_angle = WaveAngle::doubled;
    AmplitudeUnit amplitude = AmplitudeUnit::recording;
    bool log_a_A = false;  // no matter with decibels
    bool sigma_bands = true;

    friend bool operator==(const DisplayUnits&, const DisplayUnits&) = default;
};

template <class Archive, Described<DisplayUnits> Owner>
void describe(Archive&& archive, Owner& units) {
    archive.number("frequency", units.frequency, FrequencyUnit::deviation_ppm);
    archive.number("angle", units.angle, AngleUnit::degrees);
    archive.number("wave_angle", units.wave_angle, WaveAngle::from_zero);
    archive.number("amplitude", units.amplitude, AmplitudeUnit::decibels);
    archive("log_a_A", units.log_a_A);
    archive("sigma_bands", units.sigma_bands);
}

// From stored values (track.h) to displayed ones: (value - origin) * factor, or
// 20 lg |value| in decibels relative to one recording unit; of an angle on one branch the value in
// [middle - period/2, middle + period/2).
struct DisplayScale {
    double origin = 0;
    double factor = 1;
    bool decibels = false;
    bool logarithmic = false;  // of the axis; the values stay as they are
    double period = 0;         // stored units; 0: no branch
    double middle = 0;

    double onBranch(double stored) const;
    double value(double stored) const;
    // A standard deviation at a stored value, first order.
    double sd(double stored, double sd) const;

    friend bool operator==(const DisplayScale&, const DisplayScale&) = default;
};

// f0_hz is what the frequency's deviation is counted from.
DisplayScale displayScale(SlowVariable variable, const DisplayUnits& units, double f0_hz);

// The head of a plot: the symbol (an underscore introduces an index), e.g. "ω_cp/2π", and the
// unit, e.g. "Hz", of amplitudes `of_file`, as their file names it; empty where there is none.
QString displaySymbol(SlowVariable variable, const DisplayUnits& units);
QString displayUnit(SlowVariable variable, const DisplayUnits& units, const QString& of_file);

// True where the unit takes SI prefixes (Hz, rad, V); of a file, where it has one letter: a longer
// name may have a prefix ("mV").
bool takesPrefix(SlowVariable variable, const DisplayUnits& units, const QString& of_file);
bool takesPrefix(const QString& of_file);

// The variable's meaning in the interface's language.
QString displayMeaning(SlowVariable variable);

// Angles of which only the value modulo one turn is stored: no curve joins pi to -pi.
bool isWrapped(SlowVariable variable);

// "0.9987 ± 0.0012": core/output/quantity_text.h with the default locale's decimal sign, a true
// minus and digits in groups; "—" for NaN. With a combined uncertainty after it where that
// differs: "1.00034 ± 0.00005 (u 0.0003)".
QString valueText(double value, double sd, double u = std::numeric_limits<double>::quiet_NaN());
// A measured value without a deviation, with three digits: "0.000100".
QString threeDigits(double value);
// The combined uncertainty by itself, in the digits it has in valueText(): "0.0003".
QString uncertaintyLabel(double value, double sd, double u);
// The same as valueText(), shorter: the deviation in units of the value's last digit, "0.9987(12)".
QString conciseText(double value, double sd);
// In a column whose head has the power of ten.
QString conciseText(double value, double sd, int power);
// With the interface's decimal sign and all digits, for a spreadsheet; empty for NaN.
QString exactText(double value);

// Texts of context "Resonator", and a unit as core/ names it, in the interface's language.
struct ResonatorWords {
    Q_DECLARE_TR_FUNCTIONS(Resonator)
};
QString unitText(const char* unit);
QString withUnit(const QString& name, const QString& unit);

// That of all of them; empty where they differ.
QString commonUnit(const QStringList& units);
// The unit of both channels as the file names it; empty where they have none, or two.
QString fileUnit(const Recording& recording);
// The same in the interface's language.
QString channelUnit(const Recording& recording);

}  // namespace vybeg::ui
