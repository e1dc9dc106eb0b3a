#include "core/base/number_text.h"
#include "tests/core/base/comma_locale.h"
#include "tests/test_registry.h"

#include <QTest>

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

namespace test_number_text {

using namespace vybeg;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

class TestNumberText : public QObject {
    Q_OBJECT

    // What must hold in any locale.
    static void verify_texts() {
        QCOMPARE(round_trip_text(0.1), "0.1");
        QCOMPARE(round_trip_text(-1234567.5), "-1234567.5");
        QCOMPARE(short_text(12345.678), "12345.7");
        QCOMPARE(short_text(2.0 / 3, 3), "0.667");
        QCOMPARE(integer_text(-1234567), "-1234567");
        QCOMPARE(parse_number("1234.5"), std::optional(1234.5));
        QCOMPARE(parse_number("1,5"), std::optional<double>());
    }

private slots:
    void every_finite_double_reads_back_as_itself() {
        std::mt19937_64 random(11);
        for (int i = 0; i < 200000; ++i) {
            const auto value = std::bit_cast<double>(random());
            if (!std::isfinite(value)) {
                continue;
            }
            const std::optional<double> read = parse_number(round_trip_text(value));
            QVERIFY2(read && same_bits(*read, value), round_trip_text(value).c_str());
        }
    }

    void the_ends_of_the_range_read_back_as_themselves() {
        using Limits = std::numeric_limits<double>;
        for (const double value : {0.0, -0.0, Limits::min(), Limits::denorm_min(), Limits::max(),
                                   Limits::lowest(), Limits::epsilon(), infinity, -infinity}) {
            const std::optional<double> read = parse_number(round_trip_text(value));
            QVERIFY2(read && same_bits(*read, value), round_trip_text(value).c_str());
        }
    }

    void no_value_is_nan_without_a_sign() {
        for (const double value : {no_value, -no_value}) {
            QCOMPARE(round_trip_text(value), "nan");
            QCOMPARE(short_text(value), "nan");
        }
        const auto read = parse_number("nan");
        QVERIFY(read && std::isnan(*read));
    }

    void a_number_is_appended_as_it_is_written() {
        std::string text = "x,";
        append_round_trip(text, 0.1);
        text += ',';
        append_round_trip(text, -no_value);
        QCOMPARE(text, "x,0.1,nan");
    }

    void short_text_has_the_digits_asked_for() {
        QCOMPARE(short_text(5300.123456), "5300.12");
        QCOMPARE(short_text(5300.123456, 9), "5300.12346");
        QCOMPARE(short_text(1.5e-7, 2), "1.5e-07");
        QCOMPARE(short_text(1e300), "1e+300");
        QCOMPARE(short_text(104.2, 2), "100");
        QCOMPARE(short_text(-11074, 2), "-11000");
        QCOMPARE(short_text(999999, 3), "1000000");
        QCOMPARE(short_text(1.25e6, 2), "1.2e+06");
        QCOMPARE(short_text(42), "42");
        QCOMPARE(short_text(0), "0");
    }

    void whole_numbers_keep_all_their_digits() {
        QCOMPARE(integer_text(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
        QCOMPARE(integer_text(std::numeric_limits<std::int64_t>::max()), "9223372036854775807");
        QCOMPARE(integer_text(0), "0");
    }

    void numbers_are_understood_in_every_notation_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("integer") << QByteArray("33333") << 33333.0;
        QTest::newRow("negative") << QByteArray("-1.25") << -1.25;
        QTest::newRow("exponent") << QByteArray("1e-3") << 1e-3;
        QTest::newRow("capital exponent") << QByteArray("2.5E+04") << 25000.0;
        QTest::newRow("no leading zero") << QByteArray(".5") << 0.5;
        QTest::newRow("no decimals") << QByteArray("5.") << 5.0;
        QTest::newRow("infinite") << QByteArray("-inf") << -infinity;
    }

    void numbers_are_understood_in_every_notation() {
        QFETCH(QByteArray, text);
        QFETCH(double, value);
        const std::optional<double> read = parse_number(text.toStdString());
        QVERIFY(read);
        QVERIFY(same_bits(*read, value));
    }

    void what_is_not_wholly_a_number_is_refused_data() {
        QTest::addColumn<QByteArray>("text");
        for (const char* text : {"", " ", "1 ", " 1", "+1", "1,5", "1.5.2", "1e", "e5", "-", ".",
                                 "0x10", "1.5 Hz", "1'000", "--1", "1e999", "1e-999", "nanx"}) {
            QTest::newRow(text[0] == '\0' ? "empty" : text) << QByteArray(text);
        }
    }

    void what_is_not_wholly_a_number_is_refused() {
        QFETCH(QByteArray, text);
        QVERIFY(!parse_number(text.toStdString()));
    }

    void the_point_stays_a_point_in_a_locale_with_a_comma() {
        verify_texts();
        const vybeg::test::CommaLocale locale;
        QVERIFY(locale.active());
        std::array<char, 16> printed;
        std::snprintf(printed.data(), printed.size(), "%g", 1.5);
        QCOMPARE(printed.data(), "1,5");  // the locale does what it is here for
        verify_texts();
    }
};

VYBEG_TEST(TestNumberText)

}  // namespace test_number_text

#include "test_number_text.moc"
