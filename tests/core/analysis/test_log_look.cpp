// What a file tells of the log in it: its columns by their names, the frame, units; what it leaves
// to be asked.
#include "core/analysis/log_look.h"
#include "tests/needed.h"
#include "tests/test_registry.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace test_log_look {

using namespace vybeg;

class TestLogLook : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    // A table of 40 rows; `moving`: of the columns, by their place, whose values change.
    QString table(const QString& name, const QByteArray& head, int columns,
                  std::initializer_list<int> moving = {}, const char* separator = ",") const {
        QFile file(folder_.filePath(name));
        if (!file.open(QIODevice::WriteOnly)) {
            qFatal("no file");
        }
        file.write(head);
        for (int k = 0; k < 40; ++k) {
            for (int column = 0; column < columns; ++column) {
                const bool moves = std::ranges::find(moving, column) != moving.end();
                const double value = column == 0 ? 0.01 * k
                                     : moves     ? 5300 + 0.1 * std::sin(0.3 * k)
                                                 : 0.5 + 0.125 * column;
                file.write((column == 0 ? "" : separator) + QByteArray::number(value, 'g', 12));
            }
            file.write("\n");
        }
        return file.fileName();
    }

    LogLook look(const QString& path, const LogChoice& told = {}) const {
        return test::needed(look_at_log(path.toStdU16String(), {}, told, JobControl()));
    }

private slots:
    void the_frame_follows_from_the_columns_data() {
        QTest::addColumn<QByteArray>("head");
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("moving");  // 0: none
        QTest::addColumn<int>("frame");
        QTest::addColumn<QByteArray>("needs");  // f: reference, u: unit of angles
        const auto row = [](const char* head, int columns, int moving, PhasorFrame frame,
                            const char* needs) {
            QTest::newRow(head) << QByteArray(head) + '\n'
                                << columns << moving << static_cast<int>(frame)
                                << QByteArray(needs);
        };
        row("t,Xc,Yc,Xd,Yd", 5, 0, PhasorFrame::fixed, "f");
        row("t,Xc,Yc,Xd,Yd,F", 6, 0, PhasorFrame::fixed, "");
        row("t,Xc,Yc,Xd,Yd,F (Hz)", 6, 5, PhasorFrame::common, "");
        row("t,Xc,Yc,Xd,Yd,P (rad)", 6, 0, PhasorFrame::common, "f");
        row("t,Xc,Yc,Xd,Yd,P", 6, 0, PhasorFrame::common, "fu");
        row("t,Xc,Yc,Xd,Yd,F,P (deg)", 7, 0, PhasorFrame::common, "");
        row("t,Xc,Yc,Xd,Yd,Pc (cyc),Pd (cyc)", 7, 0, PhasorFrame::pll, "f");
        row("t,Xc,Yc,Xd,Yd,Pc,Pd,F", 8, 0, PhasorFrame::pll, "u");
    }
    void the_frame_follows_from_the_columns() {
        QFETCH(QByteArray, head);
        QFETCH(int, columns);
        QFETCH(int, moving);
        QFETCH(int, frame);
        QFETCH(QByteArray, needs);
        const QString path = moving > 0 ? table("frame.csv", head, columns, {moving})
                                        : table("frame.csv", head, columns);
        const LogLook seen = look(path);
        QVERIFY(!seen.problem);
        QCOMPARE(static_cast<int>(seen.choice.phasors.frame), frame);
        QCOMPARE(seen.needs_f_ref, needs.contains('f'));
        QCOMPARE(seen.needs_angle_unit, needs.contains('u'));
        QVERIFY(!seen.one_channel && !seen.needs_rate);
        // No data show these.
        QCOMPARE(seen.choice.phasors.y_sign, 0);
        QCOMPARE(seen.choice.phasors.peak_per_unit, 0.0);
        QVERIFY(!seen.preview.lines.empty());
    }

    void phases_with_the_whole_carrier_need_no_reference_and_deviations_do() {
        const auto log = [this](const QByteArray& head, const auto& last) {
            QByteArray text = head + '\n';
            for (int k = 0; k < 40; ++k) {
                text += QByteArray::number(0.01 * k) + ",1,0.5,0.3,0.2";
                for (const double value : last(k)) {
                    text += ',' + QByteArray::number(value, 'g', 15);
                }
                text += '\n';
            }
            QFile file(folder_.filePath("carrier.csv"));
            if (!file.open(QIODevice::WriteOnly) || file.write(text) < 0) {
                qFatal("no file");
            }
            file.close();
            return look(file.fileName());
        };
        const LogLook own = log("t,Xc,Yc,Xd,Yd,Pc (cyc),Pd (cyc)", [](int k) {
            return std::array{53.0 * k, 53.0 * k + 0.2};
        });
        QVERIFY(own.choice.phasors.frame == PhasorFrame::pll && !own.needs_f_ref);
        const LogLook common =
            log("t,Xc,Yc,Xd,Yd,P (rad)", [](int k) { return std::array{333.0 * k}; });
        QVERIFY(common.choice.phasors.frame == PhasorFrame::common && !common.needs_f_ref);
        const LogLook deviations =
            log("t,Xc,Yc,Xd,Yd,F (Hz)", [](int k) { return std::array{0.3 * std::sin(0.3 * k)}; });
        QVERIFY(deviations.choice.phasors.frame == PhasorFrame::common && deviations.needs_f_ref);
    }

    void logs_without_a_phase() {
        QCOMPARE(look(table("p.csv", "t,E,R,S,Q\n", 5)).choice.names, std::string("E,R,S,Q"));
        const LogLook waves = look(table("w.csv", "t,a,b,theta_deg\n", 4));
        QCOMPARE(waves.choice.names, std::string("a,b,theta"));
        QVERIFY(!waves.needs_angle_unit);
        QVERIFY(look(table("u.csv", "t,a,b,theta\n", 4)).needs_angle_unit);
        QVERIFY(!look(table("r.csv", "t_s,a_A,a_B,two_theta_A_rad\n", 4)).needs_angle_unit);
        const LogLook untimed = look(table("n.csv", "N,E,R,S,Q\n", 5));
        QVERIFY(untimed.choice.given() && !untimed.problem);
    }

    void a_demodulator_of_labone_has_its_own_file() {
        const LogLook seen =
            look(table("dev1_demods_0_sample_00000.csv",
                       "timestamp;x;y;freq;phase;dio;trigger;auxin0;auxin1;chunk\n", 10, {}, ";"));
        QVERIFY(seen.one_channel);
        QVERIFY(seen.choice.phasors.frame == PhasorFrame::fixed);
        QVERIFY(!seen.needs_f_ref);
        QCOMPARE(seen.choice.phasors.y_sign, 1);
        QCOMPARE(seen.choice.phasors.peak_per_unit, std::numbers::sqrt2);
        LogChoice told;
        told.phasors = {PhasorFrame::fixed, 0, -1, 1, {}};
        const LogLook again = look(folder_.filePath("dev1_demods_0_sample_00000.csv"), told);
        QVERIFY(again.choice == told);
    }

    void unknown_columns_are_asked_for() {
        const LogLook unknown = look(table("x.csv", "time,first,second,third,fourth\n", 5));
        QVERIFY(!unknown.choice.given() && !unknown.problem);
        const LogLook nameless = look(table("y.csv", "", 5));
        QVERIFY(!nameless.choice.given() && !nameless.problem);
        LogChoice told;
        told.phasors.frame = PhasorFrame::fixed;
        const LogLook missing = look(folder_.filePath("x.csv"), told);
        QVERIFY(missing.problem && missing.problem->code == ErrorCode::column_missing);
        told.names = "Xc=first,Yc=second,Xd=third,Yd=5";
        QVERIFY(!look(folder_.filePath("x.csv"), told).problem);
        told.names.clear();
        QVERIFY(!look(folder_.filePath("y.csv"), told).problem);  // in the order of the roles
        told.phasors.frame = PhasorFrame::common;
        told.names = "Xc=first,Yc=second,Xd=third,Yd=5";
        QVERIFY(look(folder_.filePath("x.csv"), told).problem);  // no oscillator
        LogChoice powers;
        powers.names = "E=first,R=second,S=third,Q=fourth";
        QVERIFY(!look(folder_.filePath("x.csv"), powers).problem);
    }

    void what_is_no_table_is_no_log() {
        QFile file(folder_.filePath("a.wav"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray("RIFF\x24\0\0\0WAVEfmt \x10\0\0\0\x01\0\x02\0", 24));
        file.close();
        const LogLook seen = look(file.fileName());
        QVERIFY(seen.problem && seen.problem->code == ErrorCode::no_log);
        QVERIFY(!look_at_log("/nowhere/log.csv", {}, {}, JobControl()));
    }
};

VYBEG_TEST(TestLogLook)

}  // namespace test_log_look

#include "test_log_look.moc"
