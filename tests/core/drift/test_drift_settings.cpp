// The options of whole-angle logs as a table.
#include "core/base/error.h"
#include "core/drift/drift_settings.h"
#include "core/drift/whole_angle_drift.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>
#include <string>

namespace test_drift_settings {

using namespace vybeg;

namespace {

const SettingRow<DriftSettings>& row(const std::string& name) {
    return *std::ranges::find(drift_settings(), name, &SettingRow<DriftSettings>::name);
}

}  // namespace

class TestDriftSettings : public QObject {
    Q_OBJECT

private slots:
    void every_option_reads_back_from_its_text() {
        const std::map<std::string, std::string> values{{"columns", "t,theta=angle,amplitude=6"},
                                                        {"angle-unit", "deg"},
                                                        {"tolerance", "kappa=1e-4,skew=0.01deg"},
                                                        {"rate", "10"},
                                                        {"delimiter", "semicolon"},
                                                        {"decimal", "comma"},
                                                        {"skip-lines", "3"},
                                                        {"time-column", "none"},
                                                        {"time-unit", "ms"}};
        DriftSettings settings;
        for (const SettingRow<DriftSettings>& each : drift_settings()) {
            QVERIFY2(values.contains(each.name), each.name.c_str());
            QVERIFY2(each.read(values.at(each.name), settings), each.name.c_str());
        }
        DriftSettings again;
        for (const SettingRow<DriftSettings>& each : drift_settings()) {
            QVERIFY2(each.read(each.text(settings), again), each.name.c_str());
            QVERIFY2(each.check(again), each.name.c_str());
        }
        QVERIFY(again == settings);
        QVERIFY(settings != DriftSettings{});
        QCOMPARE(settings.log.names, std::string("t,theta=angle,amplitude=6"));
        QCOMPARE(settings.log.rad_per_angle_unit, std::numbers::pi / 180);
        QCOMPARE(settings.open.rate_hz, std::optional(10.0));
        QCOMPARE(settings.open.text->time_unit_s, std::optional(1e-3));
    }

    void what_is_not_told_is_usual() {
        const ChannelTolerance usual = pick_offs({});
        QVERIFY(usual == usual_pick_offs());
        VYBEG_CLOSE(usual[kappa_error], 0.01, 1e-15);
        VYBEG_CLOSE(usual[skew_error], 0.1 * std::numbers::pi / 180, 1e-15);
        Tolerance told;
        told[kappa_error] = 0;
        told[skew_error] = 0.5;
        QCOMPARE(pick_offs(told)[kappa_error], 0.0);
        VYBEG_CLOSE(pick_offs(told)[skew_error], 0.5 * std::numbers::pi / 180, 1e-15);
    }

    void what_cannot_be_is_refused_by_name() {
        DriftSettings settings;
        for (const auto& [name, value] :
             {std::pair{"columns", "t,phi"}, std::pair{"columns", "t"},
              std::pair{"angle-unit", "grad"}, std::pair{"tolerance", "delay=1ns"},
              std::pair{"tolerance", "kappa=-1"}, std::pair{"rate", "fast"}}) {
            const Status read = row(name).read(value, settings);
            QVERIFY2(!read, name);
            QVERIFY2(QString::fromStdString(english(read.error())).contains(name),
                     english(read.error()).c_str());
        }
        QVERIFY(settings == DriftSettings{});
    }
};

VYBEG_TEST(TestDriftSettings)

}  // namespace test_drift_settings

#include "test_drift_settings.moc"
