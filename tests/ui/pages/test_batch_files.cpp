// The window of a batch: its files and options, what cannot be written, copying, closing.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/pages/batch_journey.h"

#include <QCheckBox>
#include <QClipboard>
#include <QElapsedTimer>

namespace test_batch_files {

using namespace vybeg;
using namespace vybeg::ui;
using vybeg::test::content;
using vybeg::test::run_cli;

class TestBatchFiles : public BatchJourney {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() { window_ = shownWindow(); }
    void cleanup() { window_.reset(); }

    void what_cannot_be_written_or_read_is_said() {
        open(home_.path("list.csv"), home_.path("no/such/folder.csv"));
        run();
        QVERIFY2(message().contains("no/such/folder.csv"), qPrintable(message()));
        // In words of the window.
        open(home_.path("list.csv"), home_.path("list.csv"));
        press("batchStart");
        QVERIFY2(message().contains("not a table of results"), qPrintable(message()));
        QVERIFY(!batch().running());
        open(home_.path("none.csv"), home_.path("fine.csv"));
        run();
        QVERIFY2(message().contains("none.csv"), qPrintable(message()));
        QCOMPARE(model().rowCount(), 0);  // no rows of another list
        // Where the rows should go lies a folder.
        QVERIFY(QDir(home_.path(".")).mkpath("blocked.csv.unfinished"));
        open(home_.path("list.csv"), home_.path("blocked.csv"));
        run();
        QVERIFY2(message().contains("blocked.csv.unfinished"), qPrintable(message()));
        QVERIFY(button("batchStart").isEnabled());
    }

    void passports_give_verdicts_and_files_beside_the_table() {
        QVERIFY(QDir(home_.path(".")).mkpath("passports"));
        for (const auto& [gyro_name, of] :
             {std::pair{"HRG-2", "HRG-2"}, std::pair{"HRG-10", "HRG-1"}}) {
            const auto made = run_cli({"identify", "--list", "list.csv", "--set", of, "--passport",
                                       QString("passports/%1.json").arg(gyro_name)},
                                      home_.path("."));
            QCOMPARE(made.status, 0);
            // Another gyro's passport gives no verdict: this one takes the name.
            QFile file(home_.path(QString("passports/%1.json").arg(gyro_name)));
            QVERIFY(file.open(QIODevice::ReadWrite));
            const QByteArray passport = file.readAll().replace(QByteArray("\"") + of + "\"",
                                                               QByteArray("\"") + gyro_name + "\"");
            QVERIFY(file.resize(0) && file.seek(0) && file.write(passport) > 0);
        }
        open(home_.path("list.csv"), home_.path("judged.csv"));
        batch().form().setPath(BatchPath::passports, home_.path("passports"));
        batch().form().setPath(BatchPath::json, home_.path("json"));
        batch().form().setPath(BatchPath::database, home_.path("results.db"));
        run();
        QVERIFY(!table().isColumnHidden(column(titles[verdict])));
        QCOMPARE(text(rowOf("HRG-2"), verdict), QString("= unchanged"));
        QCOMPARE(text(rowOf("HRG-10"), verdict), QString("≠ changed"));
        QVERIFY(model().index(rowOf("HRG-10"), column("Changed")).data().toString().contains("Δf"));
        const auto color = [&](const char* name) {
            return model()
                .index(rowOf(name), column(titles[verdict]))
                .data(Qt::ForegroundRole)
                .value<QColor>();
        };
        QVERIFY(color("HRG-2") != color("HRG-10"));
        QVERIFY(QFile::exists(home_.path("json/HRG-1.json")));
        QVERIFY(QFile::exists(home_.path("results.db")));
    }

    void rows_are_copied_as_a_table() {
        open(home_.path("list.csv"), home_.path("copied.csv"));
        run();
        table().setFocus();
        table().selectRow(rowOf("HRG-2"));
        QTest::keyClick(&table(), Qt::Key_C, Qt::ControlModifier);
        const QStringList lines = QGuiApplication::clipboard()->text().split('\n');
        QCOMPARE(lines.size(), 3);
        const QStringList head = lines[0].split('\t');
        const QStringList cells = lines[1].split('\t');
        QCOMPARE(cells.size(), head.size());
        QCOMPARE(cells[0], QString("HRG-2"));
        const auto at = head.indexOf("Frequency split, mHz");
        VYBEG_MORE(at, 0);
        QCOMPARE(cells[at].toDouble(), model()
                                           .index(rowOf("HRG-2"), column(titles[split]))
                                           .data(BatchTable::sort_role)
                                           .toDouble());
        QCOMPARE(head[at + 1], QString("sd"));
        VYBEG_MORE(cells[at + 1].toDouble(), 0);
    }

    void settings_of_the_panel_hold_where_the_list_has_none() {
        Settings settings = window_->document().settings();
        settings.to_s = 3.5;
        window_->document().setSettings(settings);
        open(home_.path("list.csv"), home_.path("panel.csv"));
        QTest::mouseClick(&childOf<QCheckBox>(batch(), "batchPanel"), Qt::LeftButton, {},
                          QPoint(8, childOf<QCheckBox>(batch(), "batchPanel").height() / 2));
        run();
        const auto outcome = run_cli(
            {"batch", home_.path("list.csv"), "--to", "3.5", "-o", "to.csv"}, home_.path("."));
        QCOMPARE(outcome.status, 0);
        QVERIFY(content(home_.path("to.csv")) != expected_);
        QCOMPARE(content(home_.path("panel.csv")), content(home_.path("to.csv")));
    }

    void a_folder_is_a_set_for_each_file() {
        QVERIFY(QDir(home_.path(".")).mkpath("folder"));
        for (const char* name : {"one.wav", "two.wav"}) {
            QVERIFY(QFile::copy(home_.recording("source.wav"), home_.path("folder/") + name));
        }
        window_->action(Command::batch)->trigger();
        batch().form().setPath(BatchPath::folder, home_.path("folder"));
        QCOMPARE(batch().form().path(BatchPath::results), home_.path("folder_results.csv"));
        run();
        QCOMPARE(names(), QStringList({"one.wav", "two.wav"}));
        QVERIFY(table().isColumnHidden(column(titles[gyro])));
    }

    void every_warning_of_the_list_stays() {
        QFile list(home_.path("list.csv"));
        QVERIFY(list.open(QIODevice::ReadOnly));
        QByteArrayList lines = list.readAll().trimmed().split('\n');
        for (QByteArray& line : lines) {
            line += &line == &lines.front() ? ",wndow,flter" : ",1,2";
        }
        const QByteArray text = lines.join('\n');
        open(home_.file("warned.csv", text), home_.path("warned_table.csv"));
        run();
        QCOMPARE(message().count("⚠"), 2);
        QVERIFY2(message().endsWith("Written: " + home_.path("warned_table.csv")),
                 qPrintable(message()));
    }

    void an_untouched_proposal_follows_the_list() {
        window_->action(Command::batch)->trigger();
        QVERIFY(!button("batchStart").isEnabled());
        BatchForm& form = batch().form();
        form.setPath(BatchPath::list, home_.path("list.csv"));
        QCOMPARE(form.path(BatchPath::results), home_.path("list_results.csv"));
        form.setPath(BatchPath::list, home_.path("other.csv"));
        QCOMPARE(form.path(BatchPath::results), home_.path("other_results.csv"));
        form.setPath(BatchPath::results, home_.path("mine.csv"));
        form.setPath(BatchPath::list, home_.path("list.csv"));
        QCOMPARE(form.path(BatchPath::results), home_.path("mine.csv"));
    }

    void closing_asks_and_the_end_of_the_program_does_not() {
        open(home_.path("list.csv"), home_.path("closed.csv"));
        press("batchStart");
        batch().close();
        clickAnswer("Go on");
        QVERIFY(batch().isVisible());
        QTRY_VERIFY(!batch().findChild<QMessageBox*>());
        QVERIFY(batch().running());
        batch().close();
        clickAnswer("Stop and close");
        QTRY_VERIFY_WITH_TIMEOUT(!batch().running() && !batch().isVisible(), most_ms);
        // It opens again with its files, runs to the end, and stays.
        window_->action(Command::batch)->trigger();
        run();
        QVERIFY(batch().isVisible());
        QVERIFY2(message().startsWith("Written"), qPrintable(message()));
        QVERIFY(QFile::remove(home_.path("closed.csv")));
        press("batchStart");
        QVERIFY(batch().running());
        QElapsedTimer clock;
        clock.start();
        window_->close();
        QVERIFY(!batch().isVisible());
        window_.reset();
        VYBEG_LESS(clock.elapsed(), 2000);
        window_ = shownWindow();
        QVERIFY(!QFile::exists(home_.path("closed.csv")));
    }

    void the_time_left_is_that_of_the_sets_of_this_run() {
        BatchProgress progress;
        progress.begin(5);
        progress.add(true);
        QVERIFY(!progress.secondsLeft());
        progress.add(false);
        QVERIFY(progress.secondsLeft());
        VYBEG_AT_LEAST(*progress.secondsLeft(), 0);
        progress.add(false);
        progress.add(false);
        progress.add(false);
        QVERIFY(!progress.secondsLeft());
        QCOMPARE(durationText(12.2), QString("13 s"));
        QCOMPARE(durationText(300), QString("5 min"));
        QCOMPARE(durationText(9000), QString("2.5 h"));
    }
};

VYBEG_TEST(TestBatchFiles, threads)

}  // namespace test_batch_files

#include "test_batch_files.moc"
