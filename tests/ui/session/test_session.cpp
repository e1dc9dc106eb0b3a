// Sessions: reopened they show the same picture and numbers; nothing of them is lost.
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/ledger.h"
#include "ui/panels/message_bar.h"
#include "ui/plots/track_view.h"
#include "ui/session/session.h"
#include "ui/session/session_keeper.h"
#include "ui/signals/signals_page.h"
#include "ui/window/file_commands.h"
#include "ui/window/main_window.h"
#include "ui/window/window_menus.h"

#include <QFile>
#include <QFileDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>

namespace test_session {

using namespace vybeg;
using namespace vybeg::ui;

class TestSession : public QObject, private WindowTest {
    Q_OBJECT

    SessionKeeper& session() { return window_->session(); }

    void wait(std::size_t runs) {
        QTRY_VERIFY_WITH_TIMEOUT(!document().busy() && document().analyses().size() == runs, 20000);
        for (const RecordingEntry& entry : document().recordings()) {
            const auto id = entry.id;
            QTRY_VERIFY(!document().recording(id)->sha256.isEmpty());
        }
    }

    void openSession(const QString& path, std::size_t runs) {
        window_->files().open({path});
        wait(runs);
        QTRY_COMPARE(session().path(), path);
    }

    // As soon as five in a row are the same: marks that come and go move the plots once more.
    QImage picture() {
        QImage last;
        int same = 0;
        const bool settled = QTest::qWaitFor(
            [&] {
                QCoreApplication::sendPostedEvents();  // queued marks, then the layouts they ask
                                                       // for
                const QImage now = the<TrackView>().grab().toImage();
                same = now == last ? same + 1 : 0;
                last = now;
                return same >= 5;
            },
            20000);
        return settled ? last : QImage();
    }

    QString messages() { return the<MessageBar>().texts().join('\n'); }

    static QJsonObject jsonOf(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                              : QJsonObject();
    }

    void answer(QMessageBox::StandardButton button) {
        auto* question = window_->findChild<QMessageBox*>();
        QVERIFY(question);
        QTest::mouseClick(question->button(button), Qt::LeftButton);
    }

    // Two recordings with four runs, a set, cursors and a zoom.
    void arrange(const QString& folder) {
        QVERIFY(QDir().mkpath(home_.path(folder)));
        document().open({home_.recording(folder + "/a.wav")});
        wait(1);
        document().open({home_.recording(folder + "/b.wav", 3)});
        wait(2);
        Settings settings = document().settings();
        settings.algorithm = Algorithm::conjugate_gradient;
        settings.window = 200;
        settings.from_s = 0.25;
        settings.calibration.kappa = 1.01;
        document().setSettings(settings);
        document().analyse();
        wait(3);
        settings.filter = Band{900, 1100};
        document().setSettings(settings);
        document().analyse();
        wait(4);
        document().renameAnalysis(document().analyses()[1].shown.id, "second");
        document().setAnalysisVisible(document().analyses()[2].shown.id, false);
        const auto set =
            document().sets().add({document().recordings()[1].id, document().recordings()[0].id});
        document().sets().rename(set, "gyro 17");
        document().sets().setModel(set, FitOptions::Model::free);
        DisplayUnits units;
        units.angle = AngleUnit::degrees;
        units.wave_angle = WaveAngle::from_zero;
        units.frequency = FrequencyUnit::deviation_hertz;
        units.sigma_bands = false;
        units.log_a_A = true;
        TrackView& tracks = the<TrackView>();
        emit the<WindowMenus>().unitsChosen(units);
        tracks.setShownVariables({SlowVariable::a_A, SlowVariable::f, SlowVariable::alpha});
        tracks.setTimeRange({0.4, 1.7});
        tracks.setZoom({tracks.timeRange(), {{SlowVariable::f, AxisRange{-0.5, 0.75}}}});
        tracks.setFocus();
        tracks.setTracker(0.5);
        QTest::keyClick(&tracks, Qt::Key_1);
        tracks.setTracker(1.25);
        QTest::keyClick(&tracks, Qt::Key_2);
        tracks.setTracker(std::nullopt);
        the<Ledger>().setTrendKind(TrendKind::beat);
        document().dossier().setGyro({"HRG-17", "30 mm", "Orlova", "after annealing"});
        document().dossier().setLimits({{"split_hz", std::nullopt, 0.001}, {"q", 1e7, 2e7}});
    }

private slots:
    void init() { window_ = shownWindow(); }
    void cleanup() { session().end(); }

    // Of sessions of before, which had more kinds.
    void an_unknown_trend_is_a_line() {
        QCOMPARE(viewFromJson(QJsonObject{{"trend", "cubic"}}).trend, TrendKind::line);
        QCOMPARE(viewFromJson(QJsonObject{{"trend", "beat"}}).trend, TrendKind::beat);
        QVERIFY(viewFromJson({}).units.wave_angle == WaveAngle::doubled);
    }

    void a_session_reopened_shows_the_same() {
        arrange("same");
        const QString path = home_.path("same/one.vybeg");
        QVERIFY(session().isModified());
        QVERIFY(savedTo(*window_, path));
        QVERIFY(!session().isModified());
        const QImage before = picture();
        QVERIFY(!before.isNull());
        const QString table = the<Ledger>().tableText();
        const Settings settings = document().settings();
        std::vector<ShownAnalysis> runs;
        for (const AnalysisEntry& entry : document().analyses()) {
            runs.push_back(entry.shown);
        }
        session().end();

        window_ = shownWindow();
        openSession(path, 4);
        QTRY_COMPARE(the<TrackView>().cursor(Cursor::b), std::optional(1.25));
        QCOMPARE(document().settings(), settings);
        for (std::size_t k = 0; k < runs.size(); ++k) {
            const AnalysisEntry& entry = document().analyses()[k];
            QCOMPARE(entry.shown.name, runs[k].name);
            QCOMPARE(entry.shown.color, runs[k].color);
            QCOMPARE(entry.shown.visible, runs[k].visible);
            const auto same = [](double x, double y) {  // the filter's transient is NaN
                return x == y || (std::isnan(x) && std::isnan(y));
            };
            QVERIFY(std::ranges::equal(entry.shown.analysis->track.values(SlowVariable::a_A),
                                       runs[k].analysis->track.values(SlowVariable::a_A), same));
        }
        const RecordingSet* set = document().sets().current();
        QVERIFY(set);
        QCOMPARE(set->name, "gyro 17");
        QVERIFY(set->model == FitOptions::Model::free);
        QCOMPARE(set->recordings, (std::vector<RecordingId>{document().recordings()[1].id,
                                                            document().recordings()[0].id}));
        QCOMPARE(the<Ledger>().tableText(), table);
        QCOMPARE(picture(), before);
        QVERIFY(!session().isModified());
        QVERIFY(window_->windowTitle().startsWith("one.vybeg — HRG-17 — "));
        QCOMPARE(the<Ledger>().trendKind(), TrendKind::beat);
        QVERIFY(the<TrackView>().units().wave_angle == WaveAngle::from_zero);
        const Dossier& dossier = document().dossier().dossier();
        QCOMPARE(dossier.gyro, (GyroData{"HRG-17", "30 mm", "Orlova", "after annealing"}));
        QCOMPARE(dossier.limits,
                 (std::vector<ParameterLimit>{{"split_hz", std::nullopt, 0.001}, {"q", 1e7, 2e7}}));
    }

    void the_page_comes_back() {
        document().open({home_.recording("page.wav")});
        wait(1);
        window_->action(Command::page_signals)->trigger();
        const QString path = home_.path("page.vybeg");
        QVERIFY(savedTo(*window_, path));
        session().end();
        window_ = shownWindow();
        openSession(path, 1);
        QTRY_VERIFY(the<SignalsPage>().isVisibleTo(window_.get()));
    }

    void what_a_later_version_knows_of_the_gyro_is_kept() {
        const QDir folder(home_.path("."));
        QJsonObject json = sessionToJson({}, folder);
        json["gyro"] = QJsonObject{{"serial", "7"}, {"laboratory", "B"}};
        const auto read = sessionFromJson(json, folder);
        QVERIFY(read);
        QCOMPARE(read->dossier.gyro.serial, "7");
        const QJsonObject again = sessionToJson(*read, folder)["gyro"].toObject();
        QCOMPARE(again["laboratory"].toString(), "B");
        QCOMPARE(again["serial"].toString(), "7");
    }

    void a_live_session_reopened_is_live() {
        document().setLive(true);
        document().open({home_.recording("live.wav")});
        wait(1);
        Settings settings = document().settings();
        settings.window = 123;
        document().setSettings(settings);
        wait(1);
        const QString path = home_.path("live.vybeg");
        QVERIFY(savedTo(*window_, path));
        session().end();
        window_ = shownWindow();
        openSession(path, 1);
        QTRY_VERIFY(document().live());
        QVERIFY(document().analyses().front().live);
        QCOMPARE(document().analyses().front().shown.analysis->plan.length, 123);
        QVERIFY(!session().isModified());
    }

    // Every row of the table of settings, away from its default.
    void every_setting_comes_back() {
        Session stored;
        stored.settings.algorithm = Algorithm::demodulation;
        stored.settings.window = 77;
        stored.settings.hop = 11;
        stored.settings.f0_hz = 5300.123456789012;
        stored.settings.from_s = 0.1;
        stored.settings.to_s = 27.3;
        stored.settings.calibration.kappa = 1.0000001;
        stored.settings.calibration.delay_d_s = 1e-7;
        stored.settings.repair_lost = true;
        stored.tolerance[kappa_error] = 0.02;
        stored.tolerance[skew_error] = 0.3;
        const QDir folder(home_.path("."));
        const auto read = sessionFromJson(sessionToJson(stored, folder), folder);
        QVERIFY(read);
        QCOMPARE(read->settings, stored.settings);
        QCOMPARE(read->tolerance, stored.tolerance);
        // Those that have their defaults are left out.
        QCOMPARE(sessionToJson({}, folder)["settings"].toObject(), QJsonObject());
        QCOMPARE(sessionToJson(stored, folder)["settings"].toObject()["hop"].toString(), "11");
    }

    void what_a_later_version_wrote_is_kept() {
        arrange("later");
        const QString path = home_.path("later/one.vybeg");
        QVERIFY(savedTo(*window_, path));
        QJsonObject json = jsonOf(path);
        json["vybeg_session"] = 2;
        json["gyro"] = QJsonObject{{"serial", "17"}};
        home_.file("later/one.vybeg", QJsonDocument(json).toJson());
        openSession(path, 4);
        QVERIFY(messages().contains("later version"));
        QVERIFY(savedTo(*window_, path));
        QCOMPARE(jsonOf(path)["gyro"].toObject()["serial"].toString(), "17");
    }

    void a_session_moves_with_its_recordings() {
        arrange("from");
        QVERIFY(savedTo(*window_, home_.path("from/one.vybeg")));
        QVERIFY(QDir().rename(home_.path("from"), home_.path("to")));
        QVERIFY(QDir().mkpath(home_.path("to/raw")));
        QVERIFY(QFile::rename(home_.path("to/b.wav"), home_.path("to/raw/b.wav")));
        openSession(home_.path("to/one.vybeg"), 4);
        QCOMPARE(document().recordings().size(), std::size_t{2});
        QCOMPARE(document().recordings()[1].path, home_.path("to/raw/b.wav"));
        QCOMPARE(messages(), QString());
    }

    void a_recording_that_is_gone_is_asked_for_and_its_place_kept() {
        arrange("gone");
        const QString path = home_.path("gone/one.vybeg");
        QVERIFY(savedTo(*window_, path));
        QVERIFY(QFile::rename(home_.path("gone/b.wav"), home_.path("elsewhere.wav")));
        window_->files().open({path});
        QTRY_VERIFY(!document().busy() && document().analyses().size() == 1);
        QVERIFY(messages().contains("b.wav is not there"));
        // Saved without it, the session still has its runs and its place in the set.
        QTRY_COMPARE(the<TrackView>().cursor(Cursor::b), std::optional(1.25));
        QVERIFY(savedTo(*window_, path));
        QCOMPARE(jsonOf(path)["recordings"].toArray().size(), 2);
        QCOMPARE(jsonOf(path)["recordings"].toArray()[1].toObject()["runs"].toArray().size(), 3);
        QCOMPARE(jsonOf(path)["sets"].toArray()[0].toObject()["recordings"].toArray().size(), 2);
        // Found again.
        QTest::mouseClick(childOf<MessageBar>(*window_).findChild<QPushButton*>(), Qt::LeftButton);
        auto* dialog = window_->findChild<QFileDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        emit dialog->fileSelected(home_.path("elsewhere.wav"));
        dialog->close();
        wait(4);
        QCOMPARE(document().sets().current()->recordings.size(), std::size_t{2});
        QCOMPARE(document().analyses().back().shown.name, document().analyses()[3].shown.name);
        QCOMPARE(messages(), QString());
    }

    void another_file_in_the_place_of_a_recording_is_told() {
        arrange("other");
        const QString path = home_.path("other/one.vybeg");
        QVERIFY(savedTo(*window_, path));
        home_.recording("other/b.wav", 2.5);
        openSession(path, 4);
        QTRY_VERIFY(messages().contains("SHA-256 differs"));
    }

    void what_is_no_session_changes_nothing() {
        document().open({home_.recording("stays.wav")});
        wait(1);
        for (const auto& [content, words] :
             {std::pair<QByteArray, const char*>{"{", "not a session that can be read"},
              {"[]", "not a session"},
              {"{\"a\": 1}", "not a session"},
              {"{\"vybeg_session\": 1, \"settings\": {\"window\": \"2\"}}", "window"}}) {
            the<MessageBar>().clear();
            window_->files().open({home_.file("bad.vybeg", content)});
            QVERIFY2(messages().contains(words), qPrintable(messages()));
            QCOMPARE(document().recordings().size(), std::size_t{1});
        }
        the<MessageBar>().clear();
        window_->files().open({home_.path("none.vybeg")});
        QVERIFY(messages().contains("none.vybeg"));
        QCOMPARE(document().analyses().size(), std::size_t{1});
    }

    void closing_asks_where_changes_would_be_lost() {
        document().open({home_.recording("asks.wav")});
        wait(1);
        QVERIFY(!session().isModified());  // there is nothing that opening again does not give
        Settings settings = document().settings();
        settings.window = 99;
        document().setSettings(settings);
        QVERIFY(session().isModified());
        QVERIFY(!window_->close());
        answer(QMessageBox::Cancel);
        QVERIFY(window_->isVisible());
        QVERIFY(!window_->close());
        answer(QMessageBox::Save);
        auto* dialog = window_->findChild<QFileDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        const QString path = home_.path("asked.vybeg");
        emit dialog->fileSelected(path);
        QTRY_VERIFY(!window_->isVisible());
        QCOMPARE(jsonOf(path)["settings"].toObject()["window"].toString(), "99");
    }

    void discarded_changes_are_not_asked_for_twice() {
        document().open({home_.recording("discard.wav")});
        wait(1);
        document().sets().addToCurrent({document().recordings()[0].id});
        QVERIFY(!window_->close());
        answer(QMessageBox::Discard);
        QVERIFY(!window_->isVisible());
    }

    void saving_by_key_and_opening_by_drop() {
        arrange("keys");
        QTest::keyClick(window_.get(), Qt::Key_S, Qt::ControlModifier);
        auto* dialog = window_->findChild<QFileDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        const QString path = home_.path("keys/one.vybeg");
        emit dialog->fileSelected(path);
        dialog->close();
        QTRY_VERIFY(QFile::exists(path));
        session().end();
        window_ = shownWindow();
        QVERIFY(dropFiles(*window_, {path}));
        wait(4);
        QCOMPARE(session().path(), path);
    }

    void a_session_never_takes_the_place_of_a_recording() {
        const QString recording = home_.recording("kept.wav");
        document().open({recording});
        wait(1);
        window_->files().saveSession();
        auto* dialog = window_->findChild<QFileDialog*>();
        emit dialog->fileSelected(recording);
        dialog->close();
        QVERIFY(messages().contains("is one of the open files"));
        QVERIFY(session().path().isEmpty());
    }
};

VYBEG_TEST(TestSession, threads)

}  // namespace test_session

#include "test_session.moc"
