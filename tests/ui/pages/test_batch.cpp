// The window of a batch: the table fills, is sorted, opens its sets, is stopped and goes on; its
// file is that of vybeg-cli.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/heartbeat.h"
#include "tests/ui/pages/batch_journey.h"
#include "ui/widgets/number_field.h"
#include "ui/window/page_stack.h"

#include <QPlainTextEdit>
#include <QTextDocumentFragment>

namespace test_batch {

using namespace vybeg;
using namespace vybeg::ui;
using vybeg::test::content;
using vybeg::test::run_cli;

class TestBatch : public BatchJourney {
    Q_OBJECT

    // What the mouse shows at a row.
    QString tip(int row) {
        const QString html = model().index(row, 0).data(Qt::ToolTipRole).toString();
        return QTextDocumentFragment::fromHtml(html).toPlainText();
    }

private slots:
    void initTestCase() { prepare(); }
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    void fills_with_a_row_for_each_set_and_writes_the_table_of_the_command_line() {
        open(home_.path("list.csv"), home_.path("first.csv"));
        QVERIFY(button("batchStart").isEnabled());
        QVERIFY(!button("batchStop").isEnabled());
        Heartbeat heartbeat;
        run();
        VYBEG_LESS(heartbeat.longestMs(), 50, qPrintable(heartbeat.text()));
        QCOMPARE(names(), QStringList({"HRG-2", "HRG-10", "broken", "HRG-1"}));
        QCOMPARE(content(home_.path("first.csv")), expected_);
        QVERIFY(!QFile::exists(home_.path("first.csv.unfinished")));
        QCOMPARE(message(), "Written: " + home_.path("first.csv"));
        QCOMPARE(progressText(), QString("4 of 4 sets; 1 without a result"));
        QCOMPARE(text(0, state), QString("done"));
        VYBEG_WITHIN(readNumber(text(0, split).section(' ', 0, 0)).value_or(0), 20, 1);
        // No recording came into the window.
        QVERIFY(window_->document().recordings().empty());
        // Without passports there are no verdicts.
        QVERIFY(table().isColumnHidden(column(titles[verdict])));
        QVERIFY(!table().isColumnHidden(column(titles[gyro])));
        VYBEG_MORE(column("lot"), 0);
        QCOMPARE(model().index(0, column("lot")).data().toString(), QString("a \"b\", c"));
    }

    void a_broken_recording_is_a_row_that_says_why() {
        open(home_.path("list.csv"), home_.path("why.csv"));
        run();
        const int row = rowOf("broken");
        QCOMPARE(text(row, state), QString("no result"));
        QVERIFY2(text(row, reason).contains("broken.wav"), qPrintable(text(row, reason)));
        const QModelIndex cell = model().index(row, 0);
        QCOMPARE(tip(row), text(row, reason));
        QVERIFY(cell.data(Qt::ForegroundRole).isValid());
        QVERIFY(!model().index(rowOf("HRG-1"), 0).data(Qt::ForegroundRole).isValid());
        table().setCurrentIndex(cell);
        QCOMPARE(childOf<QPlainTextEdit>(batch(), "batchDetails").toPlainText(), text(row, reason));
        // In the language of the window, at once.
        window_->setLanguage("ru");
        QTRY_COMPARE(batch().windowTitle(), QString("Пакетная обработка"));
        QCOMPARE(tip(row), model().index(row, column("Причина")).data().toString());
        QVERIFY(model().index(row, column("Причина")).data().toString().contains("файл"));
        QCOMPARE(model().index(row, column("Состояние")).data().toString(),
                 QString("нет результата"));
        VYBEG_MORE(column("Разночастотность\nмГц"), 0);
        QCOMPARE(progressText(), QString("4 из 4 наборов; без результата: 1"));
    }

    // Names of files are no HTML, which could load another file.
    void a_tip_shows_names_as_they_are() {
        const QString name = "<b>run<img src=x>.wav";
        home_.file("tags.csv", ("set,file\nA," + name + "\n").toUtf8());
        open(home_.path("tags.csv"), home_.path("tagged.csv"));
        run();
        QVERIFY2(tip(0).contains(name), qPrintable(tip(0)));
    }

    void a_click_on_a_header_sorts_by_numbers_with_failures_last() {
        open(home_.path("list.csv"), home_.path("sorted.csv"));
        run();
        clickHeader(titles[split]);
        QCOMPARE(names(), QStringList({"HRG-10", "HRG-2", "HRG-1", "broken"}));
        clickHeader(titles[split]);
        QCOMPARE(names(), QStringList({"HRG-1", "HRG-2", "HRG-10", "broken"}));
        clickHeader(titles[split]);
        QCOMPARE(names(), QStringList({"HRG-2", "HRG-10", "broken", "HRG-1"}));
        // Names in the order in which people count.
        clickHeader(titles[set_name]);
        QCOMPARE(names(), QStringList({"broken", "HRG-1", "HRG-2", "HRG-10"}));
    }

    void a_double_click_and_return_open_the_set_of_that_row() {
        open(home_.path("list.csv"), home_.path("opened.csv"));
        run();
        clickHeader(titles[split]);
        const QPoint at = table().visualRect(model().index(rowOf("HRG-1"), 0)).center();
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(table().viewport(), Qt::LeftButton, {}, at);
        Document& document = window_->document();
        QTRY_COMPARE(document.recordings().size(), 4U);
        QCOMPARE(document.sets().all().size(), 1U);
        const RecordingSet& set = *document.sets().current();
        QCOMPARE(set.name, QString("HRG-1"));
        QCOMPARE(set.recordings.size(), 4U);
        QCOMPARE(childOf<PageStack>(*window_).page(), Page::resonator);
        const MeasurementSet measured = document.sets().measured(set);
        QCOMPARE(measured.settings.signal.from_s, 0.1);
        QCOMPARE(measured.recordings[0].conditions.date, std::string("2026-03-31"));
        QTRY_VERIFY_WITH_TIMEOUT(!document.busy(), most_ms);
        // The same set again is the one that is open; Return opens another.
        table().setFocus();
        table().setCurrentIndex(model().index(rowOf("HRG-1"), 0));
        QTest::keyClick(&table(), Qt::Key_Return);
        QCOMPARE(document.sets().all().size(), 1U);
        table().setCurrentIndex(model().index(rowOf("HRG-2"), 0));
        QTest::keyClick(&table(), Qt::Key_Return);
        QCOMPARE(document.sets().all().size(), 2U);
        QCOMPARE(document.sets().current()->name, QString("HRG-2"));
        QTRY_VERIFY_WITH_TIMEOUT(!document.busy(), most_ms);
        // What is identified there is what the table has.
        QTRY_VERIFY_WITH_TIMEOUT(document.sets().canIdentify(), most_ms);
        document.sets().identify();
        QTRY_VERIFY_WITH_TIMEOUT(!document.busy(), most_ms);
        const auto found = document.sets().outcome(*document.sets().current());
        QVERIFY(found);
        const double in_table = model()
                                    .index(rowOf("HRG-2"), column(titles[split]))
                                    .data(BatchTable::sort_role)
                                    .toDouble();
        QCOMPARE(1e3 * found->identification.fit.resonator.split_hz.value, in_table);
    }

    void stopped_and_started_again_it_writes_the_same_table() {
        stopMidway(home_.path("stopped.csv"));
        QVERIFY(!QFile::exists(home_.path("stopped.csv")));
        QVERIFY(QFile::exists(home_.path("stopped.csv.unfinished")));
        const qsizetype kept = content(home_.path("stopped.csv.unfinished")).count('\n') - 1;
        VYBEG_AT_LEAST(kept, 1);
        VYBEG_LESS(kept, 4);
        run();
        QCOMPARE(content(home_.path("stopped.csv")), expected_);
        QVERIFY(!QFile::exists(home_.path("stopped.csv.unfinished")));
        QCOMPARE(progressText(), QString("4 of 4 sets; 1 without a result"));
    }

    void the_command_line_goes_on_where_the_window_stopped() {
        stopMidway(home_.path("both.csv"));
        const QByteArray rows = content(home_.path("both.csv.unfinished"));
        VYBEG_MORE(rows.count('\n'), 1);
        // By its full path, as the window reads it: the path is a part of a row's key.
        const auto outcome =
            run_cli({"batch", home_.path("list.csv"), "-o", "both.csv", "--resume", "--json-log"},
                    home_.path("."));
        QCOMPARE(outcome.status, 0);
        QCOMPARE(content(home_.path("both.csv")), expected_);
        // The first set was not computed again: progress begins behind it.
        QVERIFY2(!outcome.err.contains("\"25 %\""), outcome.err.constData());
    }

    void a_table_that_is_there_is_replaced_after_a_question() {
        const QString results = home_.file("there.csv", "# vybeg-cli 0.0.1\nset,verdict\n");
        open(home_.path("list.csv"), results);
        press("batchStart");
        clickAnswer("Cancel");
        QVERIFY(!batch().running());
        QCOMPARE(content(results), QByteArray("# vybeg-cli 0.0.1\nset,verdict\n"));
        QTRY_VERIFY(!batch().findChild<QMessageBox*>());
        press("batchStart");
        clickAnswer("Replace");
        QTRY_VERIFY_WITH_TIMEOUT(!batch().running() && progressText().startsWith("4 of 4"),
                                 most_ms);
        QCOMPARE(content(results), expected_);
    }
};

VYBEG_TEST(TestBatch, threads)

}  // namespace test_batch

#include "test_batch.moc"
