// What stands beside and above the axes, as pure functions.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "ui/plots/axis_ticks.h"
#include "ui/words/display_units.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"

#include <QTextDocumentFragment>
#include <QtTest>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace test_axis_text {

using namespace vybeg;
using namespace vybeg::ui;

namespace {

// Digits 7 pixels wide, as in a font of 11 pixels.
TickRoom horizontal(double length) {
    return {length, 58, 16, [](const QString& label) { return 7. * double(label.size()); }};
}

TickRoom vertical(double length) {
    return {length, 27, 1, [](const QString&) { return 13.; }};
}

}  // namespace

class TestAxisText : public QObject {
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }

    void ticks_lie_at_round_numbers() {
        const AxisTicks ticks = linearTicks({0, 28}, horizontal(900));
        QCOMPARE(ticks.labels.first(), QStringLiteral("0"));
        QCOMPARE(ticks.labels.last(), QStringLiteral("28"));
        QCOMPARE(ticks.positions[1], 2.);
        QCOMPARE(ticks.offset, 0.);
        QCOMPARE(ticks.exponent, 0);
    }

    void a_narrow_range_far_from_zero_counts_from_an_offset() {
        const AxisTicks ticks = linearTicks({5299.998, 5300.011}, vertical(120));
        QCOMPARE(ticks.offset, 5300.);
        QCOMPARE(ticks.exponent, -3);
        QCOMPARE(ticks.labels,
                 QStringList({QStringLiteral("0"), QStringLiteral("5"), QStringLiteral("10")}));
        QCOMPARE(ticks.offsetText(), QStringLiteral(" − 5300.0"));
        QCOMPARE(scaledUnit(QStringLiteral("Hz"), true, ticks.exponent), QStringLiteral("mHz"));
    }

    void a_negative_offset_is_added() {
        const AxisTicks ticks = linearTicks({-5300.000002, -5299.999998}, vertical(120));
        QCOMPARE(ticks.offset, -5300.);
        QVERIFY(ticks.offsetText().startsWith(QStringLiteral(" + 5300")));
        QCOMPARE(ticks.exponent, -6);
    }

    void small_values_get_a_prefix_or_a_power() {
        const AxisTicks ticks = linearTicks({-4e-6, 4e-6}, vertical(120));
        QCOMPARE(ticks.exponent, -6);
        QCOMPARE(scaledUnit(QStringLiteral("rad"), true, -6), QStringLiteral("µrad"));
        QCOMPARE(scaledUnit(QStringLiteral("°"), false, -3), QStringLiteral("×10⁻³ °"));
        QCOMPARE(scaledUnit(QString(), false, 6), QStringLiteral("×10⁶"));
        QCOMPARE(scaledUnit(QStringLiteral("Hz"), true, 0), QStringLiteral("Hz"));
    }

    void degrees_step_by_parts_of_a_circle() {
        const AxisTicks ticks = linearTicks({-180, 180}, vertical(200), TickSteps::degrees);
        QCOMPARE(ticks.labels,
                 QStringList({QStringLiteral("−180"), QStringLiteral("−90"), QStringLiteral("0"),
                              QStringLiteral("90"), QStringLiteral("180")}));
    }

    // Over all magnitudes, spans and sizes: labels differ from each other, do not overlap, are
    // short, and say where their tick is.
    void no_range_and_no_size_gives_useless_ticks() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> exponent(-9, 9);
        std::uniform_real_distribution<double> unit(-1, 1);
        std::uniform_real_distribution<double> length(45, 2500);
        int pairs = 0;
        for (int i = 0; i < 4000; ++i) {
            const double middle = unit(random) * std::pow(10., exponent(random));
            // Down to 1e-10 of the value: doubles carry that with six digits to spare.
            const double span = std::max(std::pow(10., exponent(random)), 1e-10 * std::abs(middle));
            const AxisRange range{middle - 0.5 * span, middle + 0.5 * span};
            const bool across = i % 2 == 0;
            const TickRoom room = across ? horizontal(length(random)) : vertical(length(random));
            const AxisTicks ticks = linearTicks(range, room);
            QCOMPARE(ticks.labels.size(), qsizetype(ticks.positions.size()));
            pairs += ticks.positions.size() >= 2;
            std::set<QString> different;
            const double scale = room.length / span;
            double free_from = -1e9;
            for (qsizetype k = 0; k < ticks.labels.size(); ++k) {
                const double position = ticks.positions[std::size_t(k)];
                const QString& label = ticks.labels[k];
                QVERIFY(different.insert(label).second);
                VYBEG_AT_LEAST(position, range.lower - 1e-6 * span);
                VYBEG_AT_MOST(position, range.upper + 1e-6 * span);
                const double pixel = (position - range.lower) * scale;
                VYBEG_AT_LEAST(pixel - 0.5 * room.extent(label), free_from - 1e-3,
                               qPrintable(label));
                free_from = pixel + 0.5 * room.extent(label);
                QString plain = label;
                plain.remove(QChar(0x202f)).replace(QChar(0x2212), '-');
                VYBEG_AT_MOST(plain.size(), 9, qPrintable(label));
                const double read = plain.toDouble();
                const double meant = (position - ticks.offset) / std::pow(10., ticks.exponent);
                // Relative to the span: rounding of a decimal label.
                VYBEG_WITHIN((read - meant) * std::pow(10., ticks.exponent), 0, 1e-5 * span,
                             qPrintable(label));
            }
        }
        // Only labels that need half of a very short axis may stand alone.
        VYBEG_MORE(pairs, 3960);
    }

    void a_range_that_is_none_has_no_ticks() {
        QVERIFY(linearTicks({1, 1}, vertical(100)).positions.empty());
        QVERIFY(linearTicks({0, INFINITY}, vertical(100)).positions.empty());
        QVERIFY(logTicks({-1, 1}, vertical(100)).positions.empty());
    }

    void decades_are_labelled_on_a_logarithmic_axis() {
        const AxisTicks ticks = logTicks({1e-5, 10}, vertical(400));
        QCOMPARE(ticks.labels.first(), powerOfTen(-5));
        QVERIFY(ticks.labels.contains(QStringLiteral("0.001")));
        QVERIFY(ticks.labels.contains(QStringLiteral("10")));
        QVERIFY(!ticks.between.empty());
    }

    void less_than_a_decade_on_a_logarithmic_axis_has_linear_steps() {
        const AxisTicks ticks = logTicks({0.6, 1.02}, vertical(120));
        VYBEG_AT_LEAST(ticks.positions.size(), 2);
        QVERIFY(ticks.labels.contains(QStringLiteral("1.0")));
    }

    void numbers_follow_the_locale() {
        QCOMPARE(numberLabel(-1234.5, 2), QStringLiteral("−1234.50"));
        QLocale::setDefault(QLocale(QLocale::Russian));
        QCOMPARE(numberLabel(-1234.5, 2), QStringLiteral("−1234,50"));
        QCOMPARE(valueText(-0.5, 0.013), QStringLiteral("−0,500 ± 0,013"));
    }

    void more_than_four_digits_stand_in_groups_of_three() {
        for (const auto& [number, grouped] :
             {std::pair{"5300", "5300"}, std::pair{"-12345", "-12 345"},
              std::pair{"1234567", "1 234 567"}, std::pair{"0.1234", "0.1234"},
              std::pair{"0,12345", "0,123 45"}, std::pair{"499511.0000027", "499 511.000 002 7"},
              std::pair{"", ""}, std::pair{"—", "—"}}) {
            QCOMPARE(groupedDigits(QString::fromUtf8(number)).replace(QChar(0x202f), ' '),
                     QString::fromUtf8(grouped));
        }
        QCOMPARE(numberLabel(-20000, 0), QStringLiteral("−20\u202f000"));
        QCOMPARE(valueText(499511.04, 2.2), QStringLiteral("499\u202f511.0 ± 2.2"));
    }

    void a_number_of_core_has_no_exponent_of_programs() {
        QCOMPARE(shortNumberText(499511, 3), QStringLiteral("500\u202f000"));
        QCOMPARE(shortNumberText(120, 2), QStringLiteral("120"));
        QCOMPARE(shortNumberText(-2.034e7, 3), QStringLiteral("−2.03·10⁷"));
        QCOMPARE(shortNumberText(1.24e-5, 2), QStringLiteral("1.2·10⁻⁵"));
        QCOMPARE(numberText(QStringLiteral("12345.6")), QStringLiteral("12\u202f345.6"));
        QCOMPARE(numberText(QStringLiteral("run 1e+05")), QStringLiteral("run 1e+05"));
    }

    void nothing_is_minus_zero() {
        QCOMPARE(numberLabel(-1e-12, 2), QStringLiteral("0.00"));
        QCOMPARE(numberLabel(-0.0, 0), QStringLiteral("0"));
    }

    void a_value_is_rounded_to_its_deviation() {
        QCOMPARE(valueText(5300.012345, 0.0012), QStringLiteral("5300.0123 ± 0.0012"));
        QCOMPARE(valueText(2e-6, 1.5e-7), QStringLiteral("(2.00 ± 0.15)·10⁻⁶"));
        QCOMPARE(threeDigits(1.00121e-4), QStringLiteral("0.000\u202f100"));
        QCOMPARE(threeDigits(9.998e-5), QStringLiteral("0.000\u202f100"));
        QCOMPARE(threeDigits(9.994e-5), QStringLiteral("9.99·10⁻⁵"));
        QCOMPARE(threeDigits(12.0), QStringLiteral("12.0"));
        QCOMPARE(threeDigits(-0.0213456), QStringLiteral("−0.0213"));
        QCOMPARE(threeDigits(0), QStringLiteral("0"));
        QCOMPARE(threeDigits(NAN), QStringLiteral("—"));
        QCOMPARE(valueText(NAN, 1), QStringLiteral("—"));
        QCOMPARE(valueText(0.25, NAN), QStringLiteral("0.25"));
    }

    void an_event_has_three_digits_and_degrees() {
        const auto gap = [](double seconds) { return eventText({Flag::gap, 1, seconds, 0, 0}); };
        QCOMPARE(gap(0.0027213), QStringLiteral("Samples are missing, 2.72 ms"));
        QCOMPARE(gap(1.8), QStringLiteral("Samples are missing, 1.80 s"));
        QCOMPARE(gap(1234.5), QStringLiteral("Samples are missing, 1235 s"));
        QCOMPARE(secondsText(2.7e-5), QStringLiteral("27.0 µs"));
        QCOMPARE(secondsText(0.999), QStringLiteral("999 ms"));
        QCOMPARE(secondsText(18000), QStringLiteral("18\u202f000 s"));
        QCOMPARE(secondsText(0), QStringLiteral("0.00 s"));
        QCOMPARE(gap(0), QStringLiteral("Samples are missing"));  // of one window
        QCOMPARE(eventText({std::nullopt, 1, 0, -1, 1}),
                 QStringLiteral("2θ_A passes −90°, rising"));
    }

    void an_underscore_makes_an_index() {
        const std::vector<IndexTextPiece> expected{{QStringLiteral("⟨S"), false},
                                                   {QStringLiteral("A"), true},
                                                   {QStringLiteral(" S"), false},
                                                   {QStringLiteral("B"), true},
                                                   {QStringLiteral("⟩"), false}};
        QVERIFY(indexPieces(QStringLiteral("⟨S_A S_B⟩")) == expected);
        QCOMPARE(richText(QStringLiteral("Δφ_CD")), QStringLiteral("Δφ<sub>CD</sub>"));
        // No line breaks inside a number.
        QCOMPARE(richText(numberLabel(12345, 0)), QStringLiteral("12\u00a0345"));
        for (const char* name : {"s1_0.wav", "a_1.wav: 3 s", "run_2", "my_long_name", "a_", "s_1",
                                 "a_b: the mean", "gyro g_2, set f_1", "a_A.wav", "A_B_C"}) {
            QCOMPARE(richText(QString::fromLatin1(name)), QString::fromLatin1(name));
        }
        QCOMPARE(richText(QStringLiteral("d(a_B/a_A)/dt; θ_A.")),
                 QStringLiteral("d(a<sub>B</sub>/a<sub>A</sub>)/dt; θ<sub>A</sub>."));
        QCOMPARE(richText(QStringLiteral("a<b")), QStringLiteral("a&lt;b"));
        const auto path = QStringLiteral("/data/<b>bold</b> & <img src=x>.wav");
        QCOMPARE(QTextDocumentFragment::fromHtml(plainTip(path)).toPlainText(), path);
    }

    void every_unit_of_the_frequency_is_the_same_frequency() {
        DisplayUnits units;
        const double f = 5300.053;
        const double f0 = 5300;
        const auto shown = [&](FrequencyUnit unit) {
            units.frequency = unit;
            return displayScale(SlowVariable::f, units, f0).value(f);
        };
        QCOMPARE(shown(FrequencyUnit::hertz), f);
        QCOMPARE(shown(FrequencyUnit::radians_per_second), 2 * std::numbers::pi * f);
        VYBEG_CLOSE(shown(FrequencyUnit::deviation_hertz), 0.053, 1e-9);
        VYBEG_CLOSE(shown(FrequencyUnit::deviation_ppm), 10., 1e-6);
        QCOMPARE(displayScale(SlowVariable::f, units, f0).sd(f, 0.0053), 1.);
    }

    void decibels_and_their_deviation() {
        DisplayUnits units;
        units.amplitude = AmplitudeUnit::decibels;
        units.log_a_A = true;
        const DisplayScale scale = displayScale(SlowVariable::a_A, units, 0);
        QVERIFY(!scale.logarithmic);
        QCOMPARE(scale.value(0.1), -20.);
        // Against the difference quotient.
        const double slope = (scale.value(0.5 + 1e-6) - scale.value(0.5 - 1e-6)) / 2e-6;
        VYBEG_CLOSE(scale.sd(0.5, 0.01), 0.01 * slope, 1e-8);
        QCOMPARE(displayUnit(SlowVariable::a_A, units, "V"), QStringLiteral("dB"));
        QVERIFY(!takesPrefix(SlowVariable::a_A, units, "V"));
    }

    // Angles 90 degrees apart are one motion, whose branch is chosen.
    void every_branch_of_the_wave_angle_is_the_same_wave() {
        constexpr SlowVariable angle = SlowVariable::two_theta_A;
        DisplayUnits units;
        units.angle = AngleUnit::degrees;
        const auto scale = [&](WaveAngle choice) {
            units.wave_angle = choice;
            return displayScale(angle, units, 0);
        };
        for (const double doubled : {-275., -91., -90., -1., 0., 1., 89., 91., 179., 181., 3599.}) {
            const double stored = doubled * std::numbers::pi / 180;
            VYBEG_CLOSE(scale(WaveAngle::doubled).value(stored), doubled, 1e-9);
            VYBEG_CLOSE(scale(WaveAngle::continuous).value(stored), doubled / 2, 1e-9);
            for (const auto& [choice, least] :
                 {std::pair{WaveAngle::about_zero, -45.}, std::pair{WaveAngle::from_zero, 0.}}) {
                const double shown = scale(choice).value(stored);
                VYBEG_CLOSE(std::remainder(shown - doubled / 2, 90), 0, 1e-9);
                VYBEG_MORE(shown, least - 1e-9);
                VYBEG_LESS(shown, least + 90 - 1e-9);
            }
        }
        for (const WaveAngle choice :
             {WaveAngle::continuous, WaveAngle::about_zero, WaveAngle::from_zero}) {
            VYBEG_CLOSE(scale(choice).sd(1, 0.02), 0.5 * scale(WaveAngle::doubled).sd(1, 0.02),
                        1e-12);
            units.wave_angle = choice;
            QCOMPARE(displaySymbol(angle, units), QStringLiteral("θ_A"));
            QCOMPARE(displaySymbol(SlowVariable::alpha, units), QStringLiteral("α"));
            QVERIFY(displayScale(SlowVariable::alpha, units, 0) ==
                    displayScale(SlowVariable::alpha, {.angle = AngleUnit::degrees}, 0));
        }
        units.wave_angle = WaveAngle::doubled;
        QCOMPARE(displaySymbol(angle, units), QStringLiteral("2θ_A"));
    }

    void an_amplitude_has_the_unit_of_its_file() {
        const DisplayUnits units;
        QCOMPARE(displayUnit(SlowVariable::a_B, units, "V"), QStringLiteral("V"));
        QVERIFY(takesPrefix(SlowVariable::a_B, units, "V"));
        QVERIFY(!takesPrefix(SlowVariable::a_B, units, "mV"));
        QCOMPARE(displayUnit(SlowVariable::f, units, "V"), QStringLiteral("Hz"));
        QVERIFY(takesPrefix(SlowVariable::f, units, "mV"));
        QCOMPARE(commonUnit({"V", "V"}), QStringLiteral("V"));
        QCOMPARE(commonUnit({"V", "mV"}), QString());
    }
};

VYBEG_TEST(TestAxisText)

}  // namespace test_axis_text

#include "test_axis_text.moc"
