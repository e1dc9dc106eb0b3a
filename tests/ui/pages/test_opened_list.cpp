// A measurement list opened in the window: its sets, their settings and conditions.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/resonator_runs.h"
#include "ui/panels/message_bar.h"
#include "ui/report/report_content.h"
#include "ui/report/report_document.h"
#include "ui/resonator/resonator_page.h"
#include "ui/resonator/resonator_text.h"
#include "ui/resonator/set_panel.h"
#include "ui/session/session_keeper.h"
#include "ui/window/export_dialogs.h"
#include "ui/window/file_commands.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QtTest>

namespace test_opened_list {

using namespace vybeg;
using namespace vybeg::ui;

class TestOpenedList : public QObject, private WindowTest {
    Q_OBJECT

    SetStore& sets() { return document().sets(); }

    // Two sets of the same resonator, one of them from 1 s on with its channels named.
    QString list(const char* name) {
        resonatorRuns(home_, "runs");
        return home_.file(name,
                          "file;set;channels;from;gyro;date;bias_v;temperature_c;model;Bench\n"
                          "runs-0.wav;whole;;;G7;2026-03-31;100;22,5;structured;B1\n"
                          "runs-45.wav;whole;;;G7;;100;;;B1\n"
                          "runs-0.wav;late;1,2;1;G8;;;;structured;\n");
    }

    void waitUntilOpen(std::size_t recordings) {
        QTRY_COMPARE_WITH_TIMEOUT(document().recordings().size(), recordings, 20000);
        QVERIFY(QTest::qWaitFor([&] { return sets().canIdentify() && !document().busy(); }, 30000));
    }

    QString messages() { return childOf<MessageBar>(*window_).texts().join('\n'); }

private slots:
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    // Drop it, see the sets with their conditions, identify, take the sets back.
    void a_dropped_list_becomes_sets() {
        QVERIFY(dropFiles(*window_, {list("dropped.csv")}));
        QCOMPARE(sets().all().size(), std::size_t(2));
        // The same file under other options is another recording; here the options are the same.
        waitUntilOpen(2);
        const RecordingSet& whole = sets().all()[0];
        QCOMPARE(whole.name, QString("whole"));
        QCOMPARE(whole.recordings.size(), std::size_t(2));
        QCOMPARE(whole.model, FitOptions::Model::structured);
        QCOMPARE(sets().current()->id, whole.id);
        QVERIFY(childOf<ResonatorPage>(*window_).isVisible());
        QVERIFY(childOf<QLabel>(*window_, "listed").isVisible());
        const QString tip = childOf<SetTree>(*window_, "sets").members().front()->toolTip(0);
        for (const char* told : {"G7", "2026-03-31", "100 V", "22.5 °C", "Bench: B1"}) {
            QVERIFY2(tip.contains(told), qPrintable(tip));
        }
        QVERIFY(!sets().measured(whole).settings.signal.from_s);
        const RecordingSet& late = sets().all()[1];
        QCOMPARE(sets().measured(late).settings.signal.from_s, std::optional(1.0));
        // The panel's settings are none of theirs.
        Settings settings = document().settings();
        settings.from_s = 0.25;
        document().setSettings(settings);
        QVERIFY(!sets().measured(whole).settings.signal.from_s);
        QTest::mouseClick(&childOf<QPushButton>(*window_, "identify"), Qt::LeftButton);
        QVERIFY(QTest::qWaitFor([&] { return sets().outcome(sets().all()[0]) != nullptr; }, 60000));
        const auto found = sets().outcome(sets().all()[0]);
        QCOMPARE(found->identification.runs.size(), std::size_t(2));
        VYBEG_CLOSE_RATIO(found->identification.fit.resonator.tau_s.value, 40, 0.01);
        QVERIFY(!sets().outOfDate(sets().all()[0], *found));
        QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);  // the setting
        QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);  // the list
        QVERIFY(sets().all().empty());
        QCOMPARE(document().recordings().size(), std::size_t(2));
    }

    void a_wrong_field_is_named_by_row_and_column() {
        const QString path =
            home_.file("wrong.csv", "file,date\na.wav,2026-03-31\nb.wav,31.02.2026\n");
        window_->files().open({path});
        QVERIFY(sets().all().empty() && document().recordings().empty());
        const QString said = messages();
        for (const char* told : {"wrong.csv", "3", "date", "31.02.2026"}) {
            QVERIFY2(said.contains(told), qPrintable(said));
        }
    }

    void a_missing_recording_leaves_the_others() {
        home_.recording("there.wav");
        window_->files().open({home_.file("half.csv", "file,set\nthere.wav,A\nnone.wav,A\n")});
        QTRY_VERIFY_WITH_TIMEOUT(messages().contains("none.wav"), 20000);
        waitUntilOpen(1);
        QCOMPARE(sets().current()->recordings.size(), std::size_t(1));
        const auto state = [this] { return childOf<QLabel>(*window_, "state").text(); };
        QVERIFY2(state().contains("Without these recordings") && state().contains("none.wav"),
                 qPrintable(state()));
        // A session keeps that the set is a part of its list.
        const QString path = home_.path("half.vybeg");
        QVERIFY(savedTo(*window_, path));
        window_ = shownWindow();
        window_->files().open({path});
        waitUntilOpen(1);
        QTRY_VERIFY2(state().contains("none.wav"), qPrintable(state()));
    }

    // Saved while it was missing, a recording that is there again has its row of the list.
    void a_recording_that_comes_back_has_its_row() {
        window_->files().open({list("back.csv")});
        waitUntilOpen(2);
        const QString path = home_.path("back.vybeg");
        QVERIFY(savedTo(*window_, path));
        const QString recording = home_.path("runs-45.wav");
        const QString aside = home_.path("aside");  // without its ending it is not looked at
        QVERIFY(QFile::rename(recording, aside));
        for (const std::size_t there : {1, 2}) {
            window_ = shownWindow();
            window_->files().open({path});
            waitUntilOpen(there);
            const bool back = there == 2;
            QTRY_COMPARE(childOf<QLabel>(*window_, "state").text().contains("runs-45.wav"), !back);
            QVERIFY(QTest::qWaitFor([&] { return !window_->session().isOpening(); }));
            QVERIFY(savedTo(*window_, path));
            if (!back) {
                QVERIFY(QFile::rename(aside, recording));
            }
        }
        const MeasurementSet whole = sets().measured(sets().all()[0]);
        QCOMPARE(whole.recordings.size(), std::size_t(2));
        QCOMPARE(whole.recordings[1].conditions.gyro, std::string("G7"));
    }

    void a_recording_named_twice_in_a_set_is_told() {
        home_.recording("twice.wav");
        window_->files().open(
            {home_.file("twice.csv", "file,set\ntwice.wav,A\ntwice.wav,A\ntwice.wav,B\n")});
        waitUntilOpen(1);
        QVERIFY2(messages().contains("more than once: twice.wav") && messages().contains("set A"),
                 qPrintable(messages()));
        QVERIFY2(!messages().contains("set B"), qPrintable(messages()));
        QCOMPARE(sets().all()[0].recordings.size(), std::size_t(1));
    }

    // A report has what the list tells of its recordings; of all sets, each has its own.
    void a_report_has_the_conditions_and_settings_of_the_list() {
        window_->files().open({list("reported.csv")});
        waitUntilOpen(2);
        document().dossier().setGyro({"session", {}, "Ivanova", "bench 2"});
        QTRY_COMPARE_WITH_TIMEOUT(document().analyses().size(), std::size_t(2), 30000);
        for (const RecordingSet& set : sets().all()) {
            sets().identifySet(set.id);
        }
        for (const std::size_t set : {0, 1}) {
            QVERIFY(QTest::qWaitFor([&] { return sets().outcome(sets().all()[set]) != nullptr; },
                                    60000));
        }
        QTRY_VERIFY(!reportSubjects(document()).empty());
        ReportDialog dialog(document(), true);
        QCOMPARE(dialog.contents().front().title.gyro, QString("G7"));
        QCOMPARE(dialog.contents().front().title.engineer, QString("Ivanova"));
        auto& subject = childOf<QComboBox>(dialog);
        subject.setCurrentIndex(subject.count() - 1);  // all sets
        QVERIFY(dialog.subject().all_sets);
        const std::vector<ReportContent> contents = dialog.contents();
        QCOMPARE(contents.size(), std::size_t(2));
        QCOMPARE(contents[0].title.gyro, QString("G7"));
        QCOMPARE(contents[0].title.date, QString("2026-03-31"));
        QCOMPARE(contents[1].title.gyro, QString("G8"));
        QCOMPARE(contents[1].title.comment, QString("bench 2"));
        const QStringList conditions = conditionsText(contents[0].recordings[0].file);
        QVERIFY(conditions.contains("bias voltage: 100 V"));
        QVERIFY(conditions.contains("Bench: B1"));
        QVERIFY2(chapterOf(contents[1]).html.contains("--from 1 --model structured") ||
                     chapterOf(contents[1]).html.contains("--model structured --from 1"),
                 qPrintable(optionsText(contents[1].outcome->identification.settings)));
        QVERIFY(optionsText(contents[0].outcome->identification.settings)
                    .contains("--model structured"));
    }

    // Recordings as CSV stay recordings, beside a list in one drop of files.
    void a_table_of_numbers_is_no_list() {
        home_.recording("one.wav");
        const QString samples = home_.recording("samples.csv");
        const QString path = home_.file("mixed.CSV", "\"file\"\none.wav\n");
        window_->files().open({samples, path});
        QTRY_COMPARE_WITH_TIMEOUT(document().recordings().size(), std::size_t(2), 20000);
        QCOMPARE(sets().all().size(), std::size_t(1));
        QCOMPARE(sets().all()[0].name, QString("one.wav"));
    }

    void conditions_that_differ_are_no_set_of_one_resonator() {
        resonatorRuns(home_, "other");
        window_->files().open(
            {home_.file("differ.csv", "file,set,gyro\nother-0.wav,A,G1\nother-45.wav,A,G2\n")});
        waitUntilOpen(2);
        sets().identify();
        const QString said = messages();
        QVERIFY2(said.contains("G1") && said.contains("G2"), qPrintable(said));
        QVERIFY(!document().busy());
    }

    void a_session_keeps_what_the_list_said() {
        window_->files().open({list("kept.csv")});
        waitUntilOpen(2);
        const auto before = sets().measured(sets().all()[1]);
        const QString path = home_.path("kept.vybeg");
        QVERIFY(savedTo(*window_, path));
        window_ = shownWindow();
        window_->files().open({path});
        QTRY_COMPARE(sets().all().size(), std::size_t(2));
        waitUntilOpen(2);
        const auto after = sets().measured(sets().all()[1]);
        QCOMPARE(after.name, before.name);
        QVERIFY(after.settings == before.settings);
        QCOMPARE(after.recordings.size(), std::size_t(1));
        QCOMPARE(after.recordings[0].conditions.gyro, std::string("G8"));
        QCOMPARE(after.recordings[0].path, before.recordings[0].path);
        const auto whole = sets().measured(sets().all()[0]);
        QCOMPARE(whole.recordings[0].conditions.temperature_c, std::optional(22.5));
        QCOMPARE(whole.recordings[0].others[0].second, std::string("B1"));
    }
};

VYBEG_TEST(TestOpenedList, threads)

}  // namespace test_opened_list

#include "test_opened_list.moc"
