// The report: what stands in the PDF, in both languages, and its way through the window. Looked at
// with pdftotext, pdffonts and pdfinfo (poppler-utils).
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/heartbeat.h"
#include "tests/ui/resonator_runs.h"
#include "ui/plots/track_view.h"
#include "ui/report/report_content.h"
#include "ui/report/report_document.h"
#include "ui/report/report_parts.h"
#include "ui/resonator/resonator_text.h"
#include "ui/resonator/run_text.h"
#include "ui/window/export_dialogs.h"
#include "ui/window/file_commands.h"
#include "ui/words/language.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTest>

namespace test_report {

using namespace vybeg;
using namespace vybeg::ui;

namespace {

QString output(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    process.waitForFinished();
    return QString::fromUtf8(process.readAllStandardOutput());
}

// On one line, with single spaces.
QString textOf(const QString& pdf) {
    return output("pdftotext", {"-layout", pdf, "-"}).simplified();
}

bool isPdf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) && file.read(5) == "%PDF-" &&
           file.readAll().contains("%%EOF");
}

}  // namespace

class TestReport : public QObject, private WindowTest {
    Q_OBJECT

    void openAll(const QStringList& files) {
        document().open(files);
        const auto ready = [&] {
            return !document().busy() && qsizetype(document().analyses().size()) == files.size() &&
                   std::ranges::all_of(document().recordings(), [](const RecordingEntry& entry) {
                       return entry.faults && !entry.sha256.isEmpty();
                   });
        };
        QVERIFY(QTest::qWaitFor(ready, 60000));
    }

    void identifyAll() {
        std::vector<RecordingId> ids;
        for (const RecordingEntry& entry : document().recordings()) {
            ids.push_back(entry.id);
        }
        document().sets().addToCurrent(ids);
        document().sets().identify();
        QVERIFY(QTest::qWaitFor(
            [&] {
                return !document().busy() &&
                       document().sets().outcome(*document().sets().current());
            },
            60000));
    }

    void write(const std::vector<ReportContent>& contents, const QString& path) {
        window_->files().writeReport(contents, "All", path);
        QVERIFY(QTest::qWaitFor([&] { return isPdf(path); }, 60000));
    }

private slots:
    void initTestCase() {
        for (const char* tool : {"pdftotext", "pdffonts", "pdfinfo"}) {
            if (QStandardPaths::findExecutable(tool).isEmpty()) {
                qWarning("%s is missing: NO REPORT IS TESTED. Install poppler-utils.", tool);
                QSKIP("poppler-utils is missing");
            }
        }
    }
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    void the_report_of_a_set_holds_everything_in_both_languages() {
        openAll(resonatorRuns(home_, "HRG"));
        Tolerance tolerance;
        tolerance[skew_error] = 0.1;
        tolerance[delay_error] = 1e-8;
        document().setTolerance(tolerance);
        identifyAll();
        const auto subjects = reportSubjects(document());
        QVERIFY(!subjects.empty());
        QCOMPARE(subjects.front().recordings.size(), std::size_t{4});
        ReportContent content = reportContentOf(document(), subjects.front());
        QVERIFY(content.outcome && !content.out_of_date);
        content.title = {.number = "17/26",
                         .gyro = "HRG_0042 <a&b>",
                         .instrument = "E-502",
                         .engineer = "I. Ivanov",
                         .date = "2026-05-04",
                         .comment = "After_balancing"};
        const Identification& found = content.outcome->identification;
        for (const QString& language : {QStringLiteral("en"), QStringLiteral("ru")}) {
            window_->setLanguage(language);
            const QString path = home_.path("set-" + language + ".pdf");
            write({content}, path);
            const QString text = textOf(path);
            for (const TitleField& field : title_fields) {
                QVERIFY2(text.contains(content.title.*field.text), field.option);
            }
            for (const ReportRecording& each : content.recordings) {
                QVERIFY2(text.contains(each.name()), qPrintable(each.name()));
                const QString sha256 = QString::fromStdString(each.file.sha256);
                QCOMPARE(sha256.size(), 64);
                QVERIFY2(text.contains(sha256), qPrintable(sha256));
                for (const AnalysisEntry& analysis : each.analyses) {
                    const QString instant = QLocale().toString(analysis.summary.mean_at_s, 'f', 3);
                    QVERIFY2(text.contains(instant), qPrintable(instant));
                }
            }
            int given = 0;
            for (const QuantityRow& row : resonatorRows(found, content.units)) {
                const QString& value = row.cells.front().text;
                if (value.contains(QChar(0x00B1))) {
                    QVERIFY2(text.contains(value.simplified()),
                             qPrintable(row.name + ": " + value));
                    ++given;
                }
            }
            VYBEG_AT_LEAST(given, 6);
            const auto budget = budgetRows(found, content.units);
            QCOMPARE(qsizetype(budget.size()), given);
            for (const QuantityRow& row : budget) {
                for (const QuantityCell& cell : row.cells) {
                    QVERIFY2(text.contains(cell.text.simplified()),
                             qPrintable(row.name + ": " + cell.text));
                }
            }
            const bool russian = language == "ru";
            const QStringList words =
                russian ? QStringList{"Отчёт о выбеге", "Записи",  "Бюджет неопределённости",
                                      "Предупреждения", "События", "Страница 1 из "}
                        : QStringList{"Report of a free decay",
                                      "Recordings",
                                      "Uncertainty budget",
                                      "Warnings",
                                      "Events",
                                      "Page 1 of "};
            for (const QString& word : words) {
                QVERIFY2(text.contains(word), qPrintable(word));
            }
            const QString info = output("pdfinfo", {path});
            QVERIFY2(info.contains("HRG_0042"), qPrintable(info));
            QVERIFY2(output("pdfinfo", {"-meta", path}).contains("I. Ivanov"), qPrintable(info));
            const auto pages =
                QRegularExpression("Pages:\\s+(\\d+)").match(info).captured(1).toInt();
            // Four pages of plots, text before and after them.
            VYBEG_AT_LEAST(pages, 7, qPrintable(info));
            VYBEG_AT_MOST(pages, 12, qPrintable(info));
            const QString last =
                QString(russian ? "Страница %1 из %1" : "Page %1 of %1").arg(pages);
            QVERIFY2(text.contains(last), qPrintable(last));
            // Reports have the angle of files, whichever the window shows.
            content.units.wave_angle = WaveAngle::about_zero;
            write({content}, path);
            QCOMPARE(textOf(path), text);
            content.units.wave_angle = WaveAngle::doubled;
        }
    }

    // A chapter for each, found by its page in the table of all.
    // All six tolerances: the budget has nine columns of values.
    void no_number_is_broken() {
        openAll(resonatorRuns(home_, "HRG"));
        Tolerance all;
        all[kappa_error] = 0.01;
        all[skew_error] = 0.1;
        all[delay_error] = 1e-8;
        all[crosstalk_error] = all[phase_drift_error] = all[gain_drift_error] = 1e-4;
        document().setTolerance(all);
        identifyAll();
        const ReportContent content =
            reportContentOf(document(), reportSubjects(document()).front());
        const Identification& found = content.outcome->identification;
        QVERIFY(budgetHeaders(found).size() >= 8);
        for (const QString& language : {QStringLiteral("en"), QStringLiteral("ru")}) {
            window_->setLanguage(language);
            const QString path = home_.path("numbers-" + language + ".pdf");
            write({content}, path);
            const QString text = textOf(path);
            int numbers = 0;
            for (const auto& rows :
                 {budgetRows(found, content.units), resonatorRows(found, content.units),
                  modeRows(found.fit), runRows(found, content.units),
                  waveRows(found, content.units), driftRows(found, content.units)}) {
                for (const QuantityRow& row : rows) {
                    for (const QuantityCell& cell : row.cells) {
                        static const QRegularExpression word("\\p{L}{2}");
                        if (!cell.text.contains(word)) {
                            ++numbers;
                            QVERIFY2(text.contains(cell.text.simplified()), qPrintable(cell.text));
                        }
                    }
                }
            }
            VYBEG_MORE(numbers, 60);
        }
    }

    // Columns take the width of their words; only one that is longer than a line is broken, not
    // cut.
    void no_word_is_broken_that_a_line_has_room_for() {
        const QString name = QStringLiteral("abcdefghij_").repeated(20);
        const QString word = QStringLiteral("Неортогональность");
        const QString few = html({{"Name", word}, {{"run", ""}}, {95, 5}});
        for (const auto& [part, whole] :
             {std::pair{few, word}, std::pair{paragraph(name), name},
              std::pair{html({{"Name", "Other"}, {{name, ""}}, {90, 10}}), name}}) {
            ReportText text;
            text.html = part;
            const QString pdf = home_.path("word.pdf");
            QFile file(pdf);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(reportPdf(text, {}));
            file.close();
            const QString page =
                output("pdftotext", {"-x", "0", "-y", "0", "-W", "595", "-H", "842", pdf, "-"});
            QVERIFY2(page.contains(word) == (whole == word), qPrintable(page));
            QVERIFY2(QString(page).remove(QRegularExpression("\\s")).contains(whole),
                     qPrintable(page));
        }
    }

    // As on the axis of History and in file names: one date, whoever reads it.
    void dates_are_written_by_iso_8601_in_both_languages() {
        ReportRecording recording;
        recording.file.start = "2026-11-28T09:59";
        for (const char* language : {"en", "ru"}) {
            window_->setLanguage(language);
            QCOMPARE(measuredOn({recording}), QString("2026-11-28 09:59"));
            QCOMPARE(dateText("2026-11-28T09:59:07.5Z"), QString("2026-11-28 09:59:07.5Z"));
            QCOMPARE(dateText("2026-11-28"), QString("2026-11-28"));
            QCOMPARE(dateText("28 November"), QString("28 November"));
        }
        window_->setLanguage("en");
    }

    // Page 1 is to be signed, and a summary is this page alone.
    void the_page_to_be_signed_has_result_limits_and_verdict() {
        openAll(resonatorRuns(home_, "HRG"));
        identifyAll();
        ReportContent content = reportContentOf(document(), reportSubjects(document()).front());
        const Identification& found = content.outcome->identification;
        const Estimate& split = found.fit.resonator.split_hz;
        QVERIFY(split.given());
        const double far = 10 * split.uncertainty();
        content.title.engineer = "I. Ivanov";
        content.summary = true;
        const struct {
            std::vector<ParameterLimit> limits;
            const char* verdict;
        } cases[]{
            {{}, ""},
            {{{"split_hz", {}, split.value + far}}, "All limits are kept."},
            {{{"split_hz", {}, split.value - far}}, "Limits are not kept: Frequency split Δf."},
            {{{"split_hz", {}, split.value - far}, {"q", {}, found.fit.resonator.q.value}},
             "Limits are not kept: Frequency split Δf. Not shown to be kept: Quality factor Q."},
            {{{"split_hz", {}, split.value}},
             "No verdict; not shown to be kept: Frequency split Δf."},
        };
        for (const auto& [limits, verdict] : cases) {
            content.limits = limits;
            const QString path = home_.path("summary.pdf");
            QFile::remove(path);
            write({content}, path);
            QVERIFY(output("pdfinfo", {path}).contains(QRegularExpression("Pages: +1\n")));
            const QString text = textOf(path);
            for (const QuantityRow& row : resultRows(found, content.units, limits)) {
                QVERIFY2(text.contains(row.cells.front().text.simplified()), qPrintable(row.name));
            }
            const double u = 2 * split.uncertainty();
            QVERIFY2(text.contains(valueText(1e3 * split.value, 1e3 * u).simplified()),
                     qPrintable(text));
            for (const char* told : {verdict, "Measured I. Ivanov", "Checked", "Approved"}) {
                QVERIFY2(text.contains(told), told);
            }
            QCOMPARE(text.contains("erdict") || text.contains("imits are"), *verdict != '\0');
        }
    }

    // At every place of a page.
    void a_table_stays_on_one_page() {
        for (int lines = 20; lines < 70; lines += 4) {
            ReportText text;
            text.html = QStringLiteral("<p>filler</p>").repeated(lines) + smallHeading("Heading");
            HtmlTable table{{"Name", "Value"}, {}, {50, 50}};
            for (int k = 0; k < 8; ++k) {
                table.rows.push_back(
                    {QStringLiteral("row%1").arg(k), QStringLiteral("1.%1").arg(k)});
            }
            text.html += html(table) + paragraph("end");
            const QString pdf = home_.path("table.pdf");
            QFile file(pdf);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(reportPdf(text, {}));
            file.close();
            const QStringList pages = output("pdftotext", {"-layout", pdf, "-"}).split('\f');
            const auto has = [](const QString& page) { return page.contains("row0"); };
            const auto page = std::ranges::find_if(pages, has);
            QVERIFY(page != pages.end());
            QVERIFY2(page->contains("Heading"), qPrintable(QString::number(lines)));
            for (int k = 0; k < 8; ++k) {
                const QRegularExpression row(QStringLiteral("row%1 +1\\.%1").arg(k));
                QVERIFY2(page->contains(row), qPrintable(QString::number(lines) + *page));
            }
        }
    }

    void a_long_name_does_not_run_off_the_head_of_the_page() {
        const QString name = "first" + QStringLiteral("abcdefghi ").repeated(30) + "last";
        const ReportText text = framedReport("Report", name, "Vybeg");
        const QString pdf = home_.path("head.pdf");
        QFile file(pdf);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(reportPdf(text, {}));
        file.close();
        const QString head =
            output("pdftotext", {"-layout", pdf, "-"}).trimmed().section('\n', 0, 0);
        QVERIFY2(head.startsWith("Report: first") && head.endsWith("last"), qPrintable(head));
        QVERIFY2(head.contains(QChar(0x2026)) && head.size() < 200, qPrintable(head));
    }

    // A heading of two lines pushed the figure off its page.
    void figures_of_a_recording_with_a_long_name_stay_below_their_heading() {
        openAll({home_.recording("a_recording_of_the_second_balancing_step_at_45_degrees.wav")});
        const ReportContent content =
            reportContentOf(document(), reportSubjects(document()).front());
        const QString path = home_.path("long.pdf");
        write({content}, path);
        int pages = 0;
        for (int page = 1; page < 12; ++page) {
            const QString number = QString::number(page);
            const QString text =
                output("pdftotext", {"-layout", "-f", number, "-l", number, path, "-"});
            if (text.contains("Slow variables: a_recording")) {
                ++pages;
                QVERIFY2(text.contains(QChar(0x2026)) && text.contains("t, s"), qPrintable(text));
            }
        }
        QCOMPARE(pages, 1);
    }

    void a_set_that_was_refused_has_its_reason() {
        const QString run = home_.recording("run_1.wav");
        QVERIFY(QFile::copy(run, home_.path("copy.wav")));
        openAll({run, home_.path("copy.wav")});
        const auto first = document().recordings().front().id;
        const auto second = document().recordings().back().id;
        document().sets().addToCurrent({first, second});
        document().sets().identify();
        const auto refused = [&] {
            return document().sets().refusal(*document().sets().current());
        };
        QVERIFY(QTest::qWaitFor([&] { return refused() != nullptr; }, 60000));
        const auto subject = reportSubjects(document()).front();
        const ReportContent content = reportContentOf(document(), subject);
        QVERIFY(content.not_identified);
        QVERIFY(content.not_identified->code == ErrorCode::same_recording);
        const QString path = home_.path("refused.pdf");
        write({content}, path);
        const QString page = output("pdftotext", {"-layout", "-l", "1", path, "-"}).simplified();
        QVERIFY2(page.contains("a recording that is counted twice is no new evidence"),
                 qPrintable(page));
        // The reason is none of another set.
        document().sets().removeFrom(document().sets().current()->id, {second});
        QVERIFY(!refused());
    }

    void the_report_of_all_sets_has_a_chapter_for_each() {
        openAll({home_.recording("run_1.wav"), home_.recording("run_2.csv")});
        const auto first = document().recordings().front().id;
        const auto second = document().recordings().back().id;
        document().sets().add({first});
        document().sets().add({second});
        const auto subjects = reportSubjects(document());
        QVERIFY(subjects.back().all_sets);
        const auto contents = reportContentsOf(document(), subjects.back());
        QCOMPARE(contents.size(), std::size_t{2});
        const QString path = home_.path("all.pdf");
        write(contents, path);
        const QString text = textOf(path);
        QVERIFY2(!text.contains(QChar(0x27E6)), qPrintable(text));
        const QString outline = output("pdftohtml", {"-xml", "-i", "-stdout", path});
        int page = 0;
        for (const ReportContent& content : contents) {
            // The line of the set: its name, its page, the reason.
            const auto line = QRegularExpression(QRegularExpression::escape(content.set) +
                                                 " (\\d+) It has not been identified")
                                  .match(text);
            QVERIFY2(line.hasMatch(), qPrintable(text));
            VYBEG_MORE(line.captured(1).toInt(), page);
            page = line.captured(1).toInt();
            const QRegularExpression item(
                QStringLiteral("<item page=\"%1\">[^<]*%2")
                    .arg(page)
                    .arg(QRegularExpression::escape(content.set.toHtmlEscaped())));
            QVERIFY2(outline.contains(item), qPrintable(outline.section("<outline>", 1)));
            // Its first page is to be signed, the next one has the recordings.
            const QString chapter =
                output("pdftotext", {"-layout", "-f", QString::number(page), "-l",
                                     QString::number(page + 1), path, "-"});
            QVERIFY2(chapter.contains(content.set), qPrintable(chapter));
            QVERIFY2(chapter.contains(content.recordings.front().name()), qPrintable(chapter));
            const std::string& sha256 = content.recordings.front().file.sha256;
            QVERIFY2(chapter.contains(QString::fromStdString(sha256)), qPrintable(chapter));
        }
    }

    void fonts_are_embedded_and_plots_are_vectors() {
        openAll({home_.recording("demo.wav")});
        const QString path = home_.path("fonts.pdf");
        write({reportContentOf(document(), reportSubjects(document()).front())}, path);
        const QStringList fonts = output("pdffonts", {path}).split('\n', Qt::SkipEmptyParts).mid(2);
        QVERIFY(!fonts.isEmpty());
        static const QRegularExpression embedded("\\s(yes|no)\\s+(yes|no)\\s+(yes|no)\\s+\\d+");
        for (const QString& font : fonts) {
            const auto match = embedded.match(font);
            QVERIFY2(match.hasMatch(), qPrintable(font));
            QCOMPARE(match.captured(1), QStringLiteral("yes"));  // embedded
            QCOMPARE(match.captured(3), QStringLiteral("yes"));  // with its Unicode characters
        }
        const QStringList images =
            output("pdfimages", {"-list", path}).split('\n', Qt::SkipEmptyParts).mid(2);
        QVERIFY2(images.isEmpty(), qPrintable(images.join('\n')));
        // The names beside the axes are text.
        QVERIFY(textOf(path).contains("Hz"));
    }

    void a_recording_without_a_resonator_says_so() {
        openAll({home_.recording("alone.wav")});
        const QString path = home_.path("alone.pdf");
        write({reportContentOf(document(), reportSubjects(document()).front())}, path);
        QVERIFY(textOf(path).contains("It has not been identified."));
        QVERIFY(textOf(path).contains("____"));  // gyro and operator, to be filled in by hand
    }

    void the_window_asks_for_the_title_block_and_keeps_it() {
        QAction& report = *window_->action(Command::report);
        QVERIFY(!report.isEnabled());
        const QString recording = home_.recording("window.wav");
        openAll({recording});
        QTRY_VERIFY(report.isEnabled());
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
        QTest::keyClick(window_.get(), Qt::Key_P, Qt::ControlModifier);
        auto& dialog = childOf<ReportDialog>(*window_);
        QCOMPARE(childOf<QComboBox>(dialog).currentText(), QStringLiteral("window.wav"));
        childOf<QLineEdit>(dialog, "gyro").setText("HRG-7");
        childOf<QLineEdit>(dialog, "operator").setText("Петров");
        childOf<QCheckBox>(dialog).setChecked(true);
        const auto save = [&](const QString& path) {
            QTest::mouseClick(dialog.findChild<QPushButton*>("save"), Qt::LeftButton);
            auto& question = childOf<QFileDialog>(*window_);
            QCOMPARE(question.defaultSuffix(), QStringLiteral("pdf"));
            emit question.fileSelected(path);
            question.reject();
        };
        const QString path = home_.path("window.pdf");
        save(path);
        QVERIFY(QTest::qWaitFor([&] { return isPdf(path); }, 60000));
        const QString text = textOf(path);
        QVERIFY(text.contains("HRG-7") && text.contains("Петров"));
        QTRY_VERIFY(!window_->findChild<ReportDialog*>());
        report.trigger();
        auto& again = childOf<ReportDialog>(*window_);
        QCOMPARE(childOf<QLineEdit>(again, "gyro").text(), QStringLiteral("HRG-7"));
        QCOMPARE(childOf<QLineEdit>(again, "operator").text(), QStringLiteral("Петров"));
        QVERIFY(childOf<QCheckBox>(again).isChecked());
        again.reject();
    }

    void a_report_takes_no_recordings_place_and_a_missing_folder_is_told() {
        const QString recording = home_.recording("kept.wav");
        openAll({recording});
        const qint64 size = QFileInfo(recording).size();
        const ReportContent content =
            reportContentOf(document(), reportSubjects(document()).front());
        QStringList messages;
        connect(&document(), &Document::reported, this, [&](const Message& message) {
            if (message.severity == MessageLevel::error) {
                messages << message.text();
            }
        });
        window_->files().writeReport({content}, {}, recording);
        QTRY_COMPARE(messages.size(), 1);
        QCOMPARE(QFileInfo(recording).size(), size);
        window_->files().writeReport({content}, {}, home_.path("none/report.pdf"));
        QTRY_COMPARE(messages.size(), 2);
    }

    void the_window_stays_in_use_while_a_report_is_written() {
        openAll({home_.recording("long.wav", 28)});
        const ReportContent content =
            reportContentOf(document(), reportSubjects(document()).front());
        const QString path = home_.path("long.pdf");
        QElapsedTimer clock;
        clock.start();
        Heartbeat heart;
        write({content}, path);
        qInfo("written after %lld ms, %s", clock.elapsed(), qPrintable(heart.text()));
        VYBEG_LESS(heart.longestMs(), 150, qPrintable(heart.text()));
    }
};

VYBEG_TEST(TestReport)

}  // namespace test_report

#include "test_report.moc"
