// Page History: a laboratory's database opened, looked at, added to, as a person does it.
#include "core/database/results_database.h"
#include "tests/closeness.h"
#include "tests/core/database/made_result.h"
#include "tests/needed.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/heartbeat.h"
#include "tests/ui/resonator_runs.h"
#include "ui/document/document.h"
#include "ui/history/history_page.h"
#include "ui/panels/message_bar.h"
#include "ui/plots/plot_view.h"
#include "ui/window/file_commands.h"

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTabBar>
#include <QTextDocumentFragment>
#include <QtTest>
#include <qcustomplot.h>

#include <random>

namespace test_history_page {

using namespace vybeg;
using namespace vybeg::ui;

class TestHistoryPage : public QObject, private WindowTest {
    Q_OBJECT

    HistoryPage& page() { return the<HistoryPage>(); }

    // Without the links.
    QString text(const char* name) {
        return QTextDocumentFragment::fromHtml(the<QLabel>(name).text()).toPlainText();
    }

    void click(const char* button) { QTest::mouseClick(&the<QPushButton>(button), Qt::LeftButton); }

    // One result a day: split 0.01 Hz with deviation 1e-5 Hz, of which one in `out` lies 1e-3 off;
    // gyros G0, G1, ... in turn. In one transaction: the disk is not what is tested.
    QString database(const char* name, int results, int gyros = 1, int out = -1,
                     const QString& recording = {}, double rise = 0) const {
        const QString path = home_.path(name);
        auto made = test::needed(ResultsDatabase::open(
            path.toStdString(), ResultsDatabase::Access::write, JobControl()));
        SqliteConnection connection(path.toStdString(), [](int) { return true; });
        SqliteTransaction transaction(connection, "BEGIN IMMEDIATE");
        std::mt19937 random(7);
        std::normal_distribution<double> normal(0, 1e-5);
        for (int k = 0; k < results; ++k) {
            const std::string gyro = "G" + std::to_string(k % gyros);
            StoredResult result = test::made_result(k, gyro);
            result.set = "set " + std::to_string(k);
            result.date = {QDate(2024, 1, 1).addDays(k).toString(Qt::ISODate).toStdString(),
                           DateSource::list};
            result.parameters[1].estimate = {
                0.01 + normal(random) + (k == out ? 1e-3 : 0) + k * rise, 1e-5, {}, 2e-5};
            for (RecordingRef& each : result.recordings) {
                each.path = recording.isEmpty() ? each.path
                                                : std::filesystem::path(recording.toStdU16String());
                each.open = OpenOptions{.unit = "mV"};
            }
            if (!recording.isEmpty()) {
                result.recordings.resize(1);
                result.json = R"({"settings": {"from": "0.25", "model": "structured"}})";
            }
            write_result(connection, result);
        }
        transaction.commit();
        return path;
    }

    void waitForPage() {
        QVERIFY(QTest::qWaitFor([&] { return !page().reading(); }, 20000));
    }

    // By File > Open database… and the dialog.
    void open(const QString& path) {
        window_->action(Command::open_database)->trigger();
        auto* dialog = window_->findChild<QFileDialog*>("files");
        QVERIFY(dialog && dialog->isVisible());
        emit dialog->fileSelected(path);
        dialog->close();
        QVERIFY(page().isVisible());
        waitForPage();
    }

    void chooseGyro(int row) {
        auto& gyro = the<QComboBox>("historyGyro");
        gyro.setCurrentIndex(row);
        emit gyro.activated(row);
        waitForPage();
    }

    QString messages() { return the<MessageBar>().texts().join('\n'); }

private slots:
    void init() {
        QSettings().remove("history");
        window_ = shownWindow();
    }
    void cleanup() { window_.reset(); }

    // Against the order, as there is no date; its bar stands free of the frame.
    void a_first_result_without_a_date_is_seen() {
        const QString path = home_.path("first.db");
        QVERIFY(ResultsDatabase::open(path.toStdString(), ResultsDatabase::Access::write,
                                      JobControl()));
        StoredResult result = test::made_result(0, "G0");
        result.date = {};
        result.parameters[1].estimate = {0.01, 1e-5, {}, 2e-5};
        SqliteConnection connection(path.toStdString(), [](int) { return true; });
        SqliteTransaction transaction(connection, "BEGIN IMMEDIATE");
        write_result(connection, result);
        transaction.commit();
        open(path);
        const auto& values = the<XYPlotView>("historyValues");
        QVERIFY(values.isVisible() && !values.content().x_is_date);
        QCOMPARE(values.content().series.front().x, std::vector<double>{1});
        QVERIFY(!text("historyVerdict").contains("without a date"));
        const auto& plot = childOf<QCustomPlot>(values);
        const QCPRange shown = plot.axisRect()->axis(QCPAxis::atLeft)->range();
        VYBEG_AT_LEAST(shown.upper, 10 + 2 * 0.02);  // mHz
        VYBEG_AT_MOST(shown.lower, 10 - 2 * 0.02);
    }

    // Ctrl+7 without any recording: a sentence and buttons. Tracks then is the welcome again.
    void without_a_database_the_page_says_what_to_do() {
        QTest::keyClick(window_.get(), Qt::Key_7, Qt::ControlModifier);
        QVERIFY(page().isVisible() && the<QTabBar>("pages").isVisible());
        QVERIFY2(text("historyState").contains("database"), qPrintable(text("historyState")));
        const QRect said = the<QLabel>("historyState").geometry();
        VYBEG_CLOSE(said.center().x(), page().width() / 2, 2);
        VYBEG_CLOSE(said.center().y(), page().height() / 2, page().height() / 10);
        QVERIFY(the<QPushButton>("historyOpen").isVisible());
        QVERIFY(!the<QPushButton>("historyAdd").isEnabled());
        QVERIFY(!the<XYPlotView>("historyValues").isVisible());
        QVERIFY(page().figures().plots.isEmpty());
        the<QTabBar>("pages").setCurrentIndex(0);
        QVERIFY(!page().isVisible() && !the<QTabBar>("pages").isVisible());
    }

    // Beside each other where there is room.
    void the_choices_take_no_more_rows_than_they_need() {
        open(database("rows.db", 8));
        const std::array<const QWidget*, 4> choices{
            &the<QComboBox>("historyGyro"), &the<QComboBox>("historyParameter"),
            &the<QComboBox>("historyAxis"), &the<QSpinBox>("historyBaseline")};
        for (const auto& [width, rows] : {std::pair{1280, 1}, std::pair{800, 2}}) {
            window_->resize(width, 720);
            const auto taken = [&] {
                return choices.back()->y() > choices.front()->geometry().bottom() ? 2 : 1;
            };
            QTRY_COMPARE(taken(), rows);
            for (const QWidget* choice : choices) {
                VYBEG_AT_LEAST(choice->width(), choice->minimumSizeHint().width());
            }
        }
    }

    // Open it, look at all gyros, choose one, find what lies outside, choose a point.
    void a_journey_to_a_result_outside_the_limits() {
        open(database("journey.db", 120, 3, 90));
        QCOMPARE(page().history()->gyros.size(), std::size_t(3));
        QCOMPARE(page().history()->points.size(), std::size_t(120));
        QVERIFY(!the<XYPlotView>("historyRanges").isVisible());
        QVERIFY2(text("historyVerdict").contains("choose one"), qPrintable(text("historyVerdict")));
        VYBEG_CLOSE_RATIO(page().charts().moments.mean, 0.01, 0.01);
        chooseGyro(1);
        QCOMPARE(page().history()->points.size(), std::size_t(40));
        // 90 is the 31st of G0.
        const HistoryCharts& charts = page().charts();
        QVERIFY(charts.control.individuals.out[30] && charts.control.ranges.out[30]);
        VYBEG_CLOSE_RATIO(charts.control.centre, 0.01, 1e-3);
        const QString verdict = text("historyVerdict");
        QVERIFY2(verdict.contains("G0, 2024-03-31, set 90 (above the limit"), qPrintable(verdict));
        QVERIFY2(verdict.contains("first 20 results"), qPrintable(verdict));
        auto& values = the<XYPlotView>("historyValues");
        QVERIFY(values.isVisible() && values.content().x_is_date);
        QCOMPARE(values.content().series.front().x.size(), std::size_t(40));
        QVERIFY(!the<QPushButton>("historyRecordings").isVisible());
        QTest::mouseClick(&values, Qt::LeftButton, {}, values.positionOf(0, 30).toPoint());
        QVERIFY2(text("historyPoint").contains("set 90"), qPrintable(text("historyPoint")));
        values.setFocus();
        QTest::keyClick(&values, Qt::Key_Left);
        QVERIFY2(text("historyPoint").contains("set 87"), qPrintable(text("historyPoint")));
        // Its name in the sentence chooses it, too.
        QVERIFY(the<QLabel>("historyVerdict").text().contains("<a href=\"30\">G0, 2024-03-31"));
        emit the<QLabel>("historyVerdict").linkActivated(QStringLiteral("30"));
        QVERIFY2(text("historyPoint").contains("set 90"), qPrintable(text("historyPoint")));
        // Of a longer baseline that holds the value, it sets the limits itself.
        the<QSpinBox>("historyBaseline").setValue(40);
        VYBEG_MORE(page().charts().control.deviations[0], 1e-4);
        QCOMPARE(page().figures().plots.size(), 4);
    }

    // The distribution beside the values is seen from its first bin to its last one.
    void the_distribution_is_not_cut() {
        open(database("whole.db", 12));
        const auto& charts = page().charts();
        const Histogram& found = charts.histogram;
        VYBEG_MORE(found.counts.front(), 0);
        const auto& distribution = childOf<QCustomPlot>(the<XYPlotView>("historyDistribution"));
        const auto& values = childOf<QCustomPlot>(the<XYPlotView>("historyValues"));
        const QCPRange shown = distribution.axisRect()->axis(QCPAxis::atLeft)->range();
        QCOMPARE(shown, values.axisRect()->axis(QCPAxis::atLeft)->range());
        const double reach = std::max(3.0, -found.low) * charts.moments.sd;
        VYBEG_LESS(shown.lower, 1000 * (charts.moments.mean - reach));  // mHz
        VYBEG_MORE(shown.upper, 1000 * (charts.moments.mean + reach));
    }

    void a_single_date_is_shown_among_its_days() {
        open(database("single.db", 1));
        const auto& values = the<XYPlotView>("historyValues");
        QVERIFY(values.content().x_is_date);
        const auto& plot = childOf<QCustomPlot>(values);
        const QCPRange shown = plot.axisRect()->axis(QCPAxis::atBottom)->range();
        VYBEG_AT_MOST(shown.size(), 14 * 86400.0);
        VYBEG_CLOSE(shown.center(), values.content().series.front().x.front(), 1);
    }

    // Too few results, and a trend, are said on the page and in the legend of its figures.
    void a_baseline_that_sets_no_good_limits_is_named() {
        open(database("few.db", 8));
        chooseGyro(1);
        QVERIFY2(text("historyVerdict").contains("Limits need 10 results"),
                 qPrintable(text("historyVerdict")));
        const auto names = [&] {
            QString all;
            for (const XYSeries& series : the<XYPlotView>("historyValues").content().series) {
                all += series.name + "; ";
            }
            return all;
        };
        QVERIFY2(names().contains("values ± u (limits need 10 results, there are 8)"),
                 qPrintable(names()));
        open(database("trend.db", 30, 1, -1, {}, 1e-5));
        chooseGyro(1);
        QVERIFY2(text("historyVerdict").contains("rise or fall"),
                 qPrintable(text("historyVerdict")));
        QVERIFY2(names().contains("limits (the baseline has a trend)"), qPrintable(names()));
        // u of each result, not sd, is its bar.
        QCOMPARE(the<XYPlotView>("historyValues").content().series.front().sd.front(), 0.02);
    }

    // Limits of the session's dossier stand in the plot of their parameter, in the unit shown.
    void limits_of_the_gyro_are_drawn() {
        open(database("limits.db", 30));
        const auto limits = [&] {
            const auto& series = the<XYPlotView>("historyValues").content().series;
            const auto found =
                std::ranges::find(series, QStringLiteral("limits of the gyro"), &XYSeries::name);
            return found == series.end() ? std::vector<double>() : found->y;
        };
        QVERIFY(limits().empty());
        window_->document().dossier().setLimits({{"tau_s", 20.0, std::nullopt}});
        QVERIFY(limits().empty());  // of another parameter
        window_->document().dossier().setLimits({{"split_hz", std::nullopt, 0.0125}});
        QCOMPARE(limits(), (std::vector<double>{12.5, 12.5}));
        chooseGyro(1);
        QVERIFY(!text("historyVerdict").contains("limits of the gyro"));
        window_->document().dossier().setLimits({{"split_hz", 0.02, std::nullopt}});
        QVERIFY2(
            text("historyVerdict").startsWith("⚠ 30 results break the limits of the gyro. None"),
            qPrintable(text("historyVerdict")));
    }

    void results_of_another_program_are_seen_when_the_window_is_active_again() {
        const QString path = database("grows.db", 3);
        open(path);
        QCOMPARE(page().charts().values.size(), std::size_t{3});
        auto elsewhere = test::needed(ResultsDatabase::open(
            path.toStdString(), ResultsDatabase::Access::write, JobControl()));
        QVERIFY(elsewhere.add(test::made_result(7, "G0")));
        QFile file(path);  // a file system may count in seconds
        QVERIFY(file.open(QIODevice::ReadWrite) &&
                file.setFileTime(QDateTime::currentDateTime().addSecs(2),
                                 QFileDevice::FileModificationTime));
        QEvent back(QEvent::WindowActivate);
        QApplication::sendEvent(&page(), &back);
        QTRY_COMPARE(page().charts().values.size(), std::size_t{4});
    }

    // The same values against the frequency, and in order; the parameter and its unit.
    void axis_and_parameter_are_chosen() {
        open(database("axis.db", 30));
        chooseGyro(1);
        auto& values = the<XYPlotView>("historyValues");
        auto& axis = the<QComboBox>("historyAxis");
        axis.setCurrentIndex(1);
        QCOMPARE(values.content().x_unit, QString("Hz"));
        VYBEG_CLOSE_RATIO(values.content().series.front().x.front(), 5300, 1e-3);
        QVERIFY(std::ranges::is_sorted(values.content().series.front().x));
        axis.setCurrentIndex(2);
        QCOMPARE(values.content().series.front().x.back(), 30.0);
        QVERIFY(!values.content().x_is_date);
        auto& parameter = the<QComboBox>("historyParameter");
        QCOMPARE(parameter.count(), 18);
        parameter.setCurrentIndex(2);  // theta_w, in degrees
        waitForPage();
        QCOMPARE(values.content().y_unit, QString("°"));
        parameter.setCurrentIndex(12);
        waitForPage();
        QVERIFY(values.content().y_name.contains("Mode 1"));
        QCOMPARE(values.content().series.front().y.size(), std::size_t(30));
        parameter.setCurrentIndex(15);
        waitForPage();
        QVERIFY(values.content().series.empty() && !values.content().empty.isEmpty());
    }

    void a_double_click_opens_the_recordings_of_a_result() {
        open(database("there.db", 12, 1, -1, home_.recording("stored.wav")));
        auto& values = the<XYPlotView>("historyValues");
        QTest::mouseDClick(&values, Qt::LeftButton, {}, values.positionOf(0, 5).toPoint());
        QTRY_COMPARE(document().sets().all().size(), std::size_t(1));
        QTRY_COMPARE(document().recordings().size(), std::size_t(1));
        const RecordingSet& set = *document().sets().current();
        QCOMPARE(set.name, QString("set 5"));
        QCOMPARE(set.model, FitOptions::Model::structured);
        QCOMPARE(document().sets().measured(set).settings.signal.from_s, std::optional(0.25));
        QCOMPARE(document().sets().measured(set).recordings[0].conditions.gyro, std::string("G0"));
        QCOMPARE(document().recordings()[0].options.unit, std::string("mV"));
        QVERIFY(!page().isVisible());
        QVERIFY(QTest::qWaitFor([&] { return !document().busy(); }, 20000));
    }

    void missing_recordings_are_named() {
        open(database("gone.db", 12));
        auto& values = the<XYPlotView>("historyValues");
        QTest::mouseClick(&values, Qt::LeftButton, {}, values.positionOf(0, 3).toPoint());
        click("historyRecordings");
        QTRY_VERIFY2(messages().contains("/data/a/run-0.wav"), qPrintable(messages()));
        QVERIFY(document().sets().all().empty() && document().recordings().empty());
        QVERIFY(page().isVisible());
    }

    // A new database, an identified resonator, its result under a name and a date.
    void this_result_is_added() {
        const QString path = home_.path("new.db");
        QTest::keyClick(window_.get(), Qt::Key_7, Qt::ControlModifier);
        click("historyNew");
        auto* files = window_->findChild<QFileDialog*>("files");
        QVERIFY(files && files->isVisible());
        emit files->fileSelected(path);
        files->close();
        waitForPage();
        QVERIFY2(text("historyState").contains("no results"), qPrintable(text("historyState")));
        QVERIFY(!the<XYPlotView>("historyValues").isVisible());
        QVERIFY(!the<QPushButton>("historyAdd").isEnabled());
        window_->files().open(resonatorRuns(home_, "added"));
        QVERIFY(QTest::qWaitFor(
            [&] {
                return document().recordings().size() == 4 && !document().busy() &&
                       std::ranges::all_of(document().recordings(), [](const auto& entry) {
                           return entry.recording.has_value();
                       });
            },
            30000));
        std::vector<RecordingId> ids;
        for (const RecordingEntry& entry : document().recordings()) {
            ids.push_back(entry.id);
        }
        document().sets().addToCurrent(ids);
        document().sets().identify();
        QVERIFY(QTest::qWaitFor([&] { return the<QPushButton>("historyAdd").isEnabled(); }, 60000));
        click("historyAdd");
        auto& gyro = the<QComboBox>("storeGyro");
        auto& date = the<QLineEdit>("storeDate");
        auto& buttons = childOf<QDialogButtonBox>(*gyro.window());
        auto* ok = buttons.button(QDialogButtonBox::Ok);
        QVERIFY(!ok->isEnabled());  // no name yet
        QTest::keyClicks(gyro.lineEdit(), "HRG-17");
        QTest::keyClicks(&date, "31.3.26");
        QVERIFY(!ok->isEnabled());
        for (const char* written : {"2026-03-31T14:05", "31.03.2026"}) {
            date.clear();
            QTest::keyClicks(&date, written);
            QVERIFY(ok->isEnabled());
        }
        QTest::mouseClick(ok, Qt::LeftButton);
        QTRY_VERIFY(page().history() && page().history()->points.size() == 1);
        const HistoryPoint& point = page().history()->points.front();
        QCOMPARE(point.gyro, std::string("HRG-17"));
        QCOMPARE(point.date.text, std::string("2026-03-31"));
        VYBEG_WITHIN(point.value.value, 0.01, 4 * point.value.sd);
        // Once more: the same recordings and settings are the same result.
        click("historyAdd");
        QTest::keyClicks(the<QComboBox>("storeGyro").lineEdit(), "");
        auto& again = the<QComboBox>("storeGyro");
        again.setCurrentText("HRG-18");
        QTest::mouseClick(childOf<QDialogButtonBox>(*again.window()).button(QDialogButtonBox::Ok),
                          Qt::LeftButton);
        QTRY_VERIFY(page().history() && !page().reading() && page().history()->gyros.size() == 1 &&
                    page().history()->gyros[0].name == "HRG-18");
    }

    // By the button and the dialog: the table to read elsewhere, the report to show.
    void what_is_shown_is_exported_as_table_and_as_report() {
        QVERIFY(!the<QPushButton>("historyExport").isEnabled());
        open(database("export.db", 120, 3, 90));
        chooseGyro(1);
        const auto exported = [&](const char* name) {
            const QString path = home_.path(name);
            click("historyExport");
            auto* dialog = window_->findChild<QFileDialog*>("files");
            emit dialog->fileSelected(path);
            dialog->close();
            (void)QTest::qWaitFor([&] { return QFile::exists(path); }, 20000);
            QFile file(path);
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        const QList<QByteArray> lines = exported("history.csv").trimmed().split('\n');
        QCOMPARE(lines.size(), 5 + 1 + 40);
        QCOMPARE(lines[1], QByteArray("# database: export.db"));
        QCOMPARE(lines[2], QByteArray("# gyro: G0"));
        QCOMPARE(lines[3], QByteArray("# parameter: split_hz"));
        const QList<QByteArray> names = lines[5].split(',');
        const QList<QByteArray> row = lines[6 + 30].split(',');
        QCOMPARE(row.size(), names.size());
        const auto field = [&](const char* name) { return row[names.indexOf(name)]; };
        QCOMPARE(field("set"), QByteArray("set 90"));
        QCOMPARE(field("date"), QByteArray("2024-03-31"));
        QCOMPARE(field("split_hz").toDouble(), page().history()->points[30].value.value);
        QCOMPARE(field("u_split_hz").toDouble(), 2e-5);
        QCOMPARE(field("temperature_c").toDouble(), 21.0);
        QVERIFY(field("outside").startsWith("\"value;step"));

        const QByteArray pdf = exported("history.pdf");
        QVERIFY(pdf.startsWith("%PDF-"));
        if (QStandardPaths::findExecutable("pdftotext").isEmpty()) {
            QSKIP("pdftotext is missing: the report's text is not tested.");
        }
        QProcess reader;
        reader.start("pdftotext", {"-layout", home_.path("history.pdf"), "-"});
        QVERIFY(reader.waitForFinished());
        const QString text = QString::fromUtf8(reader.readAllStandardOutput()).simplified();
        for (const char* told : {"History of a parameter", "export.db", "G0, 2024-03-31, set 90",
                                 "above the limit", "first 20 results", "G0, 2024-01-01, set 0"}) {
            QVERIFY2(text.contains(told), told);
        }
        QCOMPARE(exported("again.pdf"), pdf);
    }

    void a_wrong_file_is_refused_and_the_path_is_remembered() {
        const QString wrong = home_.file("wrong.db", "no database at all, only text");
        open(wrong);
        QVERIFY(!page().history());
        QVERIFY2(text("historyState").contains("wrong.db"), qPrintable(text("historyState")));
        open(database("kept.db", 3));
        const QVariant kept = QSettings().value("history/database");
        window_ = shownWindow();  // without settings
        QSettings().setValue("history/database", kept);
        QVERIFY(!page().history());
        QTest::keyClick(window_.get(), Qt::Key_7, Qt::ControlModifier);
        waitForPage();
        QCOMPARE(page().path(), home_.path("kept.db"));
        QCOMPARE(page().history()->points.size(), std::size_t(3));
    }

    void the_page_speaks_the_language_of_the_window() {
        open(database("words.db", 30, 1, 25));
        chooseGyro(1);
        window_->setLanguage("ru");
        QTRY_COMPARE(the<QTabBar>("pages").tabText(6), QString("История"));
        QVERIFY2(text("historyVerdict").contains("выше"), qPrintable(text("historyVerdict")));
        QCOMPARE(page().history()->points.size(), std::size_t(30));
        window_->setLanguage("en");
        QTRY_VERIFY(text("historyVerdict").contains("above"));
    }

    // From the choice to the drawn picture, with control charts of all.
    void ten_thousand_results_are_shown_at_once() {
        const QString path = database("large.db", 10000);
        QElapsedTimer clock;
        open(path);
        Heartbeat heartbeat;
        clock.start();
        chooseGyro(1);
        const QImage drawn = page().grab().toImage();
        const qint64 elapsed = clock.elapsed();
        QCOMPARE(page().history()->points.size(), std::size_t(10000));
        QVERIFY(!drawn.isNull());
        qInfo("first chart of 10000 results: %lld ms; window still for %s", elapsed,
              qPrintable(heartbeat.text()));
        VYBEG_LESS(elapsed, 2000);
    }
};

VYBEG_TEST(TestHistoryPage, threads)

}  // namespace test_history_page

#include "test_history_page.moc"
