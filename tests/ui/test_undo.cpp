// Undo and redo of everything that changes the session, with words.
#include "tests/ui/gui_test.h"
#include "ui/session/session_keeper.h"
#include "ui/window/file_commands.h"

#include <QAction>
#include <QTest>

using namespace vybeg;
using namespace vybeg::ui;

class TestUndo : public QObject {
    Q_OBJECT

    GuiTestHome home_;
    std::unique_ptr<MainWindow> window_;

    Document& document() { return window_->document(); }
    SetStore& sets() { return document().sets(); }
    QAction& undo() { return *window_->action(Command::undo); }
    QAction& redo() { return *window_->action(Command::redo); }

    void open(const QStringList& names) {
        QStringList paths;
        for (const QString& name : names) {
            paths << home_.recording(name);
        }
        document().open(paths);
        QVERIFY(idle(names.size()));
    }

    bool idle(qsizetype runs) {
        return QTest::qWaitFor(
            [&] {
                return !document().busy() && std::ssize(document().runs()) == runs &&
                       std::ranges::all_of(document().recordings(), [](const auto& entry) {
                           return entry.recording && entry.f0_hz;
                       });
            },
            20000);
    }

    std::vector<int> ids() {
        std::vector<int> found;
        for (const RecordingEntry& entry : document().recordings()) {
            found.push_back(entry.id);
        }
        return found;
    }

private slots:
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    void opening_is_no_step() {
        open({"a.wav"});
        QVERIFY(!undo().isEnabled() && !redo().isEnabled());
    }

    void the_menu_says_what_is_undone() {
        open({"a.wav"});
        Settings settings = document().settings();
        settings.window = 44;
        document().setSettings(settings);
        QCOMPARE(undo().text().remove('&'), QStringLiteral("Undo: window"));
        document().renameRun(document().runs().front().run.id, "reference");
        QCOMPARE(undo().text().remove('&'), QStringLiteral("Undo: rename a, n = 60"));
        undo().trigger();
        QCOMPARE(undo().text().remove('&'), QStringLiteral("Undo: window"));
        QCOMPARE(redo().text().remove('&'), QStringLiteral("Redo: rename a, n = 60"));
        window_->setLanguage("ru");
        QTRY_VERIFY2(undo().text().contains(QStringLiteral("окно")), qPrintable(undo().text()));
    }

    void a_run_is_hidden_renamed_removed_and_comes_back_the_same() {
        open({"a.wav", "b.wav"});
        const Run first = document().runs().front().run;
        document().setRunVisible(first.id, false);
        document().renameRun(first.id, "x");
        document().removeRun(first.id);
        QCOMPARE(document().runs().size(), std::size_t(1));
        undo().trigger();
        QCOMPARE(document().runs().size(), std::size_t(2));
        QCOMPARE(document().runs().front().run.name, QStringLiteral("x"));
        QCOMPARE(document().runs().front().run.analysis, first.analysis);
        undo().trigger();
        QCOMPARE(document().runs().front().run.name, first.name);
        QVERIFY(!document().runs().front().run.visible);
        undo().trigger();
        QVERIFY(document().runs().front().run.visible);
        QVERIFY(!undo().isEnabled());
        for (int step = 0; step < 3; ++step) {
            redo().trigger();
        }
        QCOMPARE(document().runs().size(), std::size_t(1));
        QVERIFY(!redo().isEnabled());
    }

    void sets_come_back_with_recordings_model_and_name() {
        open({"a.wav", "b.wav"});
        sets().add(ids());
        const int set = sets().current()->id;
        sets().rename(set, "gyro 17");
        sets().setModel(set, FitOptions::Model::free);
        sets().removeFrom(set, {ids()[0]});
        sets().removeFrom(set, {ids()[0]});  // no change, no step
        sets().remove(set);
        QVERIFY(sets().all().empty());
        undo().trigger();
        QCOMPARE(sets().current()->name, QStringLiteral("gyro 17"));
        QCOMPARE(sets().current()->recordings, std::vector<int>{ids()[1]});
        undo().trigger();
        QCOMPARE(sets().current()->recordings, ids());
        QVERIFY(sets().current()->model == FitOptions::Model::free);
        undo().trigger();
        undo().trigger();
        QCOMPARE(sets().current()->name, QString());
        undo().trigger();
        QVERIFY(sets().all().empty() && !undo().isEnabled());
        for (int step = 0; step < 4; ++step) {
            redo().trigger();
        }
        QCOMPARE(sets().current()->recordings, std::vector<int>{ids()[1]});
    }

    // An identification is no step, and its result stays with the recordings that it is of.
    void undo_keeps_what_was_found_meanwhile() {
        open({"a.wav"});
        sets().add(ids());
        const int set = sets().current()->id;
        sets().rename(set, "x");
        sets().identify();
        QVERIFY(QTest::qWaitFor([&] { return !document().busy(); }, 60000));
        const auto outcome = sets().outcome(*sets().current());
        QVERIFY(outcome);
        undo().trigger();
        QCOMPARE(sets().outcome(*sets().current()), outcome);
    }

    void a_closed_recording_is_read_again_with_its_runs_and_sets() {
        open({"a.wav", "b.wav", "c.wav"});
        const std::vector<int> before = ids();
        sets().add({before[0], before[1]});
        const Run run = document().runs()[1].run;
        document().renameRun(run.id, "middle");
        document().closeRecording(before[1]);
        QCOMPARE(sets().current()->recordings, std::vector<int>{before[0]});
        QVERIFY(idle(2));
        QVERIFY2(undo().text().endsWith("close b.wav"), qPrintable(undo().text()));
        undo().trigger();
        QVERIFY(idle(3));
        QCOMPARE(ids(), before);
        QCOMPARE(sets().current()->recordings.size(), std::size_t(2));
        const Run& back = document().runs()[1].run;
        QCOMPARE(back.name, QStringLiteral("middle"));
        QCOMPARE(back.color, run.color);
        QCOMPARE(back.recording, QStringLiteral("b.wav"));
        const auto values = [](const Run& of) {
            const auto span = of.analysis->track.values(SlowVariable::a_A);
            return std::vector<double>(span.begin(), span.end());
        };
        QCOMPARE(values(back), values(run));
        redo().trigger();
        QVERIFY(idle(2));
        QCOMPARE(ids(), (std::vector<int>{before[0], before[2]}));
        // Steps of what is closed do no harm.
        undo().trigger();
        undo().trigger();
        undo().trigger();
        QVERIFY(idle(3));
        QVERIFY(sets().all().empty());
    }

    void a_session_opens_without_steps() {
        open({"a.wav"});
        sets().add(ids());
        const QString path = home_.path("s.vybeg");
        QVERIFY(window_->session().save(path));
        window_ = shownWindow();
        window_->files().open({path});
        QVERIFY(QTest::qWaitFor([&] { return sets().all().size() == 1; }));
        QVERIFY(idle(1));
        QVERIFY(!undo().isEnabled());
    }
};

QTEST_MAIN(TestUndo)
#include "test_undo.moc"
