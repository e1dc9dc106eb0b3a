// Logs on the page of the tracks: what they hold of the slow variables is drawn, whatever they are.
#include "core/analysis/analyse_logs.h"
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/ledger.h"
#include "ui/plots/track_view.h"
#include "ui/settings/settings_panel.h"
#include "ui/window/page_stack.h"

#include <QLabel>
#include <QTabBar>
#include <QtTest>

#include <cmath>
#include <numbers>

namespace test_log_tracks {

using namespace vybeg;
using namespace vybeg::ui;

class TestLogTracks : public QObject, private WindowTest {
    Q_OBJECT

    TrackView& tracks() { return the<TrackView>(); }
    const std::vector<ShownAnalysis>& drawn() { return tracks().analyses(); }
    const Track& track(std::size_t log = 0) { return drawn().at(log).analysis->track; }
    double value(SlowVariable variable, std::size_t row) { return track().values(variable)[row]; }
    QString named() { return the<QLabel>("tracks_of_logs").text(); }
    void showTracks() { the<QTabBar>("pages").setCurrentIndex(0); }

    void open(const QString& path, const LogChoice& choice) {
        MeasurementSet set;
        set.recordings.push_back({QFileInfo(path).fileName().toStdString(), path.toStdU16String()});
        set.settings.logs = choice;
        document().sets().openLogs(set);
    }

    // Rows of 20 s: a wave of tau 50 s whose angle turns by 0.025 rad/s.
    QString powers(const QString& name) const {
        QByteArray text = "t,E,R,S,Q\n";
        for (int k = 0; k < 400; ++k) {
            const double t = 0.05 * k;
            const double e = std::exp(-2 * t / 50);
            for (const double each :
                 {t, e, e * std::cos(0.1 * t), e * std::sin(0.1 * t), 1e-9 * std::sin(37 * t)}) {
                text += QByteArray::number(each, 'g', 17) + ',';
            }
            text.back() = '\n';
        }
        return home_.file(name, text);
    }

    // A wave that turns by 5 degrees a second, in an angle that comes back at 180.
    QString wholeAngle(const QString& name) const {
        QByteArray text = "t_s,theta_deg\n";
        for (int k = 0; k < 300; ++k) {
            text += QByteArray::number(k) + ',' +
                    QByteArray::number(std::fmod(5.0 * k + 0.01 * std::sin(k), 180), 'g', 17) +
                    '\n';
        }
        return home_.file(name, text);
    }

private slots:
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    void phasors_are_drawn_as_the_core_has_them() {
        const auto made = vybeg::test::run_cli(
            {"simulate", "-o", "one.npy", "--seconds", "10", "--tau", "40", "--f0", "5300.1",
             "--noise", "1e-3", "--split", "0.05", "--lock-in", "4,30,200"},
            home_.path({}));
        QCOMPARE(made.status, 0);
        LogChoice choice;
        choice.phasors = {PhasorFrame::fixed, 0, 1, 1, {4, 30}};
        const QString path = home_.path("one.phasors.csv");
        open(path, choice);
        QTRY_COMPARE_WITH_TIMEOUT(drawn().size(), std::size_t(1), 20000);
        const auto expected = analyse_log(path.toStdU16String(), {}, choice, {}, JobControl());
        QVERIFY(expected);
        QCOMPARE(track().rows(), expected->track.rows());
        for (const SlowVariable variable :
             {SlowVariable::a_A, SlowVariable::two_theta_A, SlowVariable::f}) {
            QCOMPARE(value(variable, 100), expected->track.values(variable)[100]);
        }
        showTracks();
        QVERIFY(tracks().isVisible());
        QVERIFY(!the<WelcomePage>().isVisible());
        QVERIFY(named().contains("one.phasors.csv"));
        QVERIFY(!the<Ledger>().isVisible());  // of recordings
        QVERIFY(the<SettingsPanel>().isVisible());
        VYBEG_CLOSE(tracks().fullTimeRange().span(), 10, 0.3);
        QVERIFY(exportPlotsTo(*window_, home_.path("log.svg")));
        // The calibration of the panel holds for the track, too.
        const double before = value(SlowVariable::two_theta_A, 100);
        Settings settings = document().settings();
        settings.calibration.angle_zero_deg = 10;
        document().setSettings(settings);
        QTRY_VERIFY_WITH_TIMEOUT(value(SlowVariable::two_theta_A, 100) != before, 20000);
        VYBEG_CLOSE(before - value(SlowVariable::two_theta_A, 100), std::numbers::pi / 9, 1e-9);
        while (document().undoStack().canUndo()) {
            document().undoStack().undo();
        }
        QTRY_VERIFY(drawn().empty());
        QVERIFY(!tracks().isVisible() && named().isEmpty());
        QVERIFY(the<WelcomePage>().isVisible());
    }

    // Without a phase there are amplitudes and the angle.
    void powers_are_drawn_as_the_wave_they_are_of() {
        LogChoice choice;
        choice.names = "E,R,S,Q";
        open(powers("powers.csv"), choice);
        QTRY_COMPARE_WITH_TIMEOUT(drawn().size(), std::size_t(1), 20000);
        for (const std::size_t row : {0, 150, 399}) {
            const double t = track().time_s()[row];
            VYBEG_CLOSE(value(SlowVariable::a_A, row), std::exp(-t / 50), 1e-6);
            VYBEG_CLOSE(value(SlowVariable::two_theta_A, row), 0.05 * t, 1e-6);
            QVERIFY(std::isnan(value(SlowVariable::f, row)));
        }
        showTracks();
        QVERIFY(tracks().isVisible());
    }

    void a_whole_angle_log_shows_its_angle() {
        document().drift().open({wholeAngle("turn.csv")});
        QTRY_COMPARE_WITH_TIMEOUT(drawn().size(), std::size_t(1), 20000);
        QCOMPARE(track().rows(), std::size_t(300));
        for (const std::size_t row : {0, 40, 299}) {
            const double theta_deg = 5.0 * double(row) + 0.01 * std::sin(double(row));
            VYBEG_CLOSE(value(SlowVariable::two_theta_A, row),
                        2 * theta_deg * std::numbers::pi / 180, 1e-9);
            QVERIFY(std::isnan(value(SlowVariable::a_A, row)));
        }
        showTracks();
        QVERIFY(tracks().isVisible() && named().contains("turn.csv"));
        QVERIFY(!the<SettingsPanel>().isVisible());
        document().undoStack().undo();
        QTRY_VERIFY(the<WelcomePage>().isVisible());
    }

    // A log that cannot be read has no track, and does not take that of the other.
    void of_several_logs_those_that_can_be_read_are_drawn() {
        document().drift().open({home_.file("words.csv", "these are words\n"),
                                 wholeAngle("first.csv"), wholeAngle("second.csv")});
        QTRY_COMPARE_WITH_TIMEOUT(drawn().size(), std::size_t(2), 20000);
        QVERIFY(drawn()[0].color != drawn()[1].color);
        QVERIFY(named().contains("first.csv") && named().contains("second.csv"));
        QVERIFY(!named().contains("words.csv"));
    }

    // Beside recordings they stand behind their analyses.
    void logs_and_recordings_share_the_page() {
        document().open({home_.recording("beside.wav", 20)});
        QVERIFY(idle(1));
        LogChoice choice;
        choice.names = "E,R,S,Q";
        open(powers("beside.csv"), choice);
        QTRY_COMPARE_WITH_TIMEOUT(drawn().size(), std::size_t(2), 20000);
        QCOMPARE(drawn().front().recording, QString("beside.wav"));
        QVERIFY(drawn().front().color != drawn().back().color);
        showTracks();
        QVERIFY(the<Ledger>().isVisible());
        QVERIFY(named().contains("beside.csv") && !named().contains("beside.wav"));
    }
};

VYBEG_TEST(TestLogTracks)

}  // namespace test_log_tracks

#include "test_log_tracks.moc"
