// What names, units and rates of files mean.
#include "core/recording/samples/vocabulary.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QTest>

namespace test_vocabulary {

using namespace vybeg;

class TestVocabulary : public QObject {
    Q_OBJECT

private slots:
    void names_mean_the_same_in_every_spelling_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("meaning");
        const auto row = [](const char* name, Meaning meaning) {
            QTest::newRow(name) << QString::fromUtf8(name) << static_cast<int>(meaning);
        };
        row("Time", Meaning::time);
        row("ВРЕМЯ", Meaning::time);
        row("[Elapsed\u00A0Time]", Meaning::time);
        row("X_Value", Meaning::time);
        row("No.", Meaning::counter);
        row("", Meaning::counter);
        row("\"Sample number\"", Meaning::counter);
        row("Комментарий", Meaning::remark);
        row("S_C", Meaning::channel_c);
        row("(Channel D)", Meaning::channel_d);
        row("Sample Rate:", Meaning::rate);
        row("sampling\u2212rate", Meaning::rate);
        row("Частота дискретизации =", Meaning::rate);
        row("X-Incr", Meaning::step);
        row("Vertical Units :", Meaning::units);
        row("Horizontal Units", Meaning::axis_unit);
        row("Counts", Meaning::unit);
        row("Temperature", Meaning::other);
        row("times two", Meaning::other);
        row("elapsed  elapsedtime", Meaning::other);
    }

    void names_mean_the_same_in_every_spelling() {
        QFETCH(QString, name);
        QFETCH(int, meaning);
        QCOMPARE(static_cast<int>(meaning_of(name.toStdString())), meaning);
    }

    void some_names_hold_in_one_kind_of_file() {
        QVERIFY(meaning_of("Delta", NamedIn::text) == Meaning::step);
        QVERIFY(meaning_of("Delta", NamedIn::variables) == Meaning::other);
        QVERIFY(meaning_of("Ts", NamedIn::text) == Meaning::other);
        QVERIFY(meaning_of("Ts", NamedIn::variables) == Meaning::step);
        QVERIFY(meaning_of("Fs", NamedIn::text) == Meaning::rate);
        QVERIFY(meaning_of("Fs", NamedIn::variables) == Meaning::rate);
    }

    void times_are_named_with_their_unit() {
        for (const char* name : {"t", "t_ms", "TimeMs", "Время мкс", "elapsed time_s"}) {
            QVERIFY2(is_time_name(name), name);
        }
        for (const char* name : {"T", "Т", "tms", "rate_ms", "t_V", "temperature"}) {
            QVERIFY2(!is_time_name(name), name);
        }
        QCOMPARE(time_unit({"t_ms", ""}), std::string("ms"));
        QCOMPARE(time_unit({"t_ms", "us"}), std::string("us"));
        QCOMPARE(time_unit({"Zeit", "V"}), std::string());
    }

    void units_have_factors() {
        VYBEG_CLOSE(seconds_per("MSEC").value(), 1e-3, 1e-15);
        VYBEG_CLOSE(seconds_per("мкс").value(), 1e-6, 1e-18);
        VYBEG_CLOSE(seconds_per("мс.").value(), 1e-3, 1e-15);
        VYBEG_CLOSE(seconds_per("\u03BCs").value(), 1e-6, 1e-18);
        VYBEG_CLOSE(seconds_per("Min").value(), 60, 1e-12);
        for (const char* none : {"", "mmin", "V", "m/s", "s sec", "kHz"}) {
            QVERIFY2(!seconds_per(none), none);
        }
        VYBEG_CLOSE(unit_ratio("mV", "V").value(), 1e-3, 1e-15);
        VYBEG_CLOSE(unit_ratio("MV", "V").value(), 1e6, 1e-6);
        VYBEG_CLOSE(unit_ratio("мкВ", "Volt DC").value(), 1e-6, 1e-18);
        VYBEG_CLOSE(unit_ratio("x", "x").value(), 1, 1e-15);
        QVERIFY(!unit_ratio("V", "A"));
        QVERIFY(!unit_ratio("V", "x"));
        QVERIFY(!unit_ratio("m", "m/s"));
        QVERIFY(is_known_unit("m/s²") && !is_known_unit("ms") && is_any_unit("ms"));
        QVERIFY(is_unit_below_name("uv") && is_unit_below_name("LSB") && !is_unit_below_name("n"));
        QVERIFY(!is_known_unit("LSB") && !is_known_unit("a"));
    }

    void rates_have_units_of_their_own() {
        VYBEG_CLOSE(hertz_per("mhz").value(), 1e6, 1e-6);
        VYBEG_CLOSE(hertz_per("MSa/s").value(), 1e6, 1e-6);
        VYBEG_CLOSE(hertz_per("КГЦ").value(), 1e3, 1e-9);
        QVERIFY(!hertz_per("s") && !hertz_per("mSamples/s"));
        VYBEG_CLOSE(rate_by_name("Sampling_Rate", 10, "kHz").value(), 1e4, 1e-8);
        VYBEG_CLOSE(rate_by_name("dt", 0.1, "ms").value(), 1e4, 1e-8);
        VYBEG_CLOSE(rate_by_name("Sampling Rate (kHz)", 33.333).value(), 33333, 1e-8);
        QVERIFY(!rate_by_name("Sampling Rate (V)", 33.333));
        QVERIFY(!rate_by_name("dt", 0) && !rate_by_name("fs", -1) && !rate_by_name("fs", 1, "V"));
        QVERIFY(!rate_by_name("delta", 1));
    }
};

VYBEG_TEST(TestVocabulary)

}  // namespace test_vocabulary

#include "test_vocabulary.moc"
