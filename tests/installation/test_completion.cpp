// The completion in bash, as bash calls it.
#include "tests/closeness.h"
#include "tests/installation/help_pages.h"
#include "tests/test_registry.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

namespace test_completion {

using namespace vybeg::test;

class TestCompletion : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        for (const char* name : {"a.csv", "a.json", "a.wav", "a.pdf", "with space.wav"}) {
            QFile file(folder_.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        QVERIFY(QDir(folder_.path()).mkdir("sub"));
    }

    void commands_and_options_are_those_of_the_help() {
        const QStringList commands = commands_of(VYBEG_CLI);
        QVERIFY(commands.contains("batch"));
        QCOMPARE(offered({VYBEG_CLI, ""}), commands);
        QCOMPARE(offered({VYBEG_CLI, "--"}), described_options(help_of(VYBEG_CLI, "")));
        for (const QString& command : commands) {
            QCOMPARE(offered({VYBEG_CLI, command, "--"}),
                     described_options(help_of(VYBEG_CLI, command)));
        }
        QCOMPARE(offered({VYBEG_GUI, "--"}), described_options(help_of(VYBEG_GUI, "")));
        QCOMPARE(offered({VYBEG_CLI, "analyze", "--al"}), QStringList{"--algorithm"});
        QCOMPARE(offered({VYBEG_CLI, "no-command", "--"}), QStringList());
    }

    void names_are_those_that_the_help_lists_data() {
        QTest::addColumn<QString>("command");
        for (const char* option :
             {"--algorithm", "--raw", "--delimiter", "--decimal", "--time-unit"}) {
            QTest::newRow(option) << "analyze";
        }
        QTest::newRow("--model") << "identify";
        QTest::newRow("--tolerance") << "identify";
    }

    void names_are_those_that_the_help_lists() {
        QFETCH(QString, command);
        const QString option = QTest::currentDataTag();
        QCOMPARE(offered({VYBEG_CLI, command, option, ""}), names_in_help(command, option));
        // As bash splits --option=.
        QCOMPARE(offered({VYBEG_CLI, command, option, "="}), names_in_help(command, option));
    }

    void the_program_takes_each_name_data() { names_are_those_that_the_help_lists_data(); }

    void the_program_takes_each_name() {
        QFETCH(QString, command);
        const QString option = QTest::currentDataTag();
        const QStringList names = offered({VYBEG_CLI, command, option, ""});
        VYBEG_MORE(names.size(), 1);
        for (const QString& name : names) {
            QProcess program;
            program.start(VYBEG_CLI,
                          {command, "/nowhere/recording", "-o", folder_.filePath("x.csv"), option,
                           name.endsWith('=') ? name + "0.01" : name});
            QVERIFY(program.waitForFinished());
            // The recording is what is missing: wrong usage would be 2.
            VYBEG_EQUAL(program.exitCode(), 3, program.readAllStandardError().constData());
        }
    }

    void words_between_bars_are_offered_and_variables_are_not() {
        QCOMPARE(offered({VYBEG_CLI, "analyze", "--start", ""}),
                 (QStringList{"first", "previous"}));
        QCOMPARE(offered({VYBEG_CLI, "analyze", "--offset", ""}), QStringList{"auto"});
        QCOMPARE(offered({VYBEG_CLI, "simulate", "--offset", ""}), QStringList());
        QCOMPARE(offered({VYBEG_CLI, "analyze", "--algorithm", "=", "ma"}),
                 QStringList{"maximum-likelihood"});
    }

    void files_follow_what_the_option_takes() {
        const QStringList all{"a.csv", "a.json", "a.pdf", "a.wav", "sub", "with space.wav"};
        QCOMPARE(offered({VYBEG_CLI, "analyze", ""}), all);
        QCOMPARE(offered({VYBEG_CLI, "analyze", "--snap", ""}), all);  // --snap takes nothing
        QCOMPARE(offered({VYBEG_CLI, "analyze", "w"}), QStringList{"with space.wav"});
        QCOMPARE(offered({VYBEG_CLI, "identify", "--list", ""}), (QStringList{"a.csv", "sub"}));
        QCOMPARE(offered({VYBEG_CLI, "identify", "-o", ""}), (QStringList{"a.json", "sub"}));
        QCOMPARE(offered({VYBEG_CLI, "batch", "--passport", ""}), QStringList{"sub"});
        QCOMPARE(offered({VYBEG_GUI, "--figure", ""}), (QStringList{"a.pdf", "sub"}));
        QCOMPARE(offered({VYBEG_GUI, ""}), all);
    }

private:
    // What the completion offers for the last of the words, in alphabetical order.
    QStringList offered(const QStringList& words) const {
        QProcess bash;
        bash.setWorkingDirectory(folder_.path());
        bash.start("bash",
                   QStringList{"--norc", "-c",
                               ". '" VYBEG_COMPLETION
                               "'; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _vybeg \"$1\"; "
                               "((${#COMPREPLY[@]} == 0)) || printf '%s\\n' \"${COMPREPLY[@]}\"",
                               "bash"} +
                       words);
        bash.waitForFinished();
        const QByteArray complaint = bash.readAllStandardError();
        if (!complaint.isEmpty()) {
            return {QString::fromUtf8(complaint)};
        }
        QStringList lines = QString::fromUtf8(bash.readAllStandardOutput()).split('\n');
        lines.removeAll("");
        lines.sort();
        return lines;
    }

    // The names that an option of a command takes, from the sentence of its help.
    static QStringList names_in_help(const QString& command, const QString& option) {
        QString text =
            help_of(VYBEG_CLI, command).section("\n  " + option + " ", 1).section('\n', 0, 0);
        text = text.section(' ', 1).trimmed();  // without the placeholder
        if (text.contains(": ")) {
            text = text.section(": ", 1);
        }
        const bool defaults_first = option == "--tolerance";
        text = defaults_first ? text.section(';', 0, 0) : text;
        text.remove(QRegularExpression("\\([^)]*\\)|\\[[^]]*\\]"));
        QStringList names = text.split(QRegularExpression(",| or |;"));
        for (QString& name : names) {
            name = name.simplified() + (defaults_first ? "=" : "");
        }
        names.removeAll("");
        names.sort();
        return names;
    }

    QTemporaryDir folder_;
};

VYBEG_TEST(TestCompletion)

}  // namespace test_completion

#include "test_completion.moc"
