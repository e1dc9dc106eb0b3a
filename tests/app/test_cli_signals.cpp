// 30 signals, or as many as VYBEG_SIGNALS says, at moments spread over runs with one and two
// outputs: all outputs are new, or all are as they were, and the sentence says which. As many to
// sets that do not fit the model, whose fits take long: the program is gone within a second.
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <csignal>
#include <random>
#include <sys/resource.h>
#include <unistd.h>

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
        start(process, work.command.split(' '));
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

    static double ownMs(const QByteArray& stat) {
        const QList<QByteArray> fields = stat.mid(stat.lastIndexOf(')')).split(' ');
        return (fields.value(12).toDouble() + fields.value(13).toDouble() - 0.5) * 1000 /
               static_cast<double>(sysconf(_SC_CLK_TCK));
    }

    static double childrenMs() {
        rusage used{};
        getrusage(RUSAGE_CHILDREN, &used);
        const auto ms = [](const timeval& time) {
            return 1e3 * static_cast<double>(time.tv_sec) +
                   1e-3 * static_cast<double>(time.tv_usec);
        };
        return ms(used.ru_utime) + ms(used.ru_stime);
    }

    // From the signal to the end of the program, less the time that a busy machine gave to others:
    // the program's own processor time where that is less. 0 where it had ended before.
    double timeToLeave(const QString& work, int signal, int after_ms, int& interrupted) {
        QFile::remove(path("o.json"));
        QFile::remove(path("o.csv"));
        const double children_ms = childrenMs();
        QProcess process;
        start(process, work.split(' '));
        if (process.waitForFinished(after_ms)) {
            return 0;
        }
        const double own_ms = ownMs(content(QString("/proc/%1/stat").arg(process.processId())));
        QElapsedTimer timer;
        timer.start();
        kill(static_cast<pid_t>(process.processId()), signal);
        const bool ended = process.waitForFinished(60000);
        const double took_ms =
            std::min(static_cast<double>(timer.elapsed()), childrenMs() - children_ms - own_ms);
        if (!ended) {
            process.kill();
            process.waitForFinished();
        }
        // Before main() the program ends by the signal itself; at its end all is written.
        const bool done = ended && process.exitStatus() == QProcess::NormalExit;
        [&] {
            QVERIFY2(ended, qPrintable(work));
            if (done && process.exitCode() != 0) {
                ++interrupted;
                VYBEG_EQUAL(process.exitCode(), 130, process.readAllStandardError());
                // A batch keeps the rows of the sets that it has finished.
                QVERIFY(work.startsWith("batch") || !QFile::exists(path("o.json")));
            }
            QCOMPARE(temporaries(), QStringList());
        }();
        return took_ms;
    }

    void simulate(const QString& name, const QString& options) {
        const Outcome outcome =
            run("simulate --noise 1e-3 --rate 20000 " + options + " -o " + name);
        VYBEG_EQUAL(outcome.status, 0, outcome.err);
    }

    // The first half of a recording and the second of another: a knock in between.
    void join(const QString& first, const QString& second, const QString& name) {
        QByteArray bytes = file(first);
        const QByteArray other = file(second);
        QCOMPARE(bytes.size(), other.size());
        const qsizetype frames = bytes.size() / 32;
        bytes.replace(bytes.size() - 16 * frames, 16 * frames, other.last(16 * frames));
        QVERIFY(put(path(name), bytes));
    }

    void makeMisfits() {
        QByteArray list = "set,file\n";
        for (int k = 1; k <= 3; ++k) {
            const QString common =
                QString("--tau 30 --split 0.05 --two-theta-A %1 --seed %2").arg(0.9 * k).arg(k);
            const QString number = QString::number(k) + ".wav";
            simulate("g" + number, "--seconds 6 " + common);
            simulate("s" + number,
                     "--seconds 6 --settling 1 --settling-time 2 --phase-noise 1e-6 " + common);
            list += QString("g,g%1\ns,s%1\n").arg(number).toUtf8();
        }
        simulate("foreign.wav",
                 "--seconds 6 --f0 5303 --tau 60 --split 0.4 --two-theta-A 1.2 --seed 4");
        join("g1.wav", "g2.wav", "k1.wav");
        join("g2.wav", "g3.wav", "k2.wav");
        QVERIFY(put(path("misfits.csv"), list + "g,foreign.wav\n"));
    }

private slots:
    void signals_at_any_moment_leave_all_outputs_old_or_all_new() {
        QCOMPARE(run("simulate --demo --seconds 2 -o a.wav").status, 0);
        QCOMPARE(run("simulate --demo --seconds 2 --two-theta-A 1.2 -o b.wav").status, 0);
        std::array works{
            Work{"analyze a.wav -o track.csv --hop 10 --quiet", {"track.csv"}},
            Work{"identify a.wav b.wav -o result.json --passport passport.json --quiet",
                 {"result.json", "passport.json"}},
            Work{"simulate --demo --seconds 1 --window 5 -o decay.csv --truth truth.csv",
                 {"decay.csv", "truth.csv"}}};
        for (Work& work : works) {
            QElapsedTimer timer;
            timer.start();
            QCOMPARE(run(work.command).status, 0);
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

    void a_set_that_does_not_fit_is_left_within_a_second() {
        makeMisfits();
        if (QTest::currentTestFailed()) {
            return;
        }
        const std::array<QString, 4> works{
            "identify g1.wav g2.wav g3.wav foreign.wav -o o.json --threads 1 --quiet",
            "identify k1.wav k2.wav g3.wav -o o.json --threads 1 --quiet",
            "identify s1.wav s2.wav s3.wav -o o.json --threads 1 --quiet",
            "batch misfits.csv -o o.csv --threads 1 --quiet"};
        bool given = false;
        const int wanted = qEnvironmentVariableIntValue("VYBEG_SIGNALS", &given);
        const int sent = given ? wanted : 30;
        const int longest_ms = 4000;  // of a run that would go on
        std::mt19937_64 random(24);
        std::uniform_int_distribution<int> any_ms(20, longest_ms);
        int interrupted = 0;
        for (int k = 0; k < sent; ++k) {
            const QString& work = works[static_cast<std::size_t>(k) % works.size()];
            const int after_ms = any_ms(random);
            const int signal = k % 2 == 0 ? SIGINT : SIGTERM;
            const double took_ms = timeToLeave(work, signal, after_ms, interrupted);
            if (QTest::currentTestFailed()) {
                return;
            }
            VYBEG_LESS(took_ms, 1000,
                       qPrintable(QString("%1, after %2 ms").arg(work).arg(after_ms)));
        }
        VYBEG_AT_LEAST(interrupted, sent / 3, "too few signals met a run at work");
    }

    void what_has_gone_out_to_a_pipe_is_not_called_nothing() {
        QProcess process;
        start(process, {"simulate", "--demo", "--seconds", "3000", "-o", "-"});
        QVERIFY(process.waitForReadyRead(20000));
        kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(20000));
        QCOMPARE(process.exitCode(), 130);
        QCOMPARE(process.readAllStandardError(),
                 QByteArray("vybeg-cli: Interrupted; what has gone out to standard output is "
                            "incomplete.\n"));
    }

    void leftovers_of_a_killed_run_are_removed_by_the_next_and_those_at_work_stay() {
        const QStringList work = words("simulate --demo --seconds 3000 -o long.mat");
        QProcess killed;
        start(killed, work);
        QTRY_COMPARE_WITH_TIMEOUT(temporaries().size(), 1, 10000);
        const QStringList abandoned = temporaries();
        killed.kill();
        QVERIFY(killed.waitForFinished(20000));
        QCOMPARE(temporaries(), abandoned);

        QProcess at_work;
        start(at_work, work);
        QTRY_VERIFY_WITH_TIMEOUT(temporaries().size() == 1 && temporaries() != abandoned, 10000);
        const QStringList used = temporaries();
        QCOMPARE(run("simulate --seconds 0.01 -o short.csv").status, 0);
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
        QCOMPARE(run("simulate --seconds 0.01 -o short.csv").status, 0);
        QCOMPARE(temporaries(), QStringList{".vybeg-notes.part"});
        QVERIFY(QFile::remove(path(".vybeg-notes.part")));
    }
};

VYBEG_TEST(TestCliSignals, first, unsanitized)

}  // namespace test_cli_signals

#include "test_cli_signals.moc"
