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
    void whatLiesWithinItsBoundsIsAccepted();
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

void TestSettings::whatLiesWithinItsBoundsIsAccepted() {
    Settings settings;
    settings.window = 1'000'000'000'000'000;
    settings.hop = settings.window;
    settings.f0_hz = 1e-6;
    settings.initial = StartValues{{1e30, -1e30, -1e6, 1e6}, 5300};
    settings.calibration.kappa = 1e6;
    settings.calibration.offset_c = -1e30;
    settings.calibration.delay_d_s = -1;
    settings.calibration.angle_zero_deg = -360;
    QVERIFY(validate(settings));
    settings.periods = 1e9;
    settings.calibration.kappa = 1e-6;
    settings.calibration.angle_zero_deg = 360;
    QVERIFY(validate(settings));
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
    row("huge window", "--window", [](Settings& s) { s.window = 1'000'000'000'000'001; });
    row("huge hop", "--hop", [](Settings& s) { s.hop = 1'000'000'000'000'001; });
    row("huge periods", "--periods", [](Settings& s) { s.periods = 1.1e9; });
    row("carrier next to zero", "--f0", [](Settings& s) { s.f0_hz = 1e-7; });
    row("huge start", "--initial", [](Settings& s) {
        s.initial = StartValues{{1e31, 0, 0, 0}, 5300};
    });
    row("start that turned often", "--initial", [](Settings& s) {
        s.initial = StartValues{{1, 0, 1e7, 0}, 5300};
    });
    row("huge gain", "--kappa", [](Settings& s) { s.calibration.kappa = 1.1e6; });
    row("tiny gain", "--kappa", [](Settings& s) { s.calibration.kappa = 0.9e-6; });
    row("huge offset", "--offset", [](Settings& s) { s.calibration.offset_c = -1e31; });
    row("long delay", "--delay", [](Settings& s) { s.calibration.delay_d_s = 1.1; });
    row("far electrode", "--angle-zero", [](Settings& s) { s.calibration.angle_zero_deg = 361; });
    row("farthest electrode", "--angle-zero",
        [](Settings& s) { s.calibration.angle_zero_deg = -1e308; });
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
