#include "core/analysis/setting_table.h"
#include "core/base/error.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace test_settings {

using namespace vybeg;

namespace {

// Other settings than the defaults in every field that has a row.
Settings all_changed() {
    Settings s;
    s.algorithm = Algorithm::conjugate_gradient;
    s.window = 61;
    s.periods = 10.1;
    s.snap = true;
    s.hop = 7;
    s.f0_hz = 5300.1;
    s.initial = StartValues{{1.1, -2e-7, 0.3, 1.0 / 3}, 5300.25};
    s.start = StartRule::previous;
    s.from_s = 0.1;
    s.to_s = 27.3;
    s.band = Band{5000.1, 5600};
    s.filter = Band{0, 6000.7};
    s.calibration = {.kappa = 1.01,
                     .offset_c = 0.1,
                     .offset_d = -1e-9,
                     .delay_d_s = 1e-9,
                     .angle_zero_deg = 22.5};
    s.repair_lost = true;
    s.threads = 3;
    return s;
}

IdentifySettings all_of_identification_changed() {
    IdentifySettings s;
    s.signal = all_changed();
    s.windows = {.window = 500, .periods = 80.5, .snap = true};
    s.model = FitOptions::Model::free;
    s.tolerance[skew_error] = 0.1;
    s.threads = 3;
    s.logs.names = "Xc=3,Yc=4,Xd=5,Yd=6";
    s.logs.rad_per_angle_unit = std::numbers::pi / 180;
    s.logs.phasors = {PhasorFrame::common, 5300.1, -1, std::numbers::sqrt2, {4, 20.5}};
    return s;
}

// The settings that the texts of `from` give, read one by one into defaults.
template <class S>
S read_back(const std::vector<SettingRow<S>>& rows, const S& from) {
    S back;
    for (const SettingRow<S>& row : rows) {
        if (const Status read = row.read(row.text(from), back); !read) {
            qCritical("%s: %s", row.name.c_str(), english(read.error()).c_str());
        }
    }
    return back;
}

// Each row changes the settings: none of them reads into nothing.
template <class S>
std::string rows_without_field(const std::vector<SettingRow<S>>& rows, const S& changed) {
    std::string idle;
    for (const SettingRow<S>& row : rows) {
        S alone;
        if (!row.read(row.text(changed), alone) || alone == S{}) {
            idle += row.name + " ";
        }
    }
    return idle;
}

}  // namespace

class TestSettings : public QObject {
    Q_OBJECT

private slots:
    void defaultsAreThoseOfTheCommandLine() {
        const Settings settings;
        QVERIFY(validate(settings));
        QVERIFY(settings.algorithm == Algorithm::maximum_likelihood);
        QCOMPARE(settings.window, 60);
        QVERIFY(settings.start == StartRule::first);
        QCOMPARE(settings.calibration.kappa, 1.0);
    }

    void whatLiesWithinItsBoundsIsAccepted() {
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

    void whatCannotBeIsRefusedByName_data() {
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
        row("electrode NaN", "--angle-zero",
            [=](Settings& s) { s.calibration.angle_zero_deg = nan; });
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
        row("far electrode", "--angle-zero",
            [](Settings& s) { s.calibration.angle_zero_deg = 361; });
        row("farthest electrode", "--angle-zero",
            [](Settings& s) { s.calibration.angle_zero_deg = -1e308; });
        row("threads below zero", "--threads", [](Settings& s) { s.threads = -2; });
    }

    void whatCannotBeIsRefusedByName() {
        QFETCH(std::function<void(Settings&)>, change);
        QFETCH(QString, option);
        Settings settings;
        change(settings);
        const Status status = validate(settings);
        QVERIFY(!status);
        QVERIFY(status.error().code == ErrorCode::setting_invalid);
        QCOMPARE(QString::fromStdString(english(status.error().args.at(0))), option);
        QCOMPARE(exit_status(status.error().code), 2);
    }

    void everySettingReadsBackFromItsText() {
        QVERIFY(read_back(analysis_settings(), all_changed()) == all_changed());
        QVERIFY(read_back(identify_settings(), all_of_identification_changed()) ==
                all_of_identification_changed());
        QCOMPARE(rows_without_field(analysis_settings(), all_changed()), std::string());
        QCOMPARE(rows_without_field(identify_settings(), all_of_identification_changed()),
                 std::string());
    }

    void theDefaultsReadBackToo() {
        QVERIFY(read_back(analysis_settings(), Settings{}) == Settings{});
        QVERIFY(read_back(identify_settings(), IdentifySettings{}) == IdentifySettings{});
        Settings offsets;
        offsets.calibration.offset_auto = true;
        QVERIFY(read_back(analysis_settings(), offsets) == offsets);
    }

    void settingsOfLogsAreListedWhereTheyAreTold() {
        const auto names = [](const IdentifySettings& settings) {
            std::set<std::string> all;
            for (const auto& [name, value] : settings_list(settings)) {
                all.insert(name);
            }
            return all;
        };
        const auto with = names(all_of_identification_changed());
        const auto without = names({});
        for (const SettingRow<LogChoice>& row : log_settings()) {
            QVERIFY2(with.contains(row.name), row.name.c_str());
            QVERIFY2(!without.contains(row.name), row.name.c_str());
        }
        QVERIFY(without.contains("kappa"));
        QCOMPARE(log_settings().size(), std::size_t{7});
    }

    void whatNoLogIsIsRefused_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("text");
        const auto row = [](const char* name, const char* text) {
            QTest::addRow("%s %s", name, text) << QString(name) << QString(text);
        };
        row("angle-unit", "turn");
        row("phasors", "moving");
        row("f-ref", "0");
        row("f-ref", "-5300");
        row("f-ref", "1e13");
        row("f-ref", "fast");
        row("y-sign", "1");
        row("amplitude", "mean");
        for (const char* text :
             {"9,20", "0,20", "1.5,20", "4", "4,0", "4,20,200", "4,", ",20", ""}) {
            row("lock-in", text);
        }
    }

    void whatNoLogIsIsRefused() {
        QFETCH(QString, name);
        QFETCH(QString, text);
        LogChoice choice;
        const auto row =
            std::ranges::find(log_settings(), name.toStdString(), &SettingRow<LogChoice>::name);
        const Status read = row->read(text.toStdString(), choice);
        QVERIFY(!read);
        QCOMPARE(QString::fromStdString(english(read.error().args.at(0))), "--" + name);
        QVERIFY(choice == LogChoice{});
    }

    void namesAreThoseOfOneRowEach() {
        const auto names = [](const auto& rows) {
            std::set<std::string> all;
            for (const auto& row : rows) {
                all.insert(row.name);
            }
            return all;
        };
        QCOMPARE(names(analysis_settings()).size(), analysis_settings().size());
        QCOMPARE(names(identify_settings()).size(), identify_settings().size());
        QVERIFY(validate(all_changed()));
        QVERIFY(validate(all_of_identification_changed()));
    }
};

VYBEG_TEST(TestSettings)

}  // namespace test_settings

#include "test_settings.moc"
