// identify --list: a measurement list gives what the command line gives.
#include "tests/app/resonator_runs.h"
#include "tests/test_registry.h"

#include <QtTest>

namespace test_cli_list {

using namespace vybeg::test;

class TestCliList : public QObject, private CliFolder {
    Q_OBJECT

    QByteArray result(const QStringList& arguments) const {
        const Outcome outcome = run("identify -o -", arguments);
        return outcome.status == 0 ? outcome.out : "failed: " + outcome.err;
    }

private slots:
    void initTestCase() {
        for (const auto& [name, start] : {std::pair{"a.wav", "0"}, std::pair{"b.wav", "0.7854"}}) {
            QCOMPARE(run({"simulate", "--seconds", "2", "--noise", "0.001", "--tau", "400",
                          "--split", "1e-3", "--two-theta-A", start, "-o", name})
                         .status,
                     0);
        }
        QCOMPARE(run("simulate --seconds 2 --noise 0.001 -o c.csv").status, 0);
        QVERIFY(QDir(folder_.path()).mkdir("lists"));
        QVERIFY(put(path("lists/two.csv"), "set;file\nA;../a.wav\nB;../b.wav\nA;../b.wav\n"));
    }

    void a_column_does_what_the_option_does_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("names");
        QTest::addColumn<QByteArray>("values");
        const auto row = [](const QString& options, const QByteArray& names,
                            const QByteArray& values) {
            QTest::newRow(qPrintable(options))
                << options.split(' ', Qt::SkipEmptyParts) << names << values;
        };
        row("", "", "");
        row("--from 0.5 --to 1.5", "from;to", "0,5;1.5");
        row("--filter 5000,5600", "filter", "5000,5600");
        row("--channels 2,1", "channels", "2,1");
        row("--kappa 1.1 --delay 1e-7 --offset auto --angle-zero 7",
            "kappa;delay;offset;angle-zero", "1,1;1e-7;auto;7");
        row("--f0 5300", "f0", "5300");
        row("--model free", "model", "free");
        row("--window 600 --snap", "window;snap", "600;yes");
        row("--periods 80.5", "periods", "80,5");
        row("--tolerance skew=0.1deg,delay=10ns", "tolerance", "\"skew=0,1deg;delay=10ns\"");
    }

    void a_column_does_what_the_option_does() {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, names);
        QFETCH(QByteArray, values);
        QVERIFY(put(path("list.csv"),
                    "set;file;" + names + "\nA;a.wav;" + values + "\nA;b.wav;" + values + "\n"));
        const QByteArray by_line = result(QStringList{"a.wav", "b.wav"} + options);
        QVERIFY2(by_line.startsWith('{'), by_line);
        QCOMPARE(result({"--list", "list.csv", "--set", "A"}), by_line);
        if (!options.isEmpty()) {
            QVERIFY(by_line != result({"a.wav", "b.wav"}));
        }
    }

    void so_does_one_that_says_how_a_file_is_read() {
        QVERIFY(put(path("list.csv"), "file,rate,time-column,scale\nc.csv,1000,none,3\n"));
        const QStringList options =
            words("--rate 1000 --time-column none --scale 3 --channels 2,3");
        const QByteArray by_line = result(QStringList{"c.csv"} + options);
        QVERIFY2(by_line.startsWith('{'), by_line);
        QCOMPARE(result({"--list", "list.csv", "--channels", "2,3"}), by_line);
    }

    void each_recording_of_a_set_may_have_its_range() {
        QVERIFY(put(path("list.csv"), "set,file,from\nA,a.wav,0.5\nA,b.wav,\n"));
        const QJsonObject both = object(result({"--list", "list.csv"}));
        QCOMPARE(both["settings"]["from"].toString(), QString("0.5; none"));
        const QJsonObject first = object(result({"a.wav", "--from", "0.5"}));
        const QJsonObject second = object(result({"b.wav"}));
        QCOMPARE(both["runs"][0]["wave"], first["runs"][0]["wave"]);
        QCOMPARE(both["runs"][0]["windows"], first["runs"][0]["windows"]);
        QCOMPARE(both["runs"][1]["wave"], second["runs"][0]["wave"]);
        QVERIFY(both["runs"][1]["windows"] != both["runs"][0]["windows"]);
    }

    void files_are_relative_to_the_list_and_sets_in_its_order() {
        const QByteArray by_line = result({"a.wav", "b.wav"});
        QCOMPARE(result({"--list", "lists/two.csv", "--set", "A"}), by_line);
        QCOMPARE(result({"--list", path("lists/two.csv"), "--set", "B"}), result({"b.wav"}));
    }

    void an_option_of_analyze_alone_is_warned_of() {
        QVERIFY(put(path("list.csv"), "file,hop\na.wav,10\n"));
        const Outcome outcome = run("identify --list list.csv -o x.json");
        QCOMPARE(outcome.status, 0);
        QVERIFY2(outcome.err.contains("--hop has no effect: an identification does not use it"),
                 outcome.err);
    }

    void a_failure_has_its_status_and_one_sentence_data() {
        QTest::addColumn<QByteArray>("list");
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* name, const QByteArray& list, const QString& arguments,
                            int status, const QString& part) {
            QTest::newRow(name) << list << arguments << status << part;
        };
        const QByteArray good = "set,file\nA,a.wav\nB,b.wav\n";
        row("neither list nor file", good, "", 2, "FILE or --list is required");
        row("both", good, "a.wav --list list.csv", 2, "excludes");
        row("a set without a list", good, "a.wav --set A", 2, "--set requires --list");
        row("several sets", good, "--list list.csv", 2, "Choose one by --set: A, B.");
        row("no such set", good, "--list list.csv --set C", 2, "--set cannot be \"C\"");
        row("a wrong option", good, "--list list.csv --set A --channels 1,1", 2,
            "--channels cannot be \"1,1\"");
        row("no list", good, "--list none.csv --set A", 3, "none.csv: there is no such file");
        row("another file", good, "--list a.wav --set A", 3, "the file holds no text");
        row("a wrong value", "file,from\na.wav,1\nb.wav,x\n", "--list list.csv --set A", 3,
            "list.csv, line 3, column \"from\": \"x\" is not possible");
        row("no recording", "file\nnone.wav\n", "--list list.csv", 3, "none.wav: there is no such");
        row("other bias", "set,file,bias_v\nA,a.wav,90\nA,b.wav,95\n", "--list list.csv", 4,
            "differ in the bias voltage (90 V and 95 V)");
        row("result over the list", good, "--list list.csv --set A -o list.csv", 2,
            "it is the list");
        row("result over a recording", good, "--list list.csv --set A -o a.wav", 2,
            "it is one of the recordings");
    }

    void a_failure_has_its_status_and_one_sentence() {
        QFETCH(QByteArray, list);
        QFETCH(QString, arguments);
        QFETCH(int, status);
        QFETCH(QString, part);
        QVERIFY(put(path("list.csv"), list));
        const Outcome outcome = run("identify", arguments.split(' ', Qt::SkipEmptyParts));
        QCOMPARE(outcome.status, status);
        QCOMPARE(outcome.err_lines().size(), 1);
        QVERIFY2(outcome.err.contains(part.toUtf8()), outcome.err);
        QCOMPARE(file("list.csv"), list);
        QCOMPARE(temporaries(), QStringList());
    }
};

VYBEG_TEST(TestCliList)

}  // namespace test_cli_list

#include "test_cli_list.moc"
