// 30 signals, or as many as VYBEG_SIGNALS says, at moments spread over runs with one and two
// outputs: all outputs are new, or all are as they were, and the sentence says which.
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <csignal>

namespace test_cli_signals {

using namespace vybeg::test;

namespace {

struct Work {
    QString command;
    QStringList outputs;
    qint64 undisturbed_ms = 0;
};

}  // namespace

class TestCliSignals : public QObject, private CliFolder {
    Q_OBJECT

    int interrupted_ = 0;
    int finished_ = 0;
    int before_main_ = 0;

    void disturb(const Work& work, int signal, int after_us) {
        for (const QString& output : work.outputs) {
            QVERIFY(put(path(output), "old"));
        }
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(VYBEG_CLI, work.command.split(' '));
        QVERIFY(process.waitForStarted());
        QTest::qSleep(after_us / 1000);  // the moment of the run
        kill(static_cast<pid_t>(process.processId()), signal);
        QVERIFY(process.waitForFinished(30000));
        const QByteArray err = process.readAllStandardError();
        const bool killed = process.exitStatus() == QProcess::CrashExit;
        // Before main() nothing waits for signals yet: the program ends by them.
        before_main_ += killed ? 1 : 0;
        const bool done = !killed && process.exitCode() == 0;
        finished_ += done ? 1 : 0;
        if (!done && !killed) {
            ++interrupted_;
            VYBEG_EQUAL(process.exitCode(), 130, err);
            QCOMPARE(err, QByteArray("vybeg-cli: Interrupted; nothing was written.\n"));
        }
        for (const QString& output : work.outputs) {
            QVERIFY2((file(output) == "old") == !done,
                     qPrintable(QString("%1 after %2 us, status %3: %4 bytes; %5")
                                    .arg(output)
                                    .arg(after_us)
                                    .arg(process.exitCode())
                                    .arg(file(output).size())
                                    .arg(QString::fromUtf8(err))));
        }
        QCOMPARE(temporaries(), QStringList());
    }

private slots:
    void signals_at_any_moment_leave_all_outputs_old_or_all_new() {
        QCOMPARE(run({"simulate", "--demo", "--seconds", "2", "-o", "a.wav"}).status, 0);
        QCOMPARE(
            run({"simulate", "--demo", "--seconds", "2", "--two-theta-A", "1.2", "-o", "b.wav"})
                .status,
            0);
        std::array works{
            Work{"analyze a.wav -o track.csv --hop 10 --quiet", {"track.csv"}},
            Work{"identify a.wav b.wav -o result.json --passport passport.json --quiet",
                 {"result.json", "passport.json"}},
            Work{"simulate --demo --seconds 1 --window 5 -o decay.csv --truth truth.csv",
                 {"decay.csv", "truth.csv"}}};
        for (Work& work : works) {
            QElapsedTimer timer;
            timer.start();
            QCOMPARE(run(work.command.split(' ')).status, 0);
            work.undisturbed_ms = timer.elapsed();
        }
        bool given = false;
        const int wanted = qEnvironmentVariableIntValue("VYBEG_SIGNALS", &given);
        const std::size_t sent = given ? static_cast<std::size_t>(wanted) : 30;
        const std::size_t moments = sent / works.size();  // of each work
        const std::array kinds{SIGINT, SIGTERM, SIGHUP};
        for (std::size_t k = 0; k < sent; ++k) {
            const Work& work = works[k % works.size()];
            const std::size_t moment = k / works.size();
            const double share = (static_cast<double>(moment) + 0.5) / static_cast<double>(moments);
            disturb(work, kinds[moment % kinds.size()],
                    static_cast<int>(1100 * share * static_cast<double>(work.undisturbed_ms)));
            if (QTest::currentTestFailed()) {
                return;
            }
        }
        qInfo("%d interrupted, %d finished, %d ended before main()", interrupted_, finished_,
              before_main_);
        VYBEG_AT_LEAST(interrupted_, static_cast<int>(sent / 6),
                       "too few signals met a run at work for the test to mean much");
    }

    void what_has_gone_out_to_a_pipe_is_not_called_nothing() {
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(VYBEG_CLI, {"simulate", "--demo", "--seconds", "3000", "-o", "-"});
        QVERIFY(process.waitForReadyRead(20000));
        kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(20000));
        QCOMPARE(process.exitCode(), 130);
        QCOMPARE(process.readAllStandardError(),
                 QByteArray("vybeg-cli: Interrupted; what has gone out to standard output is "
                            "incomplete.\n"));
    }

    void leftovers_of_a_killed_run_are_removed_by_the_next_and_those_at_work_stay() {
        const QStringList work{"simulate", "--demo", "--seconds", "3000", "-o", "long.mat"};
        QProcess killed;
        killed.setWorkingDirectory(folder_.path());
        killed.start(VYBEG_CLI, work);
        QTRY_COMPARE_WITH_TIMEOUT(temporaries().size(), 1, 10000);
        const QStringList abandoned = temporaries();
        killed.kill();
        QVERIFY(killed.waitForFinished(20000));
        QCOMPARE(temporaries(), abandoned);

        QProcess at_work;
        at_work.setWorkingDirectory(folder_.path());
        at_work.start(VYBEG_CLI, work);
        QTRY_VERIFY_WITH_TIMEOUT(temporaries().size() == 1 && temporaries() != abandoned, 10000);
        const QStringList used = temporaries();
        QCOMPARE(run({"simulate", "--seconds", "0.01", "-o", "short.csv"}).status, 0);
        QCOMPARE(temporaries(), used);
        at_work.terminate();
        QVERIFY(at_work.waitForFinished(20000));
        QCOMPARE(at_work.exitCode(), 130);
        QCOMPARE(temporaries(), QStringList());
    }

    void a_process_number_that_is_used_again_keeps_no_leftover() {
        // Number 1 lives, and began at another time.
        QVERIFY(put(path(".vybeg-1-999999999999-0.part"), "half"));
        QVERIFY(put(path(".vybeg-notes.part"), "not ours"));
        QCOMPARE(run({"simulate", "--seconds", "0.01", "-o", "short.csv"}).status, 0);
        QCOMPARE(temporaries(), QStringList{".vybeg-notes.part"});
        QVERIFY(QFile::remove(path(".vybeg-notes.part")));
    }
};

VYBEG_TEST(TestCliSignals, unsanitized)

}  // namespace test_cli_signals

#include "test_cli_signals.moc"
