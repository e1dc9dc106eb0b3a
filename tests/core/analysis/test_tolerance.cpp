// Tolerances of the channels as text, and back.
#include "core/analysis/identify_settings.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

namespace test_tolerance {

using namespace vybeg;

class TestTolerance : public QObject {
    Q_OBJECT

private slots:
    void a_tolerance_is_read_in_its_unit_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("skew_deg");
        QTest::addColumn<double>("delay_s");
        QTest::addColumn<double>("phase_drift_rad");
        QTest::newRow("plain") << "skew=0.1,delay=1e-8,phase-drift=1e-4" << 0.1 << 1e-8 << 1e-4;
        QTest::newRow("units of their own")
            << "skew=0.1deg,delay=1e-8s,phase-drift=1e-4rad" << 0.1 << 1e-8 << 1e-4;
        QTest::newRow("smaller units")
            << "delay=10ns,skew=1.7453292519943295mrad,phase-drift=0.1mrad" << 0.1 << 1e-8 << 1e-4;
        QTest::newRow("larger and smaller units")
            << "delay=0.01us,skew=0.0017453292519943296rad,phase-drift=0.005729577951308232deg"
            << 0.1 << 1e-8 << 1e-4;
        QTest::newRow("ms, ps") << "delay=1e-5ms" << 0.0 << 1e-8 << 0.0;
        QTest::newRow("ps") << "delay=10000ps" << 0.0 << 1e-8 << 0.0;
        QTest::newRow("nothing") << "none" << 0.0 << 0.0 << 0.0;
    }

    void a_tolerance_is_read_in_its_unit() {
        QFETCH(QString, text);
        QFETCH(double, skew_deg);
        QFETCH(double, delay_s);
        QFETCH(double, phase_drift_rad);
        const Result<Tolerance> read = read_tolerance(text.toStdString());
        QVERIFY(read);
        const auto is = [](const std::optional<double>& given, double expected) {
            return given ? std::abs(*given - expected) <= 1e-14 * expected : expected == 0;
        };
        QVERIFY(is(read->at(skew_error), skew_deg));
        QVERIFY(is(read->at(delay_error), delay_s));
        QVERIFY(is(read->at(phase_drift_error), phase_drift_rad));
        QVERIFY(!read->at(kappa_error));
    }

    void ratios_may_be_percent_or_ppm() {
        const Result<Tolerance> read =
            read_tolerance("kappa=1%,crosstalk=100ppm,gain-drift=0.0001");
        QVERIFY(read);
        QCOMPARE(read->at(kappa_error).value_or(-1), 0.01);
        QCOMPARE(read->at(crosstalk_error).value_or(-1), 1e-4);
        QCOMPARE(read->at(gain_drift_error).value_or(-1), 1e-4);
        QVERIFY(read_tolerance("kappa=0")->at(kappa_error) == 0.0);  // exact is not "as usual"
        QVERIFY(read_tolerance("skew=0")->at(skew_error) == 0.0);
    }

    void the_clock_is_in_ppm() {
        for (const char* text : {"rate=2", "rate=2ppm", "rate=2000ppb", "rate=0.0002%"}) {
            const Result<Tolerance> read = read_tolerance(text);
            QVERIFY(read);
            VYBEG_CLOSE_RATIO(read->at(rate_error).value_or(-1), 2, 1e-14);
        }
    }

    void what_is_not_told_is_assumed() {
        const auto used = [](const Tolerance& tolerance, double kappa) {
            QStringList texts;
            for (const ToleranceInUse& each : tolerances_in_use(tolerance, kappa)) {
                texts << QString("%1=%2%3")
                             .arg(each.error.name)
                             .arg(each.value)
                             .arg(each.assumed ? "?" : "");
            }
            return texts.join(' ');
        };
        QCOMPARE(used({}, 1), QString("kappa=0.01? skew=0.1? delay=1e-08? crosstalk=0.0001? "
                                      "phase-drift=0.0001? gain-drift=0.0001?"));
        Tolerance told;
        told[skew_error] = told[crosstalk_error] = 0.0;
        told[delay_error] = 2e-8;
        told[rate_error] = 1.0;
        QCOMPARE(used(told, 1.02),
                 QString("delay=2e-08 phase-drift=0.0001? gain-drift=0.0001? rate=1"));
    }

    void kappa_is_exact_where_a_ratio_is_given() {
        QCOMPARE(assumed_tolerance(kappa_error, 1), 0.01);
        QCOMPARE(assumed_tolerance(kappa_error, 1.01), 0.0);
    }

    void its_text_reads_back() {
        Tolerance tolerance;
        QCOMPARE(tolerance_text(tolerance), std::string("none"));
        QVERIFY(*read_tolerance("none") == tolerance);
        tolerance = {0.003, 1.0 / 3, 1e-9 / 7, 1e-4, 2e-5, 3e-6, 0.5, 0.004};
        QVERIFY(*read_tolerance(tolerance_text(tolerance)) == tolerance);
        tolerance = {};
        tolerance[kappa_error] = 0.0;
        QCOMPARE(tolerance_text(tolerance), std::string("kappa=0"));
    }

    void what_cannot_be_is_refused_with_what_is_wrong_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* text, const char* part) {
            QTest::newRow(*text == '\0' ? "empty" : text) << text << part;
        };
        row("", "NAME=X");
        row("skew", "NAME=X");
        row("skew=0.1,", "NAME=X");
        row("tilt=0.1",
            "\"tilt\" is none of kappa, skew, delay, crosstalk, phase-drift, gain-drift, rate");
        row("skew=-0.1", "skew must be a number of zero or more, in deg");
        row("skew=nan", "skew must be");
        row("delay=inf", "delay must be a number of zero or more, in s");
        row("skew=", "skew must be");
        row("skew=deg", "skew must be");
        row("skew=0,1", "NAME=X");
        row("delay=10 ns ns", "delay must be");
        row("delay=0.1deg", "delay must be");
        row("kappa=0.1deg", "kappa must be a number of zero or more");
        row("skew=1,skew=2", "skew is given twice");
        row("kappa=1%,kappa=2%", "kappa is given twice");
    }

    void what_cannot_be_is_refused_with_what_is_wrong() {
        QFETCH(QString, text);
        QFETCH(QString, part);
        const Result<Tolerance> read = read_tolerance(text.toStdString());
        QVERIFY(!read);
        QVERIFY(read.error().code == ErrorCode::setting_invalid);
        QCOMPARE(read.error().args.at(0), std::string("--tolerance"));
        const QString said = QString::fromStdString(english(read.error().args.at(2)));
        QVERIFY2(said.contains(part), qPrintable(said));
    }
};

VYBEG_TEST(TestTolerance)

}  // namespace test_tolerance

#include "test_tolerance.moc"
