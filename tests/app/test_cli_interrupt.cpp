// Ctrl-C and its relatives: exit status 130 within 0.2 s, the old file as it was, nothing left.
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <csignal>

namespace test_cli_interrupt {

using namespace vybeg::test;

class TestCliInterrupt : public QObject, private CliFolder {
    Q_OBJECT

private slots:
    void initTestCase() { QCOMPARE(run("simulate --demo --seconds 112 -o long.wav").status, 0); }

    void a_signal_ends_a_long_run_at_once_and_cleanly_data() {
        QTest::addColumn<QString>("command");
        QTest::addColumn<QString>("target");
        QTest::addColumn<int>("signal");
        const QString analyze =
            "analyze long.wav -o old.csv --f0 5300 --hop 1 --algorithm conjugate-gradient";
        const QString simulate = "simulate --demo --seconds 3000 -o old.mat";
        QTest::newRow("SIGINT, analyze") << analyze << "old.csv" << SIGINT;
        for (const char* target : {"old.mat", "old.h5", "old.npz"}) {
            QTest::newRow(target) << QString(analyze).replace("old.csv", target) << target
                                  << SIGINT;
        }
        QTest::newRow("SIGTERM, analyze") << analyze << "old.csv" << SIGTERM;
        QTest::newRow("SIGHUP, analyze") << analyze << "old.csv" << SIGHUP;
        QTest::newRow("SIGINT, simulate") << simulate << "old.mat" << SIGINT;
    }

    void a_signal_ends_a_long_run_at_once_and_cleanly() {
        QFETCH(QString, command);
        QFETCH(QString, target);
        QFETCH(int, signal);
        std::array<qint64, 5> elapsed{};  // at five moments of the run
        for (std::size_t i = 0; i < elapsed.size(); ++i) {
            QVERIFY(put(path(target), "old"));
            QProcess process;
            start(process, command.split(' '));
            QTRY_COMPARE_WITH_TIMEOUT(temporaries().size(), 1, 10000);
            QTest::qWait(static_cast<int>(100 + 130 * i));  // the moment of the run
            QCOMPARE(process.state(), QProcess::Running);
            QElapsedTimer timer;
            timer.start();
            QCOMPARE(kill(static_cast<pid_t>(process.processId()), signal), 0);
            QVERIFY(process.waitForFinished(20000));
            elapsed[i] = timer.elapsed();
            QCOMPARE(process.exitStatus(), QProcess::NormalExit);
            QCOMPARE(process.exitCode(), 130);
            QCOMPARE(process.readAllStandardError(),
                     QByteArray("vybeg-cli: Interrupted; nothing was written.\n"));
            QCOMPARE(file(target), QByteArray("old"));
            QCOMPARE(temporaries(), QStringList());
        }
        // The median, so that one moment at which a busy machine gave no time does not count.
        std::ranges::sort(elapsed);
        VYBEG_LESS(elapsed[2], 200);
    }
};

VYBEG_TEST(TestCliInterrupt)

}  // namespace test_cli_interrupt

#include "test_cli_interrupt.moc"
