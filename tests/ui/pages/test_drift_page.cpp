// Page Drift: whole-angle logs opened, looked at, refused, removed, kept and reported, as a person
// does it.
#include "core/output/drift_json.h"
#include "tests/closeness.h"
#include "tests/core/drift/simulated_log.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/document/document.h"
#include "ui/drift/drift_page.h"
#include "ui/drift/drift_text.h"
#include "ui/panels/file_list.h"
#include "ui/panels/message_bar.h"
#include "ui/plots/plot_view.h"
#include "ui/report/report_content.h"
#include "ui/report/report_document.h"
#include "ui/report/report_parts.h"
#include "ui/session/session_keeper.h"
#include "ui/widgets/quantity_table.h"
#include "ui/window/file_commands.h"
#include "ui/words/program_name.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabBar>
#include <QtTest>

#include <numbers>

namespace test_drift_page {

using namespace vybeg;
using namespace vybeg::ui;
using vybeg::test::HeldLoop;

namespace {

HeldLoop loop(double turn, unsigned seed) {
    HeldLoop loop{.turn = turn,
                  .c2 = 2e-5,
                  .c4 = 3e-4,
                  .s4 = -2e-4,
                  .white = 1e-5,
                  .effort_noise = 1e-3,
                  .seed = seed};
    return loop;
}

// A log as a controller writes it.
QByteArray rowsOf(const HeldLoop& held, const QByteArray& head) {
    const WholeAngleLog log = test::simulated_log(held);
    QByteArray text = head + '\n';
    for (std::size_t k = 0; k < log.time_s.size(); ++k) {
        for (const double value : {log.time_s[k], log.theta[k], log.amplitude_effort[k]}) {
            text += QByteArray::number(value, 'g', 17) + ',';
        }
        text += QByteArray::number(log.quadrature_effort[k], 'g', 17) + '\n';
    }
    return text;
}

}  // namespace

class TestDriftPage : public QObject, private WindowTest {
    Q_OBJECT

    DriftStore& drift() { return document().drift(); }
    DriftPage& page() { return the<DriftPage>(); }

    QString text(const char* name) { return the<QLabel>(QLatin1String(name)).text(); }
    QString messages() { return the<MessageBar>().texts().join('\n'); }
    void click(const char* button) {
        QTest::mouseClick(&the<QPushButton>(QLatin1String(button)), Qt::LeftButton);
    }

    QString written(const QString& name, const HeldLoop& held,
                    const QByteArray& head = "t_s,theta_rad,amplitude,quadrature") const {
        return home_.file(name, rowsOf(held, head));
    }

    void wait() {
        QVERIFY(QTest::qWaitFor([&] { return !drift().computing(); }, 60000));
    }

    // By the menu and its dialog.
    void open(const QStringList& paths) {
        window_->action(Command::open_whole_angle)->trigger();
        auto* dialog = window_->findChild<QFileDialog*>("files");
        QVERIFY(dialog && dialog->isVisible());
        emit dialog->filesSelected(paths);
        dialog->close();
        QVERIFY(page().isVisible());
        wait();
    }

    // The drift by core alone.
    static WholeAngleDrift computed(const QStringList& paths, const DriftSettings& settings = {}) {
        std::vector<WholeAngleLog> logs;
        for (const QString& path : paths) {
            logs.push_back(*read_whole_angle_log(path.toStdString(), settings.open, settings.log,
                                                 JobControl()));
        }
        return *whole_angle_drift(logs, JobControl(), pick_offs(settings.tolerance));
    }

    void compareWith(const WholeAngleDrift& expected) {
        const auto outcome = drift().outcome();
        QVERIFY(outcome);
        for (std::size_t term = 0; term < expected.harmonics.size(); ++term) {
            QCOMPARE(outcome->drift.harmonics.at(term).value, expected.harmonics.at(term).value);
            QCOMPARE(outcome->drift.harmonics.at(term).sd, expected.harmonics.at(term).sd);
            QCOMPARE(outcome->drift.harmonics.at(term).u, expected.harmonics.at(term).u);
        }
        QCOMPARE(outcome->drift.resonator.tau_s.value, expected.resonator.tau_s.value);
        QCOMPARE(outcome->drift.left_out, expected.left_out);
    }

    // As its text; the page first.
    QString cell(const char* table, int row, int column) {
        return the<QuantityTable>(QLatin1String(table)).item(row, column)->text();
    }

    QString reportOf(std::size_t subject) {
        const auto subjects = reportSubjects(document());
        return reportTextOf(reportContentOf(document(), subjects.at(subject)), "Vybeg",
                            QDate(2026, 5, 4))
            .html;
    }

private slots:
    // So wide that numbers stand with ±.
    void init() {
        window_ = shownWindow();
        window_->resize(2400, 1000);
    }
    void cleanup() {
        window_->session().end();
        window_.reset();
    }

    // As a person drops them on the window, which takes them for recordings.
    void logs_opened_as_recordings_are_on_the_page() {
        const QStringList logs{written("dropped_1.csv", loop(0.05, 1)),
                               written("dropped_2.csv", loop(-0.05, 2))};
        window_->files().openTogether(logs);
        QTRY_COMPARE(drift().logs().size(), std::size_t(2));
        QTRY_VERIFY(page().isVisible());
        wait();
        QVERIFY(document().recordings().empty());
        QCOMPARE(messages(), QString());
        QVERIFY(drift().outcome());
        // One step, in the order chosen, whichever of them was read first.
        QCOMPARE(document().undoStack().count(), 1);
        QCOMPARE(drift().logs()[0].name(), std::string("dropped_1.csv"));
        document().undoStack().undo();
        QVERIFY(drift().logs().empty());
    }

    // Lost was what stood in a field when the window was closed; destroyed with it, it fell.
    void a_number_that_is_being_typed_counts_when_the_window_closes() {
        open({written("typed.csv", loop(0.05, 10))});
        window_->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
        auto& kappa = the<NumberField>("driftKappa");
        kappa.setFocus();
        QTest::keyClicks(&kappa, "0.0002");
        QVERIFY(!drift().settings().tolerance[kappa_error]);
        window_->close();
        QCOMPARE(drift().settings().tolerance[kappa_error], std::optional(0.0002));
        QTest::keyClicks(&kappa, "5");
        window_.reset();
        window_ = shownWindow();
    }

    // Ctrl+6 without anything open.
    void an_empty_page_says_what_to_open() {
        QTest::keyClick(window_.get(), Qt::Key_6, Qt::ControlModifier);
        QVERIFY(page().isVisible() && the<QTabBar>("pages").isVisible());
        QCOMPARE(the<QTabBar>("pages").tabText(5), QString("Drift"));
        QVERIFY2(text("driftHint").contains("Open whole-angle logs"),
                 qPrintable(text("driftHint")));
        QVERIFY(!the<XYPlotView>("driftPlot").isVisible());
        QVERIFY(page().figures().plots.isEmpty());
        QVERIFY(!the<QPushButton>("driftExport").isEnabled());
        QVERIFY(!window_->action(Command::report)->isEnabled());
        window_->setLanguage("ru");
        QTRY_COMPARE(the<QTabBar>("pages").tabText(5), QString("Дрейф"));
        QVERIFY2(text("driftHint").contains("журнал"), qPrintable(text("driftHint")));
        QTest::keyClick(window_.get(), Qt::Key_7, Qt::ControlModifier);
        QVERIFY(!page().isVisible());
    }

    void plot_and_tables_are_those_of_core() {
        const QStringList logs{written("a.csv", loop(0.05, 1)), written("b.csv", loop(-0.04, 2))};
        open(logs);
        const WholeAngleDrift expected = computed(logs);
        compareWith(expected);
        QVERIFY2(messages().isEmpty(), qPrintable(messages()));

        const DisplayUnits units{.angle = AngleUnit::degrees};
        auto& plot = the<XYPlotView>("driftPlot");
        QVERIFY(plot.isVisible());
        const XYSeries& means = plot.content().series.at(whole_angle_means);
        const XYSeries& curve = plot.content().series.at(1);
        QCOMPARE(means.y.size(), expected.bins.size());
        for (std::size_t k = 0; k < means.y.size(); ++k) {
            const LogBin& bin = expected.bins[k];
            VYBEG_CLOSE(means.x[k], bin.theta * 180 / std::numbers::pi, 1e-9);
            VYBEG_CLOSE_RATIO(means.y[k], degrees_per_hour(bin.rate), 1e-12);
            VYBEG_CLOSE_RATIO(means.sd[k], degrees_per_hour(bin.sd), 1e-12);
        }
        QCOMPARE(curve.x.front(), 0.0);
        VYBEG_CLOSE(curve.x.back(), 180, 1e-9);
        const double theta = curve.x[37] * std::numbers::pi / 180;
        VYBEG_CLOSE_RATIO(curve.y[37], degrees_per_hour(expected.rate(theta)), 1e-9);
        VYBEG_CLOSE_RATIO(curve.sd[37], degrees_per_hour(expected.sd_rate(theta)), 1e-9);
        QCOMPARE(plot.content().y_unit, QString("°/h"));

        // Turn and harmonics; of all logs and of each.
        auto& harmonics = the<QuantityTable>("driftHarmonics");
        QCOMPARE(harmonics.columnCount(), 4);
        for (int term = 0; term < log_terms; ++term) {
            const Estimate rate =
                degrees_per_hour(expected.harmonics.at(static_cast<std::size_t>(term)));
            // Each log has a turn of its own.
            QCOMPARE(cell("driftHarmonics", term, 1),
                     term == 0 ? QStringLiteral("—") : valueText(rate.value, rate.sd, rate.u));
        }
        QCOMPARE(cell("driftHarmonics", 3, 2),
                 valueText(degrees_per_hour(expected.logs[0].coefficients[3]),
                           degrees_per_hour(std::sqrt(expected.logs[0].covariance(3, 3)))));
        QVERIFY2(text("driftAgreement").contains("Turn: the logs differ"),
                 qPrintable(text("driftAgreement")));
        QVERIFY2(text("driftAgreement").contains("Harmonic 4: the logs agree"),
                 qPrintable(text("driftAgreement")));

        const auto resonator = heldRows(expected.resonator, units);
        QCOMPARE(resonator.size(), std::size_t{5});
        for (std::size_t k = 0; k < resonator.size(); ++k) {
            QCOMPARE(cell("driftResonator", static_cast<int>(k), 0), resonator[k].name);
            QCOMPARE(cell("driftResonator", static_cast<int>(k), 1), resonator[k].cells[0].text);
        }
        VYBEG_LESS(std::abs(expected.resonator.tau_s.value - 400) / expected.resonator.tau_s.sd, 5);
        QCOMPARE(page().figures().plots, QStringList{"Drift against the angle"});
        QVERIFY(window_->action(Command::export_plots)->isEnabled());
    }

    // A log without efforts has the reason in the place of tau.
    void what_the_logs_do_not_tell_has_its_reason() {
        open({written("alone.csv", loop(0.05, 3), "t_s,theta_rad,u,v")});
        QVERIFY(drift().outcome());
        QCOMPARE(the<QuantityTable>("driftHarmonics").columnCount(), 2);
        QVERIFY2(text("driftAgreement").contains("one log"), qPrintable(text("driftAgreement")));
        QVERIFY(cell("driftResonator", 0, 1).contains("±"));
        QVERIFY2(cell("driftResonator", 2, 1).contains("effort"),
                 qPrintable(cell("driftResonator", 2, 1)));
    }

    void logs_that_differ_are_told_so_and_one_of_four_is_left_out() {
        HeldLoop other = loop(0.06, 6);
        other.c4 = 1e-3;
        const QString foreign = written("other.csv", other);
        const QString first = written("first.csv", loop(0.05, 4));
        open({first, foreign});
        QVERIFY2(text("driftWarnings").contains("The logs differ in the harmonic 4"),
                 qPrintable(text("driftWarnings")));
        QVERIFY2(text("driftAgreement").contains("Harmonic 4: the logs differ"),
                 qPrintable(text("driftAgreement")));
        QVERIFY(!cell("driftHarmonics", 3, 1).contains("±"));
        QCOMPARE(the<XYPlotView>("driftPlot").content().series.size(), std::size_t{1});
        // Channels within their tolerances could be the cause between fewer logs.
        open({written("second.csv", loop(-0.05, 5)), written("third.csv", loop(0.03, 9))});
        QCOMPARE(drift().outcome()->drift.left_out, std::optional<std::size_t>(1));
        QVERIFY2(text("driftWarnings").contains("other.csv does not fit the other logs"),
                 qPrintable(text("driftWarnings")));
        QCOMPARE(the<FileList>("driftLogs").item(1)->text(), QString("other.csv (left out)"));
        QVERIFY(cell("driftHarmonics", 3, 1).contains("±"));
    }

    // A refused log keeps no other one from being seen: it is removed.
    void refusals_are_messages_and_a_log_is_removed_and_brought_back() {
        const QString good = written("good.csv", loop(0.05, 7));
        const QString bad = written("bad.csv", loop(0.05, 8), "t_s,psi,u,v");
        open({good, bad});
        QVERIFY(!drift().outcome());
        QVERIFY2(messages().contains("there is no column"), qPrintable(messages()));
        QVERIFY2(text("driftHint").contains("there is no column"), qPrintable(text("driftHint")));
        auto& list = the<FileList>("driftLogs");
        QCOMPARE(list.count(), 2);
        QVERIFY(!the<QPushButton>("driftRemove").isEnabled());
        list.setCurrentRow(1);
        click("driftRemove");
        wait();
        QVERIFY(drift().outcome());
        compareWith(computed({good}));
        QVERIFY2(messages().isEmpty(), qPrintable(messages()));
        QCOMPARE(list.count(), 1);

        QVERIFY2(document().undoStack().undoWords().contains("bad.csv"),
                 qPrintable(document().undoStack().undoWords()));
        window_->action(Command::undo)->trigger();
        QCOMPARE(list.count(), 2);
        wait();
        QVERIFY(!drift().outcome());
        // The columns are named.
        auto& columns = the<QLineEdit>("driftColumns");
        columns.setFocus();
        QTest::keyClicks(&columns, "t,phi");
        QTest::keyClick(&columns, Qt::Key_Return);
        QVERIFY(the<QLabel>("driftFault").isVisible());
        QVERIFY(drift().settings() == DriftSettings{});
        list.setFocus();
        list.clearSelection();
        list.setCurrentRow(0);
        QTest::keyClick(&list, Qt::Key_Delete);
        wait();
        columns.setFocus();
        columns.selectAll();
        QTest::keyClicks(&columns, "t,theta=psi");
        QTest::keyClick(&columns, Qt::Key_Return);
        wait();
        QVERIFY(!the<QLabel>("driftFault").isVisible());
        QVERIFY2(messages().contains("Choose degrees, radians or turns"), qPrintable(messages()));
        auto& unit = the<QComboBox>("driftAngleUnit");
        unit.setCurrentIndex(2);
        emit unit.activated(2);
        wait();
        QVERIFY2(messages().isEmpty(), qPrintable(messages()));
        DriftSettings settings;
        settings.log.names = "t,theta=psi";
        settings.log.rad_per_angle_unit = 1;
        QVERIFY(drift().settings() == settings);
        compareWith(computed({bad}, settings));
    }

    // They were options of the command line alone.
    void a_text_that_is_guessed_wrongly_is_told_as_what_it_is() {
        const WholeAngleLog held = test::simulated_log(loop(0.05, 11));
        // A number in the heading looks like a first row; the last column is the time.
        QByteArray text = "1;2;3;4\n0;0;0;0\n";
        const auto number = [](double value) {
            return QByteArray::number(value, 'g', 17).replace('.', ',');
        };
        for (std::size_t k = 0; k < held.time_s.size(); ++k) {
            text += number(held.theta[k]) + ';' + number(held.amplitude_effort[k]) + ';' +
                    number(held.quadrature_effort[k]) + ';' + number(held.time_s[k]) + '\n';
        }
        const QString log = home_.file("told.txt", text);
        open({log});
        typeInto(the<NumberField>("driftSkipLines"), "2");
        typeInto(the<NumberField>("driftTimeColumn"), "4");
        for (const auto& [name, place] :
             {std::pair{"driftDelimiter", 2}, {"driftDecimal", 2}, {"driftAngleUnit", 2}}) {
            auto& box = the<QComboBox>(QLatin1String(name));
            box.setCurrentIndex(place);
            emit box.activated(place);
        }
        auto& columns = the<QLineEdit>("driftColumns");
        columns.setFocus();
        QTest::keyClicks(&columns, "theta=1,amplitude=2,quadrature=3");
        QTest::keyClick(&columns, Qt::Key_Return);
        wait();
        QVERIFY2(drift().outcome(), qPrintable(messages()));
        DriftSettings told;
        TextChoice choice;
        choice.delimiter = ';';
        choice.decimal_comma = true;
        choice.lines_to_skip = 2;
        choice.time_column = 4;
        told.open.text = choice;
        told.log.names = "theta=1,amplitude=2,quadrature=3";
        told.log.rad_per_angle_unit = 1;
        QVERIFY(drift().settings() == told);
        QCOMPARE(drift().outcome()->drift.logs[0].rows, held.time_s.size());
        auto& time_column = the<NumberField>("driftTimeColumn");
        time_column.setFocus();
        time_column.selectAll();
        QTest::keyClick(&time_column, Qt::Key_Delete);
        QTest::keyClick(&time_column, Qt::Key_Return);
        QVERIFY(!drift().settings().open.text->time_column);
        document().undoStack().undo();
        QCOMPARE(the<NumberField>("driftTimeColumn").value(), std::optional(4.0));
        wait();
    }

    // At 1280 pixels the header and the numbers below it broke into two lines.
    void the_columns_of_all_logs_stand_on_one_line() {
        window_->resize(1280, 720);
        open({written("a.csv", loop(0.05, 1)), written("b.csv", loop(-0.04, 2))});
        auto& table = the<QuantityTable>("driftHarmonics");
        const QString head = table.horizontalHeaderItem(1)->text();
        QVERIFY(!head.contains(' '));
        VYBEG_AT_LEAST(table.columnWidth(1), table.fontMetrics().horizontalAdvance(head));
        // Values with their deviations, too: rows of numbers are as high as one line.
        for (int row = 1; row < log_terms; ++row) {
            VYBEG_LESS(table.rowHeight(row), 2 * table.fontMetrics().height());
        }
    }

    void settings_are_steps_of_undo() {
        const QString log = written("settings.csv", loop(0.05, 9));
        open({log});
        const double u = drift().outcome()->drift.harmonics[3].u;
        typeInto(the<NumberField>("driftKappa"), "0.0001");
        QVERIFY(drift().computing());
        wait();
        DriftSettings settings;
        settings.tolerance[kappa_error] = 1e-4;
        QVERIFY(drift().settings() == settings);
        compareWith(computed({log}, settings));
        VYBEG_LESS(drift().outcome()->drift.harmonics[3].u, u / 2);
        QVERIFY2(text("driftStatistical").contains("0.0001"), qPrintable(text("driftStatistical")));
        page().setFocus();
        document().undoStack().undo();
        QVERIFY(drift().settings() == DriftSettings{});
        wait();
        QCOMPARE(drift().outcome()->drift.harmonics[3].u, u);
        document().undoStack().redo();
        QVERIFY(drift().settings() == settings);
        document().undoStack().undo();
        document().undoStack().undo();
        QVERIFY(drift().logs().empty() && !drift().computing() && !drift().outcome());
        QVERIFY(text("driftHint").contains("Open whole-angle logs"));
        // A file that is open already is no step.
        document().undoStack().redo();
        const int steps = document().undoStack().count();
        drift().open({log});
        QCOMPARE(document().undoStack().count(), steps);
        wait();
    }

    void result_and_table_are_exported_and_no_log_is_replaced() {
        const QString log = written("exported.csv", loop(0.05, 10));
        open({log});
        const auto outcome = drift().outcome();
        for (const char* name : {"drift.json", "drift.csv"}) {
            const QString path = home_.path(name);
            click("driftExport");
            auto* dialog = window_->findChild<QFileDialog*>("files");
            QVERIFY(dialog && dialog->isVisible());
            emit dialog->fileSelected(path);
            dialog->close();
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            const std::string program = programName().toStdString();
            QCOMPARE(file.readAll().toStdString(), path.endsWith("json")
                                                       ? drift_json(program, *outcome)
                                                       : drift_csv(program, *outcome));
        }
        QFile before(log);
        QVERIFY(before.open(QIODevice::ReadOnly));
        const QByteArray bytes = before.readAll();
        window_->files().exportDriftTo(log);
        QVERIFY2(messages().contains("stays as it is"), qPrintable(messages()));
        before.seek(0);
        QCOMPARE(before.readAll(), bytes);
    }

    // Logs alone make a session; moved with it they are found, and another file is told.
    void a_session_keeps_logs_and_settings() {
        QVERIFY(QDir().mkpath(home_.path("here")));
        QVERIFY(QDir().mkpath(home_.path("there")));
        const QString log = written("here/log.csv", loop(0.05, 11));
        QVERIFY(!window_->action(Command::save_session)->isEnabled());
        open({log});
        typeInto(the<NumberField>("driftSkew"), "0.02");
        wait();
        QVERIFY(window_->action(Command::save_session)->isEnabled());
        QVERIFY(window_->session().isModified());
        const DriftSettings settings = drift().settings();
        const QString hash = QString::fromStdString(drift().logs().front().sha256);
        QCOMPARE(hash.size(), 64);
        const double u = drift().outcome()->drift.harmonics[4].u;
        const QString session = home_.path("here/gyro.vybeg");
        QVERIFY(savedTo(*window_, session));
        QVERIFY(!window_->session().isModified());
        QFile file(session);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
        QCOMPARE(json["drift"],
                 QJsonValue(QJsonObject{
                     {"logs", QJsonArray{QJsonObject{{"path", "log.csv"}, {"sha256", hash}}}},
                     {"settings", QJsonObject{{"tolerance", "skew=0.02"}}}}));
        file.close();

        const QString moved = home_.path("there/log.csv");
        QVERIFY(QFile::rename(log, moved));
        QVERIFY(QFile::rename(session, home_.path("there/gyro.vybeg")));
        cleanup();
        init();
        window_->files().open({home_.path("there/gyro.vybeg")});
        wait();
        QCOMPARE(drift().logs().size(), std::size_t{1});
        QCOMPARE(pathText(drift().logs().front()), moved);
        QCOMPARE(QString::fromStdString(drift().logs().front().sha256), hash);
        QVERIFY(drift().settings() == settings);
        QVERIFY(drift().outcome());
        QCOMPARE(drift().outcome()->drift.harmonics[4].u, u);
        QVERIFY(!document().undoStack().canUndo());
        QVERIFY(!window_->session().isModified());
        QVERIFY(page().isVisible());  // as it was saved
        QVERIFY2(messages().isEmpty(), qPrintable(messages()));
        drift().remove({moved});
        QVERIFY(window_->session().isModified());

        written("there/log.csv", loop(0.05, 12));
        cleanup();
        init();
        window_->files().open({home_.path("there/gyro.vybeg")});
        wait();
        QTRY_VERIFY2(messages().contains("is another file than that of the session"),
                     qPrintable(messages()));
        // A session without logs closes them.
        home_.file("empty.vybeg", R"({"vybeg_session": 1})");
        window_->files().open({home_.path("empty.vybeg")});
        QTRY_VERIFY(drift().logs().empty());
        QVERIFY(drift().settings() == DriftSettings{});
        window_->files().open(
            {home_.file("damaged.vybeg", R"({"vybeg_session": 1, "drift": {"logs": 3}})")});
        QTRY_VERIFY2(messages().contains("“drift”"), qPrintable(messages()));
    }

    void the_report_has_the_drift_in_both_languages() {
        open({written("report_a.csv", loop(0.05, 13)), written("report_b.csv", loop(-0.05, 14))});
        const WholeAngleDrift& found = drift().outcome()->drift;
        QVERIFY(window_->action(Command::report)->isEnabled());
        QCOMPARE(reportSubjects(document()).size(), std::size_t{1});
        for (const auto& [language, title, section] :
             {std::tuple{"en", "Report of whole-angle logs", "Drift of the whole angle"},
              std::tuple{"ru", "Отчёт о журналах интегрирующего режима",
                         "Дрейф в интегрирующем режиме"}}) {
            window_->setLanguage(language);
            const QString html = reportOf(0);
            for (const QString& part :
                 {QString(title), QString(section), QString("report_a.csv"),
                  QString::fromStdString(drift().logs().back().sha256),
                  heldRows(found.resonator, {}).at(2).cells.front().text, QString("κ ± ")}) {
                QVERIFY2(html.contains(part.toHtmlEscaped()), qPrintable(part));
            }
        }
        window_->setLanguage("en");
        const ReportContent alone = reportContentOf(document(), reportSubjects(document()).front());
        QCOMPARE(reportFigures(alone).size(), std::size_t{1});
        // Beside a recording it is a section of its report.
        document().open({home_.recording("decay.wav")});
        QTRY_VERIFY(!document().busy() && document().analyses().size() == 1);
        QCOMPARE(reportSubjects(document()).size(), std::size_t{2});
        const QString html = reportOf(0);
        QVERIFY(html.contains("Report of a free decay"));
        QVERIFY(html.contains("Drift of the whole angle"));
        QVERIFY(html.contains("decay.wav"));
    }
};

VYBEG_TEST(TestDriftPage)

}  // namespace test_drift_page

#include "test_drift_page.moc"
