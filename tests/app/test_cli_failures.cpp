// Everything that can go wrong has its own sentence and its exit status, and nothing is left
// behind.
#include "tests/app/cli_run.h"
#include "tests/app/track_table.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <unistd.h>

namespace test_cli_failures {

using namespace vybeg::test;

namespace {

QByteArray table(int rows, const QByteArray& header, const std::function<QByteArray(int)>& row) {
    QByteArray text = header + "\n";
    for (int k = 0; k < rows; ++k) {
        text += row(k) + "\n";
    }
    return text;
}

QByteArray number(double value) {
    return QByteArray::number(value, 'g', 17);
}

QByteArray wave(int k, double phase) {
    return number(std::cos(k - phase));
}

QByteArray timed(int k) {
    return number(k / 33333.0) + "," + wave(k, 0) + "," + wave(k, 0.1);
}

}  // namespace

class TestCliFailures : public QObject, private CliFolder {
    Q_OBJECT

private:
    QMap<QString, QByteArray> sentences_;  // of the rows so far

    // The one sentence of a failure, different from all others so far.
    void check_sentence(const Outcome& outcome) {
        QCOMPARE(outcome.err_lines().size(), 1);
        const QByteArray sentence = outcome.err_lines()[0];
        QVERIFY2(sentence.startsWith("vybeg-cli: "), sentence.constData());
        QVERIFY2(sentence.endsWith('.'), sentence.constData());
        // Without the file's name: the reason itself has to differ.
        QByteArray reason = sentence;
        for (const QString& name : QDir(folder_.path()).entryList()) {
            reason.replace(name.toUtf8(), "");
        }
        for (auto other = sentences_.cbegin(); other != sentences_.cend(); ++other) {
            QVERIFY2(other.value() != reason, qPrintable(other.key() + ": " + reason));
        }
        sentences_.insert(QTest::currentDataTag(), reason);
    }

private slots:
    void initTestCase() {
        QVERIFY(put(path("empty.csv"), ""));
        QVERIFY(put(path("words.txt"), "Dear colleague,\n\nthe recording follows.\n"));
        QVERIFY(put(path("text.csv"), table(100, "t,C,D", [](int k) {
                        return k == 50 ? QByteArray("0.0015,broken,1") : timed(k);
                    })));
        QVERIFY(put(path("one.csv"), table(100, "t,C", [](int k) {
                        return number(k / 33333.0) + "," + wave(k, 0);
                    })));
        QVERIFY(put(path("nan.csv"), table(3000, "t,C,D", [](int k) {
                        return k < 600 || k >= 660 ? timed(k)
                                                   : number(k / 33333.0) + ",nan," + wave(k, 0.1);
                    })));
        QVERIFY(put(path("three.csv"), table(3, "t,C,D", timed)));
        QVERIFY(put(path("backwards.csv"),
                    table(100, "t,C,D", [](int k) { return timed(k == 70 ? 60 : k); })));
        QVERIFY(put(path("no-rate.csv"),
                    table(1000, "C,D", [](int k) { return wave(k, 0) + "," + wave(k, 0.1); })));
        QVERIFY(put(path("locked.csv"), table(1000, "t,C,D", timed)));
        QVERIFY(put(path("old.csv"), "old"));
        QCOMPARE(run("simulate --demo --seconds 2 -o good.wav").status, 0);
        QVERIFY(QFile::copy(path("good.wav"), path("early.wav")));
        QVERIFY(QFile::resize(path("early.wav"), 500001));
    }

    void a_failure_has_its_own_sentence_and_status_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* name, const QString& arguments, int status,
                            const QString& part) {
            QTest::newRow(name) << arguments.split(' ') << status << part;
        };
        row("empty file", "analyze empty.csv -o x.csv", 3, "empty");
        row("no table", "analyze words.txt -o x.csv", 3, "");
        row("text for a number", "analyze text.csv -o x.csv", 3, "line 52, column 2: \"broken\"");
        row("one channel", "analyze one.csv -o x.csv", 3, "1 channel");
        row("three samples", "analyze three.csv -o x.csv", 3, "3 sample");
        row("time backwards", "analyze backwards.csv -o x.csv", 3, "line 72");
        row("unknown rate", "analyze no-rate.csv -o x.csv", 3, "--rate");
        row("missing file", "analyze missing.wav -o x.csv", 3, "no such file");
        row("folder", "analyze . -o x.csv", 3, "folder");
        row("no such channel", "analyze good.wav -o x.csv --channels 1,3", 3, "channel 3");
        row("long window", "analyze good.wav -o x.csv --window 66667", 4, "66667 samples");
        row("short window", "analyze good.wav -o x.csv --window 5 --f0 1000", 4, "at least 25");
        row("carrier above half", "analyze good.wav -o x.csv --f0 20000", 4, "16666.5 Hz");
        row("empty range", "analyze good.wav -o x.csv --from 5 --to 6", 4, "between 5 s and 6 s");
        row("band above half", "analyze good.wav -o x.csv --band 20000,30000", 4, "20000 Hz");
        row("impossible decay", "simulate -o x.csv --rate 9000", 4, "4500 Hz");
        row("full device", "analyze good.wav -o /dev/full", 5, "No space left on device");
        row("folder as output", "analyze good.wav -o .", 5, "Is a directory");
        row("no folder for output", "analyze good.wav -o none/x.csv", 5, "No such file");
        row("unknown ending", "simulate -o x.flac", 5, ".flac");
        row("unknown option", "analyze good.wav -o x.csv --colour", 2, "--colour");
        row("text as window", "analyze good.wav -o x.csv --window wide", 2, "\"wide\"");
        row("comma in a number", "analyze good.wav -o x.csv --f0 5300,5", 2, "\"5300,5\"");
        row("window of two", "analyze good.wav -o x.csv --window 2", 2, "5 samples");
        row("hop of zero", "analyze good.wav -o x.csv --hop 0", 2, "--hop");
        row("unknown algorithm", "analyze good.wav -o x.csv --algorithm fft", 2, "\"fft\"");
        row("four start values", "analyze good.wav -o x.csv --initial 1,2,3,4", 2, "five numbers");
        row("channels as a word", "analyze good.wav -o x.csv --channels both", 2, "\"both\"");
        row("four variables", "analyze good.wav -o x.csv --variables a,b,c,d", 2, "three names");
        row("no variable", "analyze good.wav -o x.csv --variables ,b", 2, "three names");
        row("skip without raw", "analyze good.wav -o x.csv --skip 44", 2, "needs --raw");
        row("no value", "analyze good.wav -o x.csv --rate", 2, "--rate needs a value");
        row("two lengths", "analyze good.wav -o x.csv --window 60 --periods 10", 2, "excludes");
        row("no output", "analyze good.wav", 2, "--output");
        row("no input", "analyze -o x.csv", 2, "FILE");
        row("no command", "--quiet", 2, "subcommand");
        row("unknown command", "draw good.wav", 2, "\"draw\"");
        row("onto itself", "analyze good.wav -o ./good.wav", 2, "recording itself");
        row("truth onto samples", "simulate -o x.csv --truth x.csv", 2, "--truth");
        row("33 bits", "simulate -o x.csv --bits 33", 2, "\"33\"");
        row("negative seed", "simulate -o x.csv --seed -1", 2, "--seed");
    }

    void a_failure_has_its_own_sentence_and_status() {
        QFile::remove(path("x.csv"));  // of a row that should have failed
        QFETCH(QStringList, arguments);
        QFETCH(int, status);
        QFETCH(QString, part);
        const QByteArray recording = file("good.wav");
        const Outcome outcome = run(arguments);
        QVERIFY2(outcome.err.contains(part.toUtf8()), outcome.err);
        QCOMPARE(outcome.status, status);
        QCOMPARE(outcome.out, QByteArray());
        check_sentence(outcome);
        QVERIFY(!QFile::exists(path("x.csv")));
        QVERIFY(file("good.wav") == recording);
        QCOMPARE(temporaries(), QStringList());
    }

    void a_file_without_permission_is_refused() {
        QVERIFY(QFile::setPermissions(path("locked.csv"), {}));
        QStringList command{VYBEG_CLI, "analyze", "locked.csv", "-o", "x.csv"};
        if (geteuid() == 0) {
            // The superuser may read everything: a copy of the program runs as nobody instead.
            const QString copy = path("vybeg-cli");
            QVERIFY(QFile::copy(VYBEG_CLI, copy));
            QVERIFY(QFile::setPermissions(copy, QFile::Permissions(0x5555)));
            QVERIFY(QFile::setPermissions(folder_.path(), QFile::Permissions(0x7755)));
            command[0] = copy;
            command = words("setpriv --reuid=65534 --regid=65534 --clear-groups") + command;
        }
        const Outcome outcome = run_here(command[0], command.mid(1));
        QCOMPARE(outcome.status, 3);
        QVERIFY2(outcome.err.contains("no permission"), outcome.err);
        check_sentence(outcome);
    }

    void missing_samples_are_a_warning_and_flagged_rows() {
        const Outcome outcome = run("analyze nan.csv -o nan-track.csv");
        QCOMPARE(outcome.status, 0);
        QCOMPARE(outcome.err_lines().size(), 1);
        QVERIFY(outcome.err.startsWith("vybeg-cli: warning: 60 samples"));
        const TrackTable track(file("nan-track.csv"));
        QCOMPARE(track.rows(), qsizetype{50});
        for (qsizetype row = 0; row < track.rows(); ++row) {
            const bool gap = row == 10;  // samples 600 to 659
            QCOMPARE(track.text(row, "flag"), QByteArray(gap ? "gap" : ""));
            for (const char* column : {"a_A", "a_B", "two_theta_A_rad", "alpha_rad", "f_Hz",
                                       "delta_phi_CD_rad", "rms", "sd_a_A", "sd_f_Hz"}) {
                QCOMPARE(track.text(row, column) == "nan", gap);
            }
        }
    }

    void a_file_that_ends_early_is_a_warning() {
        const Outcome outcome = run("analyze early.wav -o early.csv");
        QCOMPARE(outcome.status, 0);
        QCOMPARE(outcome.err_lines().size(), 1);
        QVERIFY2(outcome.err.startsWith("vybeg-cli: warning: The file ends early"), outcome.err);
        const qsizetype frames = (500001 - 44) / 16;
        const qsizetype rows = TrackTable(file("early.csv")).rows();
        VYBEG_AT_LEAST(rows, frames / 60 - 2);
        VYBEG_AT_MOST(rows, frames / 60);
    }

    void a_disk_that_fills_leaves_the_old_file_data() {
        QTest::addColumn<QString>("command");
        QTest::newRow("track") << "analyze good.wav -o old.csv";
        QTest::newRow("csv") << "simulate --demo --seconds 1 -o old.csv";
        QTest::newRow("wav") << "simulate --demo --seconds 1 -o old.wav";
        QTest::newRow("mat") << "simulate --demo --seconds 1 -o old.mat";
        QTest::newRow("truth") << "simulate --demo --seconds 0.01 -o small.wav --window 5 --truth "
                                  "old.csv";
    }

    void a_disk_that_fills_leaves_the_old_file() {
        QFETCH(QString, command);
        for (const char* name : {"old.csv", "old.wav", "old.mat", "small.wav"}) {
            QVERIFY(put(path(name), "old"));
        }
        // No file of this process may grow beyond 8 blocks: write() fails in the middle.
        const Outcome outcome =
            run_here("sh", {"-c", "ulimit -f 8; exec " + QString(VYBEG_CLI) + " " + command});
        QCOMPARE(outcome.status, 5);
        QVERIFY2(outcome.err.contains("cannot be written"), outcome.err);
        QCOMPARE(outcome.err_lines().size(), 1);
        for (const char* name : {"old.csv", "old.wav", "old.mat", "small.wav"}) {
            QCOMPARE(file(name), QByteArray("old"));
        }
        QCOMPARE(temporaries(), QStringList());
    }

    void a_broken_pipe_is_an_error_of_the_output() {
        const Outcome outcome = run_here(
            "bash",
            {"-c", QString(VYBEG_CLI) + " simulate --demo -o - | head -1; exit ${PIPESTATUS[0]}"});
        QCOMPARE(outcome.status, 5);
        QCOMPARE(outcome.out, QByteArray("t_s,C,D\n"));
        QVERIFY(outcome.err.contains("standard output cannot be written"));
    }
};

VYBEG_TEST(TestCliFailures)

}  // namespace test_cli_failures

#include "test_cli_failures.moc"
