// How a text file is to be read, said on the command line: --delimiter and its companions.
#include "tests/app/cli_run.h"
#include "tests/app/track_table.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>

namespace test_cli_text_options {

using namespace vybeg::test;

class TestCliTextOptions : public QObject, private CliFolder {
    Q_OBJECT

private:
    // The rows of a decay of 1000 Hz at 20000 Hz, in mV, between bars, with decimal commas, the
    // time in ms at the end, behind two lines that look like rows.
    static QByteArray table() {
        QByteArray text = "1|2|3\n4|5|6\n";
        for (int k = 0; k < 4000; ++k) {
            const double phase = 2 * 3.14159265358979 * 0.05 * k;
            QByteArray row = QByteArray::number(500 * std::cos(phase - 0.4), 'f', 6) + "|" +
                             QByteArray::number(200 * std::cos(phase - 0.4), 'f', 6) + "|" +
                             QByteArray::number(0.05 * k, 'f', 2) + "\n";
            text += row.replace('.', ',');
        }
        return text;
    }

private slots:
    void initTestCase() {
        QVERIFY(put(path("board.txt"), table()));
        QVERIFY(put(path("plain.csv"), "C,D\n1,2\n3,4\n5,6\n7,8\n9,1\n"));
        QVERIFY(put(path("wave.wav"), "RIFF"));
    }

    void what_is_said_is_done_and_written_into_the_header() {
        const QString said =
            "--delimiter bar --decimal comma --skip-lines 2 --time-column 3 "
            "--time-unit ms --scale 0.001 --unit V";
        const Outcome outcome = run("analyze board.txt -o track.csv " + said);
        QCOMPARE(outcome.err, QByteArray());
        QCOMPARE(outcome.status, 0);
        const QByteArray track = file("track.csv");
        QVERIFY2(track.contains("\n# read with: " + said.toUtf8() + "\n"),
                 track.left(600).constData());
        QVERIFY(track.contains("\n# rate: 20000 (time column)\n"));
        const TrackTable table(track);
        VYBEG_MORE(table.rows(), 60);
        for (const double amplitude : table.column("a_A")) {
            // 500 mV and 200 mV in phase; rounded to 1e-6 mV.
            VYBEG_CLOSE(amplitude, std::hypot(0.5, 0.2), 1e-8);
        }
        const QJsonObject info = object(run("info --json board.txt " + said).out);
        QCOMPARE(info["channels"].toArray().size(), 2);
        QCOMPARE(info["channels"][0]["unit"].toString(), QString("V"));
        QCOMPARE(info["rate_from"].toString(), QString("time column"));
    }

    void without_a_word_the_header_says_nothing_of_it() {
        QCOMPARE(run("analyze plain.csv -o plain-track.csv --rate 100 --window 5 --f0 20").status,
                 0);
        QVERIFY(!file("plain-track.csv").contains("read with"));
    }

    void no_time_column_needs_a_rate() {
        QCOMPARE(run("info plain.csv --time-column none").status, 3);
        QCOMPARE(run("info plain.csv --time-column none --rate 100").status, 0);
    }

    void wrong_usage_is_told_in_a_sentence_data() {
        QTest::addColumn<QString>("options");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* options, int status, const char* part) {
            QTest::newRow(options) << QString(options) << status << QString(part);
        };
        row("--delimiter ;", 2, "it is comma, semicolon, tab, space or bar");
        row("--decimal dot", 2, "it is point or comma");
        row("--skip-lines two", 2, "--skip-lines cannot be \"two\"");
        row("--skip-lines -1", 2, "--skip-lines cannot be \"-1\"");
        row("--skip-lines 2000000", 2, "between 0 and 1000000");
        row("--time-column 0", 2, "it is the number of a column, from 1, or none");
        row("--time-column t", 2, "--time-column cannot be \"t\"");
        row("--time-unit min", 2, "it is s, ms, us or ns");
        row("--scale 0", 2, "--scale cannot be \"0\"");
        row("--raw i16 --delimiter tab", 2, "it is for text");
        row("--delimiter tab --rate 100", 3, "read as text with --delimiter tab");
        row("--skip-lines 50 --rate 100", 3, "50 lines are to be skipped");
        row("--skip-lines 0 --rate 100", 3, "line 1, column 1: \"C\"");
        row("--time-column 3", 3, "there is no column 3");
    }
    void wrong_usage_is_told_in_a_sentence() {
        QFETCH(QString, options);
        QFETCH(int, status);
        QFETCH(QString, part);
        const Outcome outcome = run("info plain.csv " + options);
        QVERIFY2(outcome.err.contains(part.toUtf8()), outcome.err);
        QCOMPARE(outcome.status, status);
        QCOMPARE(outcome.err_lines().size(), 1);
        QVERIFY(outcome.err.endsWith(".\n"));
    }
};

VYBEG_TEST(TestCliTextOptions)

}  // namespace test_cli_text_options

#include "test_cli_text_options.moc"
