// Logs in place of recordings in the window: what the dialog asks for, the set that they become,
// its undo, session, report and database.
#include "core/batch/identify_set.h"
#include "core/output/identify_json.h"
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/history/history_database.h"
#include "ui/import/log_dialog.h"
#include "ui/panels/message_bar.h"
#include "ui/report/report_content.h"
#include "ui/report/report_document.h"
#include "ui/resonator/resonator_page.h"
#include "ui/resonator/set_panel.h"
#include "ui/session/session_keeper.h"
#include "ui/settings/settings_panel.h"
#include "ui/widgets/number_field.h"
#include "ui/window/file_commands.h"
#include "ui/window/page_stack.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QTabBar>
#include <QTableWidget>
#include <QTest>

namespace test_log_dialog {

using namespace vybeg;
using namespace vybeg::ui;

namespace {

// The log of a lock-in of order 4 and 30 Hz, 200 rows a second: tau 40 s, split 0.05 Hz.
void makePhasors(const QString& folder, const QString& name, double two_theta) {
    const auto made =
        vybeg::test::run_cli({"simulate", "-o", name + ".npy", "--seconds", "10", "--tau", "40",
                              "--f0", "5300.1", "--noise", "1e-3", "--split", "0.05",
                              "--two-theta-A", QString::number(two_theta), "--lock-in", "4,30,200"},
                             folder);
    if (made.status != 0) {
        qFatal("%s", made.err.constData());
    }
}

}  // namespace

class TestLogDialog : public QObject, private WindowTest {
    Q_OBJECT

    SetStore& sets() { return document().sets(); }
    LogDialog* dialog() { return window_->findChild<LogDialog*>(); }

    template <class Widget>
    Widget& the(const char* name = "") {
        return childOf<Widget>(*dialog(), QLatin1String(name));
    }
    QString lacking() { return the<QLabel>("lacking").text(); }
    QPushButton& openButton() { return *the<QDialogButtonBox>().button(QDialogButtonBox::Open); }
    bool asksFor(const char* field) { return the<QWidget>(field).isVisible(); }

    QString phasors(const QString& name, double two_theta = 0.3) {
        makePhasors(home_.path({}), name, two_theta);
        return home_.path(name + ".phasors.csv");
    }

    // Waits until the dialog has looked at the file.
    void opened() {
        QTRY_VERIFY(dialog());
        QTRY_VERIFY(the<QTableWidget>().rowCount() > 0);
    }
    void tellPhasors() {
        the<QComboBox>("y_sign").setCurrentIndex(1);
        the<QComboBox>("amplitude").setCurrentIndex(1);
        the<QComboBox>("order").setCurrentIndex(4);
        QTest::keyClicks(&the<NumberField>("bandwidth"), "30");
    }
    void acceptAndWait() {
        QTRY_VERIFY2(openButton().isEnabled(), qPrintable(lacking()));
        QTest::mouseClick(&openButton(), Qt::LeftButton);
        QVERIFY(sets().current());
        waitForOutcome();
    }
    void waitForOutcome() {
        QVERIFY(QTest::qWaitFor(
            [&] { return sets().current() && sets().outcome(*sets().current()) != nullptr; },
            60000));
    }
    const SetResult& outcome() { return *sets().outcome(*sets().current()); }
    QString state() { return childOf<QLabel>(*window_, "state").text(); }

    QByteArray one_channel_ = "t,X,Y\n";

private slots:
    void initTestCase() {
        for (int k = 0; k < 200; ++k) {
            one_channel_ += QByteArray::number(0.01 * k) + ",1,0.5\n";
        }
    }
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    // From the file to the split: the file, two answers that no data give, the filter, Open.
    void a_log_becomes_a_set_that_is_identified() {
        const QString log = phasors("one");
        window_->files().openLogs({log});
        opened();
        QTRY_COMPARE(the<QComboBox>("kind").currentText(), QString("phasors, one frequency"));
        QVERIFY2(lacking().contains("sign of Y"), qPrintable(lacking()));
        QVERIFY(!openButton().isEnabled());
        for (const char* known : {"f_ref", "columns", "rate", "channel_d_file", "angle_unit"}) {
            QVERIFY2(!asksFor(known), known);
        }
        the<QComboBox>("y_sign").setCurrentIndex(1);
        QVERIFY2(lacking().contains("rms"), qPrintable(lacking()));
        the<QComboBox>("amplitude").setCurrentIndex(1);
        QVERIFY(openButton().isEnabled());
        the<QComboBox>("order").setCurrentIndex(4);
        QVERIFY2(lacking().contains("bandwidth"), qPrintable(lacking()));
        QTest::keyClicks(&the<NumberField>("bandwidth"), "30");
        acceptAndWait();
        QTRY_VERIFY(!dialog());
        const RecordingSet& set = *sets().current();
        QVERIFY(isOfLogs(set));
        QVERIFY(set.recordings.empty() && document().recordings().empty());
        QCOMPARE(setName(document(), set), QString("one.phasors"));
        QVERIFY(childOf<ResonatorPage>(*window_).isVisible());
        QCOMPARE(childOf<SetTree>(*window_, "sets").members().front()->text(0),
                 QString("one.phasors.csv"));
        // As core has it.
        MeasurementSet same;
        same.recordings.push_back({"one.phasors.csv", log.toStdU16String()});
        same.settings.logs.phasors = {PhasorFrame::fixed, 0, 1, 1, {4, 30}};
        const auto open = open_set(same, {}, {});
        QVERIFY(open);
        const auto expected = identify_set(*open, {}, {}, JobControl());
        QVERIFY(expected);
        QCOMPARE(outcome().identification.runs.front().wave.tau_s.value,
                 expected->identification.runs.front().wave.tau_s.value);
        QVERIFY(!sets().outOfDate(set, outcome()));
        QVERIFY(!outcome().set.recordings.front().sha256.empty());
        // A recording that is added makes a set of its own.
        document().open({home_.recording("beside.wav")});
        QTRY_VERIFY_WITH_TIMEOUT(
            document().currentRecording() && document().currentRecording()->recording, 20000);
        sets().addToCurrent({document().currentRecording()->id});
        QCOMPARE(sets().all().size(), std::size_t(2));
        QVERIFY(!isOfLogs(*sets().current()));
    }

    // Opened or dropped as recordings, they are logs of one set.
    void a_file_that_is_a_log_opens_the_dialog() {
        const QStringList logs{phasors("b"), phasors("a", 1.1)};
        window_->files().open(logs);
        opened();
        QTRY_COMPARE(dialog()->files().size(), 2);
        QVERIFY(dialog()->files().first().endsWith("a.phasors.csv"));
        QTRY_VERIFY(document().recordings().empty());
        QTRY_COMPARE(the<QComboBox>("kind").currentIndex(), 3);
        tellPhasors();
        acceptAndWait();
        QCOMPARE(outcome().identification.runs.size(), std::size_t(2));
        VYBEG_CLOSE_RATIO(outcome().identification.fit.resonator.tau_s.value, 40, 0.02);
        VYBEG_CLOSE_RATIO(outcome().identification.fit.resonator.split_hz.value, 0.05, 0.1);
        QVERIFY(childOf<MessageBar>(*window_).texts().filter("is a log").isEmpty());
    }

    // The dialog came empty for the second log, and made a set of its own of it.
    void a_further_log_comes_into_the_set_that_is_open() {
        window_->files().openLogs({phasors("first")});
        opened();
        QTRY_COMPARE(the<QComboBox>("kind").currentIndex(), 3);
        tellPhasors();
        acceptAndWait();
        const SetId id = sets().current()->id;
        auto& tree = childOf<SetTree>(*window_, "sets");
        QVERIFY(dropFiles(*tree.viewport(), {phasors("second", 1.1)}));
        opened();
        QCOMPARE(dialog()->files().size(), 2);
        // Nothing is asked again.
        QTRY_VERIFY2(openButton().isEnabled(), qPrintable(lacking()));
        QVERIFY(dialog()->set().settings.logs == outcome().set.settings.logs);
        QTest::mouseClick(&openButton(), Qt::LeftButton);
        QVERIFY(QTest::qWaitFor([&] { return outcome().identification.runs.size() == 2; }, 60000));
        QCOMPARE(sets().current()->id, id);
        QCOMPARE(sets().all().size(), std::size_t(1));
        QCOMPARE(outcome().set.recordings[0].name(), std::string("first.phasors.csv"));
        QVERIFY(!sets().outOfDate(*sets().current(), outcome()));
        QCOMPARE(setName(document(), *sets().current()), QString("Logs 1"));
        document().undoStack().undo();
        QCOMPARE(sets().measured(*sets().current()).recordings.size(), std::size_t(1));
        QCOMPARE(outcome().identification.runs.size(), std::size_t(1));
        document().undoStack().redo();
        tree.setCurrentItem(tree.members().front());
        QTest::keyClick(&tree, Qt::Key_Delete);
        QCOMPARE(tree.members().size(), std::size_t(1));
        QCOMPARE(tree.members().front()->text(0), QString("second.phasors.csv"));
        QVERIFY(sets().outOfDate(*sets().current(), outcome()));
        // Those of the result, whatever the set has by now.
        QCOMPARE(sets().underPresentConditions(*sets().current(), outcome()).set.recordings.size(),
                 outcome().set.recordings.size());
        tree.setCurrentItem(tree.members().front());
        QTest::keyClick(&tree, Qt::Key_Delete);
        QVERIFY(tree.members().empty());
        QVERIFY(!sets().canIdentify());
        document().undoStack().undo();
        // The same logs told otherwise.
        childOf<QPushButton>(*window_, "editLogs").click();
        opened();
        QTRY_VERIFY2(openButton().isEnabled(), qPrintable(lacking()));
        the<QComboBox>("y_sign").setCurrentIndex(2);
        QTRY_VERIFY2(openButton().isEnabled(), qPrintable(lacking()));
        QTest::mouseClick(&openButton(), Qt::LeftButton);
        QCOMPARE(sets().measured(*sets().current()).settings.logs.phasors.y_sign, -1);
    }

    // They were those at the time of opening for good.
    void calibration_and_tolerances_of_the_panel_take_effect() {
        window_->files().openLogs({phasors("calibrated")});
        opened();
        QTRY_COMPARE(the<QComboBox>("kind").currentIndex(), 3);
        tellPhasors();
        acceptAndWait();
        Settings settings = document().settings();
        settings.calibration.kappa = 1.02;
        settings.calibration.offset_c = 0.5;  // of samples
        document().setSettings(settings);
        Tolerance tolerance;
        tolerance[kappa_error] = 0.03;
        document().setTolerance(tolerance);
        QVERIFY(sets().outOfDate(*sets().current(), outcome()));
        QVERIFY2(state().contains("Out of date"), qPrintable(state()));
        const MeasurementSet measured = sets().measured(*sets().current());
        QCOMPARE(measured.settings.signal.calibration.kappa, 1.02);
        QCOMPARE(measured.settings.signal.calibration.offset_c, 0.0);
        QCOMPARE(measured.settings.tolerance[kappa_error], std::optional(0.03));
        sets().identify();
        QVERIFY(QTest::qWaitFor([&] { return !sets().outOfDate(*sets().current(), outcome()); },
                                60000));
        QCOMPARE(outcome().identification.settings.signal.calibration.kappa, 1.02);
        QVERIFY(childOf<QLabel>(*window_, "listed").text().contains("panel Analysis"));
        // Also of a session.
        const QString path = home_.path("calibrated.vybeg");
        QVERIFY(savedTo(*window_, path));
        window_ = shownWindow();
        window_->files().open({path});
        waitForOutcome();
        settings.calibration.kappa = 1.03;
        document().setSettings(settings);
        QCOMPARE(sets().measured(*sets().current()).settings.signal.calibration.kappa, 1.03);
        // Those of a list stay its own.
        window_->files().open({home_.file("fixed.csv",
                                          "file,phasors,y-sign,amplitude,lock-in\n"
                                          "calibrated.phasors.csv,fixed,+,peak,\"4,30\"\n")});
        const double listed = sets().measured(*sets().current()).settings.signal.calibration.kappa;
        settings.calibration.kappa = 1.04;
        document().setSettings(settings);
        QCOMPARE(sets().measured(*sets().current()).settings.signal.calibration.kappa, listed);
    }

    // The welcome asked for a recording, without a way to the page of the logs' resonator.
    void without_a_recording_its_pages_say_where_the_results_are() {
        window_->files().openLogs({phasors("alone")});
        opened();
        QTRY_COMPARE(the<QComboBox>("kind").currentIndex(), 3);
        tellPhasors();
        acceptAndWait();
        auto& tabs = childOf<QTabBar>(*window_, "pages");
        auto& opened_text = childOf<QLabel>(*window_, "opened");
        const int samples = static_cast<int>(Page::samples);
        tabs.setCurrentIndex(samples);
        QVERIFY(opened_text.isVisible() && tabs.isVisible());
        QVERIFY2(opened_text.text().contains("alone.phasors"), qPrintable(opened_text.text()));
        // Calibration and tolerances hold for the logs.
        QVERIFY(childOf<SettingsPanel>(*window_).isVisible());
        emit opened_text.linkActivated("resonator");
        QVERIFY(childOf<ResonatorPage>(*window_).isVisible());
        window_->files().savePassportTo(home_.path("alone.phasors.csv"));
        QTRY_VERIFY(
            !childOf<MessageBar>(*window_).texts().filter("one of the open files").isEmpty());
        document().undoStack().undo();
        tabs.setCurrentIndex(samples);
        QVERIFY(!opened_text.isVisible() && !tabs.isVisible());
        const QString turning = home_.file("turn.csv", "t,theta_deg\n0,0\n1,1\n2,2\n");
        document().drift().open({turning});
        tabs.setCurrentIndex(samples);
        QVERIFY(opened_text.isVisible() && tabs.isVisible());
        QVERIFY2(opened_text.text().contains("turn.csv"), qPrintable(opened_text.text()));
        QVERIFY(!childOf<SettingsPanel>(*window_).isVisible());
    }

    void undo_and_session_keep_the_logs() {
        window_->files().openLogs({phasors("kept"), phasors("other", 1.1)});
        opened();
        QTRY_COMPARE(the<QComboBox>("kind").currentIndex(), 3);
        tellPhasors();
        QTest::keyClicks(&the<NumberField>("from"), "0.5");
        acceptAndWait();
        const double tau_s = outcome().identification.fit.resonator.tau_s.value;
        const MeasurementSet before = sets().measured(*sets().current());
        QCOMPARE(before.settings.signal.from_s, std::optional(0.5));
        window_->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
        QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(sets().all().empty());
        QTest::keyClick(window_.get(), Qt::Key_Y, Qt::ControlModifier);
        QCOMPARE(sets().all().size(), std::size_t(1));
        childOf<QPushButton>(*window_, "identify").click();
        waitForOutcome();
        QVERIFY(window_->action(Command::save_session)->isEnabled());
        QVERIFY(window_->session().isModified());
        const QString path = home_.path("logs.vybeg");
        QVERIFY(savedTo(*window_, path));
        window_ = shownWindow();
        window_->files().open({path});
        waitForOutcome();  // as its result was up to date
        const MeasurementSet after = sets().measured(*sets().current());
        QVERIFY(after.settings == before.settings);
        QCOMPARE(after.recordings.size(), std::size_t(2));
        for (const std::size_t k : {0, 1}) {  // in their order
            QCOMPARE(after.recordings[k].path, before.recordings[k].path);
        }
        QCOMPARE(outcome().identification.fit.resonator.tau_s.value, tau_s);
        QVERIFY2(!state().contains("Without"), qPrintable(state()));
        QVERIFY(!window_->session().isModified());
    }

    void the_report_and_the_database_tell_what_was_told() {
        window_->files().openLogs({phasors("told")});
        opened();
        QTRY_COMPARE(the<QComboBox>("kind").currentIndex(), 3);
        tellPhasors();
        acceptAndWait();
        const auto subjects = reportSubjects(document());
        QCOMPARE(subjects.size(), std::size_t(1));
        QVERIFY(window_->action(Command::report)->isEnabled());
        const ReportContent content = reportContentOf(document(), subjects.front());
        QCOMPARE(content.recordings.size(), std::size_t(1));
        const QString html = reportTextOf(content, "test", QDate(2026, 1, 1)).html;
        QVERIFY(html.contains("told.phasors.csv"));
        QVERIFY2(html.contains("--phasors fixed --y-sign + --amplitude peak --lock-in 4,30"),
                 qPrintable(html));
        QVERIFY(!html.contains("not finished yet"));
        const auto stored = stored_result(outcome(), identify_json(outcome()));
        QVERIFY(stored);
        const auto settings = settingsOf(*stored);
        QVERIFY(settings);
        MeasurementSet again{stored->set, stored->recordings, *settings};
        QVERIFY(leaveOutMissing(again).isEmpty());
        QVERIFY(again.settings.logs == outcome().set.settings.logs);
        const double tau_s = outcome().identification.runs.front().wave.tau_s.value;
        sets().open({{}, {again}, {}});
        QCOMPARE(sets().all().size(), std::size_t(2));
        QVERIFY(document().recordings().empty());
        sets().identify();
        waitForOutcome();
        QCOMPARE(outcome().identification.runs.front().wave.tau_s.value, tau_s);
    }

    void a_track_has_nothing_to_be_asked() {
        home_.recording("tracked.wav", 4);
        const auto made = vybeg::test::run_cli(
            {"analyze", "tracked.wav", "-o", "tracked.csv", "--window", "200"}, home_.path({}));
        QCOMPARE(made.status, 0);
        window_->files().openLogs({home_.path("tracked.csv")});
        opened();
        QTRY_VERIFY2(openButton().isEnabled(), qPrintable(lacking()));
        QCOMPARE(the<QComboBox>("kind").currentIndex(), 2);
        QVERIFY(!asksFor("y_sign") && !asksFor("order"));
        QTest::keyClick(dialog(), Qt::Key_Return);
        QVERIFY(sets().current());
        QVERIFY(sets().measured(*sets().current()).settings.logs.without_phase());
    }

    // Each channel has its file, found by its name; columns of no known name are told.
    void what_the_file_does_not_tell_is_asked_for() {
        QByteArray c = "t,X,Y\n";
        QByteArray d = c;
        QByteArray unknown;
        QByteArray powers = "t,one,two,three,four\n";
        for (int k = 0; k < 200; ++k) {
            const QByteArray t = QByteArray::number(0.01 * k);
            c += t + ",1,0.5\n";
            d += t + ",0.25,0.125\n";
            powers += t + ",1,0.5,0.5,0.1\n";
        }
        const QString of_c = home_.file("run_C.csv", c);
        const QString of_d = home_.file("run_D.csv", d);
        window_->files().openLogs({of_c});
        opened();
        QTRY_VERIFY(asksFor("channel_d_file"));
        QCOMPARE(the<QLineEdit>("channel_d_file").text(), QString("run_D.csv"));
        QTRY_VERIFY(asksFor("f_ref"));
        the<QComboBox>("y_sign").setCurrentIndex(2);
        the<QComboBox>("amplitude").setCurrentIndex(2);
        QVERIFY2(lacking().contains("reference"), qPrintable(lacking()));
        QTest::keyClicks(&the<NumberField>("f_ref"), "5300,5");
        QVERIFY2(openButton().isEnabled(), qPrintable(lacking()));
        const MeasurementSet set = dialog()->set();
        QCOMPARE(set.recordings.size(), std::size_t(1));
        QVERIFY(QString::fromStdString(set.recordings[0].open.channel_d_file) == of_d);
        QVERIFY((set.settings.logs.phasors ==
                 PhasorChoice{PhasorFrame::fixed, 5300.5, -1, std::numbers::sqrt2, {}}));
        // Both files at once are the two channels.
        dialog()->add({of_d});
        QTRY_COMPARE(dialog()->set().recordings.size(), std::size_t(1));
        dialog()->reject();
        QTRY_VERIFY(!dialog());

        window_->files().openLogs({home_.file("unknown.csv", powers)});
        opened();
        QTRY_VERIFY2(lacking().contains("choose what they are"), qPrintable(lacking()));
        the<QComboBox>("kind").setCurrentIndex(1);
        QTRY_VERIFY(asksFor("columns"));
        QTRY_VERIFY2(lacking().contains("no column"), qPrintable(lacking()));
        the<QLineEdit>("columns").setFocus();
        QTest::keyClicks(&the<QLineEdit>("columns"), "E=one,R=two,S=three,Q=5");
        QTRY_VERIFY2(openButton().isEnabled(), qPrintable(lacking()));
        QCOMPARE(dialog()->set().settings.logs.names, std::string("E=one,R=two,S=three,Q=5"));
    }

    // A list's sets of logs stand beside its sets of recordings.
    void a_list_of_logs_and_recordings() {
        phasors("listed");
        home_.recording("listed.wav");
        window_->files().open({home_.file(
            "list.csv",
            "file,set,phasors,y-sign,amplitude,lock-in,gyro\n"
            "listed.phasors.csv,logs,fixed,+,peak,\"4,30\",G7\nlisted.wav,samples,,,,,\n")});
        QCOMPARE(sets().all().size(), std::size_t(2));
        QTRY_COMPARE(document().recordings().size(), std::size_t(1));
        QVERIFY(isOfLogs(sets().all()[0]) && !isOfLogs(sets().all()[1]));
        QVERIFY(childOf<QLabel>(*window_, "listed").text().contains("phasors fixed"));
        QVERIFY(childOf<SetTree>(*window_, "sets").members().front()->toolTip(0).contains("G7"));
        window_->action(Command::identify)->trigger();
        waitForOutcome();
        QCOMPARE(outcome().set.recordings.front().conditions.gyro, std::string("G7"));
        VYBEG_CLOSE_RATIO(outcome().identification.runs.front().wave.tau_s.value, 40, 0.2);
    }

    // Exchanged in silence were the channels of files whose names do not say which one they are.
    void of_two_files_the_channel_is_told_or_asked_for() {
        const QString east = home_.file("east.csv", one_channel_);
        const QString north = home_.file("north.csv", one_channel_ + "2,0.25,0.125\n");
        window_->files().openLogs({east, north});
        opened();
        QTRY_VERIFY(asksFor("channel_d_file"));
        QCOMPARE(the<QLineEdit>("channel_d_file").text(), QString());
        the<QComboBox>("y_sign").setCurrentIndex(1);
        the<QComboBox>("amplitude").setCurrentIndex(1);
        QTest::keyClicks(&the<NumberField>("f_ref"), "5300,5");
        QVERIFY2(lacking().contains("choose the one of channel D"), qPrintable(lacking()));
        QTest::keyClicks(&the<QLineEdit>("channel_d_file"), "east.csv");
        QVERIFY2(openButton().isEnabled(), qPrintable(lacking()));
        QCOMPARE(the<QListWidget>("logFiles").item(0)->text(),
                 QString("east.csv — channel D of north.csv"));
        QCOMPARE(the<QListWidget>("logFiles").item(1)->text(), QString("north.csv — channel C"));
        const MeasurementSet set = dialog()->set();
        QCOMPARE(set.recordings.size(), std::size_t(1));
        QCOMPARE(set.recordings[0].open.channel_d_file, east.toStdString());
        QCOMPARE(set.name, std::string("north"));
        the<QLineEdit>("channel_d_file").clear();
        QTest::keyClicks(&the<QLineEdit>("channel_d_file"), "west.csv");
        QVERIFY(!openButton().isEnabled());
        auto& list = the<QListWidget>("logFiles");
        list.setCurrentRow(1);
        QTest::keyClick(&list, Qt::Key_Delete);
        QTRY_VERIFY2(lacking().contains("west.csv is no file"), qPrintable(lacking()));
        QVERIFY(!openButton().isEnabled());
    }

    // The first file alone was looked at: one that is none kept the others from being opened.
    void a_file_that_is_no_such_log_is_named_and_taken_out() {
        const QString words = home_.file("a words.csv", "these are words\n");
        window_->files().openLogs({phasors("sound"), words});
        QTRY_VERIFY(dialog());
        QTRY_COMPARE(the<QComboBox>("kind").currentIndex(), 3);
        tellPhasors();
        QVERIFY2(lacking().contains("a words.csv") && lacking().contains("Delete"),
                 qPrintable(lacking()));
        QVERIFY(!openButton().isEnabled());
        auto& list = the<QListWidget>("logFiles");
        QVERIFY(list.item(0)->text().contains("cannot be opened"));
        list.setCurrentRow(0);
        QTest::keyClick(&list, Qt::Key_Delete);
        QCOMPARE(dialog()->files().size(), 1);
        // What was chosen stays.
        QTRY_VERIFY2(openButton().isEnabled(), qPrintable(lacking()));
        QCOMPARE(the<QComboBox>("kind").currentIndex(), 3);
        QCOMPARE(the<QComboBox>("y_sign").currentIndex(), 1);
        list.setCurrentRow(0);
        QTest::keyClick(&list, Qt::Key_Delete);
        QVERIFY2(lacking().contains("no log"), qPrintable(lacking()));
        QVERIFY(!openButton().isEnabled());
    }

    // An empty set stayed where the dialog was left, and the logs made one more.
    void a_log_dropped_on_the_list_of_a_set_leaves_the_set() {
        document().openIntoSet({phasors("dropped")});
        opened();
        QVERIFY(document().recordings().empty());
        QVERIFY(sets().all().empty());
        QCOMPARE(document().undoStack().count(), 0);
        dialog()->reject();
        document().openIntoSet({home_.recording("sound.wav"), home_.path("absent.wav")});
        QTRY_COMPARE(sets().all().size(), std::size_t(1));
        QCOMPARE(sets().all()[0].recordings.size(), std::size_t(1));
    }

    void both_files_of_a_log_move_with_their_session() {
        QVERIFY(QDir().mkpath(home_.path("pair")));
        MeasurementSet set;
        RecordingRef log{"run_C.csv", home_.file("pair/run_C.csv", one_channel_).toStdU16String()};
        log.open.channel_d_file = home_.file("pair/run_D.csv", one_channel_).toStdString();
        set.recordings = {log};
        set.settings.logs.phasors = {PhasorFrame::fixed, 5300.5, 1, 1, {}};
        sets().openLogs(set);
        QVERIFY(savedTo(*window_, home_.path("pair/one.vybeg")));
        QVERIFY(QDir().rename(home_.path("pair"), home_.path("elsewhere")));
        window_ = shownWindow();
        window_->files().open({home_.path("elsewhere/one.vybeg")});
        QTRY_VERIFY(sets().current());
        const RecordingRef moved = sets().measured(*sets().current()).recordings.at(0);
        QCOMPARE(QString::fromStdU16String(moved.path.u16string()),
                 home_.path("elsewhere/run_C.csv"));
        QCOMPARE(QString::fromStdString(moved.open.channel_d_file),
                 home_.path("elsewhere/run_D.csv"));
    }

    void a_log_that_cannot_be_read_is_told() {
        window_->files().openLogs({home_.file("words.csv", "these are words\n")});
        QTRY_VERIFY(dialog());
        QTRY_VERIFY(!lacking().isEmpty() && !lacking().contains("Looking"));
        QVERIFY(!openButton().isEnabled());
        dialog()->reject();
        QTRY_VERIFY(!dialog());
        const QString log = phasors("gone");
        window_->files().openLogs({log});
        opened();
        QTRY_COMPARE(the<QComboBox>("kind").currentIndex(), 3);
        tellPhasors();
        QVERIFY(QFile::remove(log));
        QTest::mouseClick(&openButton(), Qt::LeftButton);
        QTRY_VERIFY(!childOf<MessageBar>(*window_).texts().filter("gone.phasors.csv").isEmpty());
    }
};

VYBEG_TEST(TestLogDialog)

}  // namespace test_log_dialog

#include "test_log_dialog.moc"
