// What is said of a command line: options given twice, without effect, out of bounds; and of
// recordings by their names.
#include "tests/app/cli_run.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>

namespace test_cli_usage {

using namespace vybeg::test;

class TestCliUsage : public QObject, private CliFolder {
    Q_OBJECT

private slots:
    void initTestCase() {
        QCOMPARE(run("simulate --demo --seconds 2 -o a.wav").status, 0);
        QCOMPARE(run("simulate --demo --seconds 2 --two-theta-A 1.2 -o b.wav").status, 0);
        QVERIFY(QFile::copy(path("a.wav"), path("copy.wav")));
        QVERIFY(QFile::copy(path("a.wav"), path("-c.wav")));
        QByteArray text = "t,C,D\n";
        for (int k = 0; k < 3000; ++k) {
            text += QByteArray::number(k / 33333.0, 'g', 17) + "," +
                    QByteArray::number(std::cos(k), 'g', 17) + ",nan\n";
        }
        QVERIFY(put(path("one.csv"), text));
    }

    void the_line_is_refused_with_its_reason_data() {
        QTest::addColumn<QString>("command");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* command, int status, const char* part) {
            QTest::newRow(command) << command << status << part;
        };
        row("analyze a.wav -o x.csv --f0 5300 --f0 5400", 2, "--f0 is given twice.");
        row("analyze a.wav -o x.csv --window 60 --window 60", 2, "--window is given twice.");
        row("analyze a.wav -o x.csv -o y.csv", 2, "--output is given twice.");
        row("analyze a.wav -o x.csv --snap --snap", 2, "--snap is given twice.");
        row("analyze a.wav -o x.csv --quiet --quiet", 2, "--quiet is given twice.");
        row("identify a.wav b.wav --model auto --model free", 2, "--model is given twice.");
        row("simulate --demo --demo -o x.csv", 2, "--demo is given twice.");
        row("simulate --seed 1 --seed 2 -o x.csv", 2, "--seed is given twice.");
        row("analyze a.wav -o x.csv --f0", 2, "--f0 needs a value.");

        row("analyze a.wav -o x.Npy", 5, "let its name end in .npz");
        row("simulate --demo -o x.csv --truth x.npy", 5, "let its name end in .npz");
        row("analyze a.wav -o x.csv --rate 1e-308", 2, "--rate cannot be");
        // Nothing that a name holds turns the terminal's colours.
        row("analyze a.wav b\x1b[31m.wav -o x.csv", 2, "b\\x1b[31m.wav");
        row("analyse\x1b[31m a.wav", 2, "\\x1b[31m");
        row("analyze a.wav -o x.csv --\x1b[31m", 2, "\\x1b[31m");

        row("identify --foo a.wav", 2, "There is no option --foo.");
        row("identify a.wav --windw 60", 2, "no option --windw. Did you mean --window?");
        row("identify a.wav b.wav --wind=60", 2, "no option --wind=60. Did you mean --window?");
        row("identify a.wav ---window 60", 2, "no option ---window. Did you mean --window?");
        row("identify a.wav -window 60", 2, "no option -window. Did you mean --window?");
        row("identify a.wav -output x.csv", 2, "no option -output. Did you mean --output?");
        row("identify --f_0 5300 a.wav", 2, "There is no option --f_0.");
        row("compare p.json a.wav --Window 60", 2, "no option --Window. Did you mean --window?");
        row("batch l.csv -o x.csv --resum", 2, "no option --resum. Did you mean --resume?");
        row("info --jsn a.wav", 2, "no option --jsn.");
        row("info a.wav --jason", 2, "no option --jason. Did you mean --json?");
        row("analyze a.wav -o x.csv --windw 60", 2, "no option --windw. Did you mean --window?");
        row("simulate --sed 3 -o x.csv", 2, "no option --sed.");
        row("simulate --ceed 3 -o x.csv", 2, "no option --ceed. Did you mean --seed?");
        row("--quite info a.wav", 2, "no option --quite. Did you mean --quiet?");
        row("--quiet info a.wav", 2, "--quiet follows its command, as in info --quiet.");
        row("info -c.wav", 2, "no option -c.wav. The file of this name is ./-c.wav.");
        row("info -b.wav", 2, "There is no option -b.wav.");
        row("identfy a.wav", 2, "There is no subcommand \"identfy\".");
        row("identify -- --foo", 3, "--foo: there is no such file");

        row("analyze a.wav -o x.csv --angle-zero 1e308", 2, "--angle-zero cannot be");
        row("analyze a.wav -o x.csv --angle-zero 361", 2, "--angle-zero cannot be");
        row("analyze a.wav -o x.csv --kappa 1e308", 2, "--kappa cannot be");
        row("analyze a.wav -o x.csv --kappa 1e-308", 2, "--kappa cannot be");
        row("analyze a.wav -o x.csv --offset 0,1e308", 2, "--offset cannot be");
        row("analyze a.wav -o x.csv --delay -1e308", 2, "--delay cannot be");
        row("analyze a.wav -o x.csv --periods 1e308", 2, "--periods cannot be \"1e+308\"");
        row("analyze a.wav -o x.csv --periods 1e18", 2, "--periods cannot be");
        row("analyze a.wav -o x.csv --f0 1e-308", 2, "--f0 cannot be");
        row("analyze a.wav -o x.csv --hop 9223372036854775807", 2, "--hop cannot be");
        row("analyze a.wav -o x.csv --window 9223372036854775807", 2, "--window cannot be");
        row("analyze a.wav -o x.csv --initial 1e308,0,0,0,5300", 2, "--initial cannot be");
        row("analyze a.wav -o x.csv --initial 1,0,1e308,0,5300", 2, "--initial cannot be");
        row("identify a.wav b.wav --angle-zero 1e308", 2, "--angle-zero cannot be");
        row("simulate --split 1e308 -o x.csv", 4, "split");
        row("simulate --split 23000 -o x.csv", 4, "split");
        row("simulate --a-A 1e308 -o x.csv", 4, "1e30");
        row("simulate --alpha 1e308 -o x.csv", 4, "1e6 rad");
        row("simulate --omega 1e308 -o x.csv", 4, "rotation");
        row("simulate --tau 1e-308 -o x.csv", 4, "decay time");
        row("simulate --kappa 1e308 -o x.csv", 4, "kappa");

        row("analyze a.wav -o x.csv --band 5300,5300.001", 4,
            "the band from 5300 Hz to 5300.001 Hz is too narrow");
        row("analyze a.wav -o x.csv --band 5300,5300.002", 4, "at least 0.5 Hz");
        row("analyze one.csv -o x.csv", 4, "channel D has no samples");
        row("analyze one.csv -o x.csv --channels 2,1", 4, "channel C has no samples");
        row("analyze one.csv -o x.csv --f0 5300", 4, "channel D has no samples");
        row("identify one.csv", 4, "channel D has no samples");
        row("identify one.csv --f0 5300", 4, "channel D has no samples");

        row("identify a.wav a.wav b.wav", 4, "a.wav and a.wav hold the same samples");
        row("identify a.wav b.wav copy.wav", 4, "a.wav and copy.wav hold the same samples");
    }

    void the_line_is_refused_with_its_reason() {
        QFETCH(QString, command);
        QFETCH(int, status);
        QFETCH(QString, part);
        const Outcome outcome = run(command);
        VYBEG_EQUAL(outcome.status, status, outcome.err);
        // Warnings about the recording may stand before the one sentence.
        QList<QByteArray> sentences = outcome.err_lines();
        sentences.removeIf([](const QByteArray& line) { return line.contains(": warning: "); });
        QCOMPARE(sentences.size(), 1);
        QVERIFY2(sentences[0].contains(part.toUtf8()), outcome.err);
        QVERIFY(!QFile::exists(path("x.csv")));
    }

    void help_is_a_subcommand_too() {
        for (const auto& [word, option] :
             {std::pair("help", "--help"), std::pair("help info", "info --help")}) {
            const Outcome outcome = run(word);
            VYBEG_EQUAL(outcome.status, 0, outcome.err);
            QVERIFY(outcome.out.contains("--help"));
            QCOMPARE(outcome.out, run(option).out);
        }
    }

    void a_file_whose_name_begins_with_a_dash_is_read_after_two_or_by_its_folder() {
        for (const QStringList& command : {words("info -- -c.wav"), QStringList{"info", "./-c.wav"},
                                           words("info --rate 8000 -- -c.wav")}) {
            const Outcome outcome = run(command);
            VYBEG_EQUAL(outcome.status, 0, outcome.err);
            QVERIFY2(outcome.out.contains("-c.wav"), outcome.out);
        }
        // What begins with a dash is a value where an option takes it.
        VYBEG_EQUAL(run("info a.wav --unit -V").status, 0, "--unit -V");
        VYBEG_EQUAL(run("analyze a.wav -o y.csv --delay -1e-6").status, 0, "--delay -1e-6");
    }

    void an_empty_name_is_no_value() {
        const QList<QStringList> commands{
            {"analyze", "a.wav", "-o", ""},
            {"identify", "a.wav", "b.wav", "--passport", ""},
            {"identify", "a.wav", "b.wav", "-o", ""},
            {"simulate", "--seconds", "0.01", "-o", "x.csv", "--truth", ""}};
        for (const QStringList& command : commands) {
            const Outcome outcome = run(command);
            VYBEG_EQUAL(outcome.status, 2, outcome.err);
            QVERIFY2(outcome.err.contains("needs a value."), outcome.err);
        }
    }

    void options_without_effect_are_warned_of_data() {
        QTest::addColumn<QString>("command");
        QTest::addColumn<QStringList>("options");
        const auto row = [](const char* command, const QStringList& options) {
            QTest::newRow(command) << command << options;
        };
        row("analyze a.wav -o x.csv", {});
        row("analyze a.wav -o x.csv --algorithm conjugate-gradient --start previous", {});
        row("analyze a.wav -o x.csv --start previous", {"--start"});
        row("analyze a.wav -o x.csv --initial 1,0,0.3,0,5300", {"--initial"});
        row("analyze a.wav -o x.csv --f0 5300 --band 5000,6000", {"--band"});
        row("analyze a.wav -o x.csv --rate 44100", {"--rate"});
        row("analyze a.wav -o x.csv --variables C,D", {"--variables"});
        row("info a.wav --rate 44100", {"--rate"});
        row("identify a.wav b.wav --f0 5300 --band 5000,6000", {"--band"});
        row("simulate --seconds 0.01 -o x.csv", {});
        row("simulate --seconds 0.01 --demo -o x.csv", {});
        row("simulate --seconds 0.01 --full-scale 2 --seed 3 -o x.csv", {"--full-scale", "--seed"});
        row("simulate --seconds 0.01 --bits 16 --full-scale 2 --noise 0.1 --seed 3 -o x.csv", {});
        row("simulate --seconds 0.01 --theta-w 1 --theta-tau 1 --bryan 0.3 -o x.csv",
            {"--bryan", "--theta-w", "--theta-tau"});
        row("simulate --seconds 0.01 --window 5 -o x.csv", {"--window"});
        row("simulate --seconds 0.01 --settling-time 2 -o x.csv", {"--settling-time"});
        row("simulate --seconds 0.01 --settling 1 --settling-time 2 -o x.csv", {});
    }

    void options_without_effect_are_warned_of() {
        QFETCH(QString, command);
        QFETCH(QStringList, options);
        const Outcome outcome = run(command);
        VYBEG_EQUAL(outcome.status, 0, outcome.err);
        QStringList warned;
        for (const QByteArray& line : outcome.err_lines()) {
            if (line.contains(" has no effect: ")) {
                const QByteArray about = line.mid(line.indexOf("--"));
                const QString option = QString::fromUtf8(about.left(about.indexOf(' ')));
                if (!warned.contains(option)) {
                    warned << option;
                }
            }
        }
        QCOMPARE(warned, options);
        QFile::remove(path("x.csv"));
    }

    void a_warning_about_one_of_several_recordings_has_its_name() {
        QCOMPARE(run("simulate --demo --seconds 2 --two-theta-A 1.2 --frequency-drift 0.5 -o "
                     "drifting.wav")
                     .status,
                 0);
        const Outcome outcome = run("identify --verbose a.wav drifting.wav -o x.json");
        VYBEG_EQUAL(outcome.status, 0, outcome.err);
        QVERIFY2(outcome.err.contains("Recording drifting.wav: the frequency drifts"), outcome.err);
        QVERIFY2(!outcome.err.contains("Recording 2"), outcome.err);
        QVERIFY(file("x.json").contains("Recording drifting.wav: the frequency drifts"));
        QVERIFY(QFile::remove(path("x.json")));
    }
};

VYBEG_TEST(TestCliUsage)

}  // namespace test_cli_usage

#include "test_cli_usage.moc"
