// A batch that is interrupted, killed or out of room goes on where it was: its table is, byte for
// byte, that of a run without an end in between.
#include "tests/app/batch_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <random>
#include <sys/stat.h>

namespace test_cli_batch_resume {

using namespace vybeg::test;

namespace {

// Beside the table.
const QString journal = "results.csv.unfinished";

}  // namespace

class TestCliBatchResume : public QObject, private CliFolder {
    Q_OBJECT

    const QStringList work_ = words("batch list.csv -o results.csv --json json --threads 1");
    QByteArray table_;
    QMap<QString, QByteArray> results_;  // by the names of their files
    qint64 undisturbed_ms_ = 0;

    void begin(QProcess& process, const QStringList& options = {}) const {
        start(process, work_ + options);
        process.waitForStarted();
    }

    // Ends a run by a signal after a time, or once it has a row more where `after_ms` is below 0.
    Outcome end_after(const QStringList& options, int signal, int after_ms) const {
        const int before = rows_done();
        QProcess process;
        begin(process, options);
        if (after_ms >= 0) {
            QTest::qSleep(after_ms);  // the moment of the run
        } else {
            [[maybe_unused]] const bool there = QTest::qWaitFor(
                [&] { return rows_done() > before || process.state() == QProcess::NotRunning; },
                20000);
        }
        if (process.state() == QProcess::Running) {
            kill(static_cast<pid_t>(process.processId()), signal);
        }
        process.waitForFinished(30000);
        const bool killed = process.exitStatus() == QProcess::CrashExit;
        return {killed ? -1 : process.exitCode(), {}, process.readAllStandardError()};
    }

    void clear() const {
        QFile::remove(path("results.csv"));
        QFile::remove(path(journal));
        QDir(path("json")).removeRecursively();
    }

    // Rows that are whole in the journal.
    int rows_done() const {
        return QFile::exists(path(journal)) ? std::max(int(file(journal).count('\n')) - 1, 0) : 0;
    }

    // Interrupts a run when some of its rows, but not all, are done.
    bool leave_rows() const {
        for (int attempt = 0; attempt < 50; ++attempt) {
            clear();
            QProcess process;
            begin(process);
            if (!QTest::qWaitFor([this] { return rows_done() >= 4; }, 20000)) {
                return false;
            }
            process.kill();
            process.waitForFinished(20000);
            if (process.exitStatus() == QProcess::CrashExit && rows_done() < 12) {
                return true;
            }
        }
        return false;
    }

    QMap<QString, QByteArray> results() const {
        QMap<QString, QByteArray> found;
        for (const QString& name : QDir(path("json")).entryList(QDir::Files | QDir::Hidden)) {
            found[name] = file("json/" + name);
        }
        return found;
    }

    void resume_and_compare() const {
        const Outcome outcome = run(work_ + words("--resume"));
        VYBEG_EQUAL(outcome.status, 0, outcome.err);
        QCOMPARE(file("results.csv"), table_);
        QVERIFY(!QFile::exists(path(journal)));
        QCOMPARE(temporaries(), QStringList());
        QCOMPARE(results().size(), 9);
        QVERIFY(results() == results_);
    }

    // As a run from nothing, and none of those of before.
    void resume_makes_other_rows() const {
        QCOMPARE(run(work_ + words("--resume")).status, 0);
        const QByteArray changed = file("results.csv");
        QCOMPARE(run(work_).status, 0);
        QCOMPARE(changed, file("results.csv"));
        QVERIFY(changed != table_);
    }

private slots:
    void initTestCase() {
        QVERIFY(make_twelve_sets(folder_.path()));
        QCOMPARE(run(work_).status, 0);
        QElapsedTimer timer;
        timer.start();
        QCOMPARE(run(work_).status, 0);
        undisturbed_ms_ = timer.elapsed();
        table_ = file("results.csv");
        results_ = results();
        QCOMPARE(rows_of(table_).size(), 12);
    }

    void interrupted_at_random_moments_the_table_is_the_same_data() {
        QTest::addColumn<int>("signal");
        QTest::addColumn<QStringList>("options");
        QTest::newRow("SIGINT") << SIGINT << QStringList{};
        QTest::newRow("SIGINT, two jobs") << SIGINT << words("--jobs 2");
        QTest::newRow("SIGKILL") << SIGKILL << QStringList{};
        QTest::newRow("SIGKILL, two jobs") << SIGKILL << words("--jobs 2");
    }

    void interrupted_at_random_moments_the_table_is_the_same() {
        QFETCH(int, signal);
        QFETCH(QStringList, options);
        std::mt19937 random(static_cast<unsigned>(signal));
        int with_rows = 0;
        // More where none of them met a run with rows: a fast machine is done before most of them.
        for (int trial = 0; trial < 5 || (trial < 30 && with_rows == 0); ++trial) {
            clear();
            QVERIFY(put(path("results.csv"), "old"));
            // An interruption at any moment, one when there is another row, then the rest.
            for (int times = 0; times < 2; ++times) {
                const auto latest = static_cast<unsigned>(undisturbed_ms_ + 1);
                const int moment = times == 0 ? static_cast<int>(random() % latest) : -1;
                const Outcome end = end_after(options + QStringList{"--resume"}, signal, moment);
                if (end.status == 0) {
                    break;
                }
                QVERIFY2(end.status == -1 || end.status == 130, end.err);
                // Killed between the last step and its exit, the program has finished its table.
                const QByteArray now = file("results.csv");
                QVERIFY2(now == "old" || (signal == SIGKILL && now == table_), now);
                if (now != "old") {
                    break;
                }
                const int done = rows_done();
                with_rows += done > 0 && done < 12 ? 1 : 0;
                if (end.status == 130) {
                    const QByteArray last = end.err_lines().last();
                    QCOMPARE(last, done == 0
                                       ? QByteArray("vybeg-cli: Interrupted; nothing was "
                                                    "written.")
                                       : "vybeg-cli: Interrupted; " + QByteArray::number(done) +
                                             " of 12 sets are done. Continue with --resume.");
                    QCOMPARE(QFile::exists(path(journal)), done > 0);
                }
            }
            resume_and_compare();
            if (QTest::currentTestFailed()) {
                return;
            }
        }
        VYBEG_AT_LEAST(with_rows, 1,
                       "too few signals met a run with rows for the test to mean much");
    }

    void finished_rows_are_not_computed_again() {
        QVERIFY(leave_rows());
        const int done = rows_done();
        VYBEG_AT_LEAST(done, 4);
        VYBEG_LESS(done, 12);
        // Each of the first sets that has one recording warns while it is computed.
        const Outcome outcome = run(work_ + words("--resume"));
        QCOMPARE(outcome.status, 0);
        QVERIFY2(!outcome.err.contains("s2: ") && !outcome.err.contains("broken: "), outcome.err);
        QVERIFY2(outcome.err.contains("s11: "), outcome.err);
        QCOMPARE(file("results.csv"), table_);
        // Without --resume all of them are.
        QVERIFY(leave_rows());
        const Outcome anew = run(work_);
        QVERIFY2(anew.err.contains("s2: ") && anew.err.contains("broken: "), anew.err);
        QVERIFY2(anew.err.contains("finished rows of an interrupted batch"), anew.err);
        QCOMPARE(file("results.csv"), table_);
        QVERIFY(!QFile::exists(path(journal)));
    }

    void lost_results_are_written_again() {
        QVERIFY(leave_rows());
        QVERIFY(QDir(path("json")).removeRecursively());
        resume_and_compare();
    }

    // Begun again without --resume, and interrupted once more: a later --resume has the rows of
    // both.
    void a_run_without_resume_keeps_the_rows() {
        QVERIFY(leave_rows());
        const QByteArray rows = file(journal);
        QProcess process;
        begin(process);
        QTest::qWait(50);
        process.kill();
        process.waitForFinished(20000);
        if (process.exitStatus() == QProcess::CrashExit && file("results.csv") != table_) {
            QVERIFY(file(journal).startsWith(rows));
        }
        const Outcome outcome = run(work_ + words("--resume"));
        VYBEG_EQUAL(outcome.status, 0, outcome.err);
        QVERIFY2(!outcome.err.contains("s2: "), outcome.err);
        QCOMPARE(file("results.csv"), table_);
    }

    void a_half_written_row_is_computed_again() {
        QVERIFY(leave_rows());
        const QByteArray whole = file(journal);
        VYBEG_AT_LEAST(whole.count('\n'), 4);
        const qsizetype last = whole.lastIndexOf('\n', whole.size() - 2) + 1;
        for (const qsizetype size : {last + 1, (last + whole.size()) / 2, whole.size() - 1}) {
            QVERIFY(put(path(journal), whole.left(size)));
            resume_and_compare();
        }
        QByteArray damaged = whole;
        damaged[(last + whole.size()) / 2] = '\0';
        QVERIFY(put(path(journal), damaged));
        resume_and_compare();
    }

    void other_options_and_other_files_make_other_rows() {
        QVERIFY(leave_rows());
        const QStringList filtered = work_ + words("--filter 5000,5600");
        const Outcome other = run(filtered + QStringList{"--resume"});
        QCOMPARE(other.status, 0);
        QVERIFY2(other.err.contains("finished rows that this batch cannot take"), other.err);
        const QByteArray resumed = file("results.csv");
        QVERIFY(resumed != table_);
        QCOMPARE(run(filtered).status, 0);
        QCOMPARE(resumed, file("results.csv"));

        QVERIFY(leave_rows());
        const QByteArray recording = file("b.wav");
        QVERIFY(put(path("b.wav"), file("c.wav")));
        resume_makes_other_rows();
        QVERIFY(put(path("b.wav"), recording));
    }

    // A copy tool may put the time of the last change back.
    void other_bytes_of_the_same_size_and_time_make_other_rows() {
        QVERIFY(leave_rows());
        const QByteArray recording = file("b.wav");
        struct stat before {};
        QCOMPARE(stat(qPrintable(path("b.wav")), &before), 0);
        QTest::qSleep(20);  // a tick of the file system's clock
        QVERIFY(put(path("b.wav"), file("c.wav")));
        const timespec times[2]{before.st_atim, before.st_mtim};
        QCOMPARE(utimensat(AT_FDCWD, qPrintable(path("b.wav")), times, 0), 0);
        resume_makes_other_rows();
        QVERIFY(put(path("b.wav"), recording));
    }

    // A run that ends before its first row leaves the rows of other options to a later one.
    void rows_of_other_options_outlive_a_run_without_rows() {
        QVERIFY(leave_rows());
        const QByteArray rows = file(journal);
        bool interrupted = false;
        for (int after_ms = 0; after_ms < 400 && !interrupted; after_ms += 10) {
            const Outcome outcome =
                end_after({"--resume", "--filter", "5000,5600"}, SIGINT, after_ms);
            interrupted = outcome.status == 130;
            QVERIFY2(file(journal).startsWith(rows), outcome.err);
        }
        QVERIFY(interrupted);
        resume_and_compare();
    }

    // The file of a set is that of its last row, which is of other settings here.
    void results_of_other_settings_are_written_again() {
        QVERIFY(leave_rows());
        end_after({"--resume", "--filter", "5000,5600"}, SIGKILL, -1);
        QVERIFY(results() != results_);
        resume_and_compare();
    }

    void a_list_that_has_grown_keeps_its_rows() {
        QVERIFY(leave_rows());
        QVERIFY(put(path("list.csv"), twelve_sets + "s13,a.wav,,,0.7,\n"));
        const Outcome outcome = run(work_ + words("--resume"));
        QCOMPARE(outcome.status, 0);
        QVERIFY2(!outcome.err.contains("s2: ") && outcome.err.contains("s13: "), outcome.err);
        QCOMPARE(rows_of(file("results.csv")).mid(0, 12), rows_of(table_));
        QCOMPARE(rows_of(file("results.csv")).size(), 13);
        QVERIFY(put(path("list.csv"), twelve_sets));
    }

    void two_runs_do_not_share_a_table() {
        clear();
        QProcess first;
        begin(first);
        QVERIFY(QTest::qWaitFor([this] { return QFile::exists(path(journal)); }, 20000));
        kill(static_cast<pid_t>(first.processId()), SIGSTOP);
        const Outcome second = run(work_ + words("--resume"));
        kill(static_cast<pid_t>(first.processId()), SIGCONT);
        QVERIFY(first.waitForFinished(30000));
        QCOMPARE(second.status, 5);
        QVERIFY2(second.err.contains("another program is writing it"), second.err);
        QCOMPARE(first.exitCode(), 0);
        QCOMPARE(file("results.csv"), table_);
    }

    void a_file_that_may_not_grow_leaves_what_is_done() {
        const int sizes = 8;
        for (int k = 0; k < sizes; ++k) {
            clear();
            QVERIFY(put(path("results.csv"), "old"));
            const qint64 most = table_.size() * k / sizes;
            // No --json: its files are larger than the table.
            const QStringList work = work_.mid(0, 4);
            const Outcome outcome = run_here(VYBEG_CLI, work + QStringList{"--resume"},
                                             limit(RLIMIT_FSIZE, static_cast<rlim_t>(most)));
            const QByteArray about = QByteArray::number(most) + " bytes: " + outcome.err;
            VYBEG_EQUAL(outcome.status, 5, about);
            QVERIFY2(outcome.err_lines().last().contains("cannot be written"), about);
            QCOMPARE(file("results.csv"), QByteArray("old"));
            QCOMPARE(temporaries(), QStringList());
            QCOMPARE(QFile::exists(path(journal)), rows_done() > 0);
            if (k >= sizes / 2) {
                VYBEG_MORE(rows_done(), 0, about);
            }
            QCOMPARE(run(work + QStringList{"--resume"}).status, 0);
            QCOMPARE(file("results.csv"), table_);
        }
    }

    // A disk in memory, mounted where only the child sees it, which gets more room afterwards.
    void a_full_disk_leaves_what_is_done() {
        QDir(folder_.path()).mkdir("out");
        if (run_here("unshare", {"-rm", "mount", "-t", "tmpfs", "none", path("out")}).status != 0) {
            QSKIP(
                "NOT TESTED: this system lets no disk of a chosen size be mounted (unshare -rm). "
                "The limit of the file's size was tested instead.");
        }
        const QString command =
            QString("%1 batch list.csv -o out/results.csv --json out/json --quiet").arg(VYBEG_CLI);
        for (const int pages : {2, 4, 10, 40}) {
            const QString script =
                QString(
                    "mount -t tmpfs -o size=%1 none out && printf old > out/results.csv; "
                    "%2 2> err > /dev/null; echo $?; cat out/results.csv; echo; "
                    "ls -A out | grep -c part; mount -o remount,size=9m out; "
                    "%2 --resume 2> /dev/null; echo $?; cat out/results.csv")
                    .arg(pages * 4096)
                    .arg(command);
            const Outcome outcome = run_here("unshare", {"-rm", "sh", "-c", script});
            QCOMPARE(outcome.out, "5\nold\n0\n0\n" + table_);
            QVERIFY2(file("err").contains("No space left on device"), file("err"));
        }
    }
};

VYBEG_TEST(TestCliBatchResume, first, unsanitized)

}  // namespace test_cli_batch_resume

#include "test_cli_batch_resume.moc"
