#include "core/analysis/settings.h"
#include "core/base/messages.h"

#include <QtTest>

#include <functional>
#include <limits>

using namespace vybeg;

class TestSettings : public QObject {
    Q_OBJECT

private slots:
    void defaultsAreThoseOfTheCommandLine();
    void whatCannotBeIsRefusedByName_data();
    void whatCannotBeIsRefusedByName();
};

void TestSettings::defaultsAreThoseOfTheCommandLine() {
    const Settings settings;
    QVERIFY(validate(settings));
    QVERIFY(settings.algorithm == Algorithm::maximum_likelihood);
    QCOMPARE(settings.window, 60);
    QVERIFY(settings.start == StartRule::first);
    QCOMPARE(settings.calibration.kappa, 1.0);
}

void TestSettings::whatCannotBeIsRefusedByName_data() {
    using Change = std::function<void(Settings&)>;
    QTest::addColumn<Change>("change");
    QTest::addColumn<QString>("option");
    const double nan = std::nan("");
    const double infinity = std::numeric_limits<double>::infinity();
    const auto row = [](const char* name, const char* option, Change change) {
        QTest::newRow(name) << change << option;
    };
    row("window of 4", "--window", [](Settings& s) { s.window = 4; });
    row("no periods", "--periods", [](Settings& s) { s.periods = 0; });
    row("endless periods", "--periods", [=](Settings& s) { s.periods = infinity; });
    row("backward hop", "--hop", [](Settings& s) { s.hop = -1; });
    row("negative carrier", "--f0", [](Settings& s) { s.f0_hz = -5300; });
    row("carrier NaN", "--f0", [=](Settings& s) { s.f0_hz = nan; });
    row("start without amplitude", "--initial", [](Settings& s) {
        s.initial = StartValues{{0, 0, 0, 0}, 5300};
    });
    row("start NaN", "--initial", [=](Settings& s) {
        s.initial = StartValues{{1, nan, 0, 0}, 5300};
    });
    row("start without frequency", "--initial", [](Settings& s) {
        s.initial = StartValues{{1, 0, 0, 0}, 0};
    });
    row("from NaN", "--from", [=](Settings& s) { s.from_s = nan; });
    row("to infinity", "--to", [=](Settings& s) { s.to_s = infinity; });
    row("falling band", "--band", [](Settings& s) { s.band = Band{6000, 5000}; });
    row("negative filter", "--filter", [](Settings& s) { s.filter = Band{-1, 5000}; });
    row("no gain", "--kappa", [](Settings& s) { s.calibration.kappa = 0; });
    row("offset NaN", "--offset", [=](Settings& s) { s.calibration.offset_d = nan; });
    row("delay NaN", "--delay", [=](Settings& s) { s.calibration.delay_d_s = nan; });
    row("electrode NaN", "--angle-zero", [=](Settings& s) { s.calibration.angle_zero_deg = nan; });
    row("threads below zero", "--threads", [](Settings& s) { s.threads = -2; });
}

void TestSettings::whatCannotBeIsRefusedByName() {
    QFETCH(std::function<void(Settings&)>, change);
    QFETCH(QString, option);
    Settings settings;
    change(settings);
    const Status status = validate(settings);
    QVERIFY(!status);
    QVERIFY(status.error().code == ErrorCode::setting_invalid);
    QCOMPARE(QString::fromStdString(status.error().args.at(0)), option);
    QCOMPARE(exit_status(status.error().code), 2);
}

QTEST_GUILESS_MAIN(TestSettings)
#include "test_settings.moc"
