// Undo and redo of everything that changes the session, with words.
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/session/session_keeper.h"
#include "ui/window/file_commands.h"

#include <QAction>
#include <QTest>

namespace test_undo {

using namespace vybeg;
using namespace vybeg::ui;

class TestUndo : public QObject, private WindowTest {
    Q_OBJECT

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

    bool idle(qsizetype analyses) {
        return QTest::qWaitFor(
            [&] {
                return !document().busy() && std::ssize(document().analyses()) == analyses &&
                       std::ranges::all_of(document().recordings(), [](const auto& entry) {
                           return entry.recording && entry.f0_hz;
                       });
            },
            20000);
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
        document().renameAnalysis(document().analyses().front().shown.id, "reference");
        QCOMPARE(undo().text().remove('&'), QStringLiteral("Undo: rename a, n = 60"));
        undo().trigger();
        QCOMPARE(undo().text().remove('&'), QStringLiteral("Undo: window"));
        QCOMPARE(redo().text().remove('&'), QStringLiteral("Redo: rename a, n = 60"));
        window_->setLanguage("ru");
        QTRY_VERIFY2(undo().text().contains(QStringLiteral("окно")), qPrintable(undo().text()));
    }

    void a_run_is_hidden_renamed_removed_and_comes_back_the_same() {
        open({"a.wav", "b.wav"});
        const ShownAnalysis first = document().analyses().front().shown;
        document().setAnalysisVisible(first.id, false);
        document().renameAnalysis(first.id, "x");
        document().removeAnalysis(first.id);
        QCOMPARE(document().analyses().size(), std::size_t(1));
        undo().trigger();
        QCOMPARE(document().analyses().size(), std::size_t(2));
        QCOMPARE(document().analyses().front().shown.name, QStringLiteral("x"));
        QCOMPARE(document().analyses().front().shown.analysis, first.analysis);
        undo().trigger();
        QCOMPARE(document().analyses().front().shown.name, first.name);
        QVERIFY(!document().analyses().front().shown.visible);
        undo().trigger();
        QVERIFY(document().analyses().front().shown.visible);
        QVERIFY(!undo().isEnabled());
        for (int step = 0; step < 3; ++step) {
            redo().trigger();
        }
        QCOMPARE(document().analyses().size(), std::size_t(1));
        QVERIFY(!redo().isEnabled());
    }

    void sets_come_back_with_recordings_model_and_name() {
        open({"a.wav", "b.wav"});
        sets().add(ids());
        const auto set = sets().current()->id;
        sets().rename(set, "gyro 17");
        sets().setModel(set, FitOptions::Model::free);
        sets().removeFrom(set, {ids()[0]});
        sets().removeFrom(set, {ids()[0]});  // no change, no step
        sets().remove(set);
        QVERIFY(sets().all().empty());
        undo().trigger();
        QCOMPARE(sets().current()->name, QStringLiteral("gyro 17"));
        QCOMPARE(sets().current()->recordings, std::vector<RecordingId>{ids()[1]});
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
        QCOMPARE(sets().current()->recordings, std::vector<RecordingId>{ids()[1]});
    }

    // An identification is no step, and its result stays with the recordings that it is of.
    void undo_keeps_what_was_found_meanwhile() {
        open({"a.wav"});
        sets().add(ids());
        const auto set = sets().current()->id;
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
        const std::vector<RecordingId> before = ids();
        sets().add({before[0], before[1]});
        const ShownAnalysis shown = document().analyses()[1].shown;
        document().renameAnalysis(shown.id, "middle");
        document().closeRecording(before[1]);
        QCOMPARE(sets().current()->recordings, std::vector<RecordingId>{before[0]});
        QVERIFY(idle(2));
        QVERIFY2(undo().text().endsWith("close b.wav"), qPrintable(undo().text()));
        undo().trigger();
        QVERIFY(idle(3));
        QCOMPARE(ids(), before);
        QCOMPARE(sets().current()->recordings.size(), std::size_t(2));
        const ShownAnalysis& back = document().analyses()[1].shown;
        QCOMPARE(back.name, QStringLiteral("middle"));
        QCOMPARE(back.color, shown.color);
        QCOMPARE(back.recording, QStringLiteral("b.wav"));
        const auto values = [](const ShownAnalysis& of) {
            const auto span = of.analysis->track.values(SlowVariable::a_A);
            return std::vector<double>(span.begin(), span.end());
        };
        QCOMPARE(values(back), values(shown));
        redo().trigger();
        QVERIFY(idle(2));
        QCOMPARE(ids(), (std::vector<RecordingId>{before[0], before[2]}));
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
        QVERIFY(savedTo(*window_, path));
        window_ = shownWindow();
        window_->files().open({path});
        QVERIFY(QTest::qWaitFor([&] { return sets().all().size() == 1; }));
        QVERIFY(idle(1));
        QVERIFY(!undo().isEnabled());
    }
};

VYBEG_TEST(TestUndo)

}  // namespace test_undo

#include "test_undo.moc"
