// Outputs that would replace something, standard descriptors that are not there, readers that end
// early, and recordings that change while they are read.
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <csignal>
#include <unistd.h>

namespace test_cli_outputs {

using namespace vybeg::test;

class TestCliOutputs : public QObject, private CliFolder {
    Q_OBJECT

private slots:
    void initTestCase() {
        QCOMPARE(run("simulate --demo --seconds 2 -o a.wav").status, 0);
        QCOMPARE(run("simulate --demo --seconds 2 --two-theta-A 1.2 -o b.wav").status, 0);
        QCOMPARE(run("identify a.wav b.wav --passport passport.json").status, 0);
        QVERIFY(QDir(folder_.path()).mkdir("sub"));
        QVERIFY(QFile::link(path("a.wav"), path("soft.csv")));
        QCOMPARE(::link(qPrintable(path("a.wav")), qPrintable(path("hard.csv"))), 0);
        QVERIFY(QFile::link(path("passport.json"), path("soft.json")));
        QVERIFY(QFile::link(folder_.path(), path("sub/back")));
    }

    void an_output_replaces_neither_an_input_nor_another_output_data() {
        QTest::addColumn<QString>("command");
        QTest::addColumn<QString>("option");
        const auto row = [](const char* command, const char* option) {
            QTest::newRow(command) << command << option;
        };
        row("analyze a.wav -o a.wav", "-o");
        row("analyze a.wav -o sub/../a.wav", "-o");
        row("analyze a.wav -o soft.csv", "-o");
        row("analyze a.wav -o hard.csv", "-o");
        row("analyze a.wav -o sub/back/a.wav", "-o");
        row("analyze soft.csv -o a.wav", "-o");
        row("identify a.wav b.wav -o ./b.wav", "-o");
        row("identify a.wav b.wav --passport hard.csv", "--passport");
        row("identify a.wav b.wav -o p.json --passport p.json", "--passport");
        row("identify a.wav b.wav -o p.json --passport ./p.json", "--passport");
        row("identify a.wav b.wav -o p.json --passport sub/back/p.json", "--passport");
        row("identify a.wav b.wav -o passport.json --passport soft.json", "--passport");
        row("identify a.wav b.wav -o - --passport /dev/stdout", "--passport");
        row("compare passport.json a.wav b.wav -o soft.json", "-o");
        row("simulate --seconds 0.01 -o x.csv --truth ./x.csv", "--truth");
        row("simulate --seconds 0.01 -o x.csv --truth sub/../x.csv", "--truth");
        row("simulate --seconds 0.01 -o hard.csv --truth soft.csv", "--truth");
        row("simulate --seconds 0.1 --lock-in 4,30Hz,200 -o x.csv --truth x.phasors.csv",
            "--lock-in");
    }

    void an_output_replaces_neither_an_input_nor_another_output() {
        QFETCH(QString, command);
        QFETCH(QString, option);
        const QByteArray recording = file("a.wav");
        const QByteArray other = file("b.wav");
        const QByteArray passport = file("passport.json");
        const Outcome outcome = run(command);
        VYBEG_EQUAL(outcome.status, 2, outcome.err);
        QVERIFY2(outcome.err.startsWith("vybeg-cli: " + option.toUtf8() + " cannot be"),
                 outcome.err);
        QCOMPARE(outcome.err_lines().size(), 1);
        QVERIFY(file("a.wav") == recording);
        QVERIFY(file("b.wav") == other);
        QVERIFY(file("passport.json") == passport);
        QVERIFY(!QFile::exists(path("p.json")));
        QVERIFY(!QFile::exists(path("x.csv")));
    }

    void standard_output_that_is_the_recording_is_no_output() {
        QVERIFY(QFile::copy(path("a.wav"), path("appended.wav")));
        const Outcome outcome = run_here(
            "sh",
            {"-c", QString("exec %1 analyze appended.wav -o - >> appended.wav").arg(VYBEG_CLI)});
        QCOMPARE(outcome.status, 2);
        QVERIFY(file("appended.wav") == file("a.wav"));
    }

    void two_outputs_to_the_null_device_are_none() {
        const Outcome outcome = run("simulate --seconds 0.01 -o /dev/null --truth /dev/null");
        VYBEG_EQUAL(outcome.status, 5, outcome.err);  // of its ending
        QCOMPARE(run("identify a.wav b.wav -o /dev/null --passport /dev/null").status, 0);
    }

    void closed_standard_descriptors_put_nothing_into_the_outputs_data() {
        QTest::addColumn<QString>("closed");
        QTest::newRow("input") << "<&-";
        QTest::newRow("output") << ">&-";
        QTest::newRow("error") << "2>&-";
        QTest::newRow("all") << "<&- >&- 2>&-";
    }

    void closed_standard_descriptors_put_nothing_into_the_outputs() {
        QFETCH(QString, closed);
        // --rate has no effect here, which is warned of.
        const QString line = QString("exec %1 analyze a.wav -o track.csv --rate 1 --timing %2")
                                 .arg(VYBEG_CLI, closed);
        QCOMPARE(run("analyze a.wav -o usual.csv").status, 0);
        QFile::remove(path("track.csv"));
        QCOMPARE(run_here("sh", {"-c", line}).status, 0);
        QVERIFY(file("track.csv") == file("usual.csv"));
        const QString passport = QString("exec %1 identify a.wav b.wav -o result.json --rate 1 %2")
                                     .arg(VYBEG_CLI, closed);
        QCOMPARE(run_here("sh", {"-c", passport}).status, 0);
        QVERIFY(!object(file("result.json")).isEmpty());
    }

    void closed_standard_output_cannot_be_written() {
        for (const char* command : {"analyze a.wav -o -", "info a.wav", "identify a.wav b.wav"}) {
            const Outcome outcome =
                run_here("sh", {"-c", QString("exec %1 %2 >&-").arg(VYBEG_CLI, command)});
            VYBEG_EQUAL(outcome.status, 5, outcome.err);
            QVERIFY2(outcome.err.contains("standard output cannot be written"), outcome.err);
        }
    }

    void a_reader_that_ends_early_is_an_error_of_the_output_data() {
        QTest::addColumn<QString>("command");
        for (const char* command :
             {"analyze a.wav -o - --window 60", "info a.wav", "identify a.wav b.wav",
              "identify a.wav b.wav -o -", "simulate --demo -o -", "analyze --help"}) {
            QTest::newRow(command) << command;
        }
    }

    void a_reader_that_ends_early_is_an_error_of_the_output() {
        QFETCH(QString, command);
        // The reader has ended before the program begins.
        const QString line = QString(
                                 "mkfifo pipe && exec 3<> pipe && exec 4> pipe && exec 3>&- && "
                                 "exec %1 %2 >&4")
                                 .arg(VYBEG_CLI, command);
        const Outcome outcome = run_here("sh", {"-c", line});
        QVERIFY(QFile::remove(path("pipe")));
        VYBEG_EQUAL(outcome.status, 5, outcome.err);
        QVERIFY2(outcome.err.contains("standard output cannot be written: Broken pipe."),
                 outcome.err);
    }

    void a_recording_that_grows_while_it_is_read_is_an_error_data() {
        QTest::addColumn<QString>("command");
        QTest::newRow("analyze")
            << "analyze grows.wav -o old.csv --hop 10 --algorithm conjugate-gradient";
        QTest::newRow("identify") << "identify b.wav grows.wav -o old";
    }

    void a_recording_that_grows_while_it_is_read_is_an_error() {
        QFETCH(QString, command);
        QFile::remove(path("grows.wav"));
        QCOMPARE(run("simulate --demo --seconds 60 -o grows.wav").status, 0);
        const QString old = command.contains("identify") ? "old" : "old.csv";
        QVERIFY(put(path(old), "old"));
        QProcess process;
        start(process, command.split(' '));
        // The output is opened when the recording was, and long before its last sample is read.
        while (temporaries().isEmpty() && process.state() != QProcess::NotRunning) {
            process.waitForFinished(1);
        }
        QVERIFY(process.processId() > 0);  // 0 would be this program and its group
        kill(static_cast<pid_t>(process.processId()), SIGSTOP);
        QFile grows(path("grows.wav"));
        QVERIFY(grows.open(QIODevice::Append));
        QCOMPARE(grows.write("more"), 4);
        grows.close();
        kill(static_cast<pid_t>(process.processId()), SIGCONT);
        QVERIFY(process.waitForFinished(60000));
        const QByteArray err = process.readAllStandardError();
        VYBEG_EQUAL(process.exitCode(), 3, err);
        QVERIFY2(err.contains("grows.wav changed while it was read"), err);
        QCOMPARE(file(old), QByteArray("old"));
        QCOMPARE(temporaries(), QStringList());
    }
};

VYBEG_TEST(TestCliOutputs)

}  // namespace test_cli_outputs

#include "test_cli_outputs.moc"
