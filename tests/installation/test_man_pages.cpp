// The man pages are written at build time from --help; a pattern that no longer fits it would lose
// options without a word.
#include "tests/closeness.h"
#include "tests/installation/help_pages.h"
#include "tests/test_registry.h"

#include <QFile>
#include <QStandardPaths>
#include <QtTest>

namespace test_man_pages {

using namespace vybeg::test;

namespace {

QString page(const QString& program) {
    QFile file(QString(VYBEG_MAN_FOLDER "/%1.1").arg(program));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

// The text between a heading (".SH OPTIONS", ".SS analyze") and the next of its rank or above, as
// it is read: without fonts.
QString section(const QString& page, const QString& heading) {
    QString text = page.section('\n' + heading + '\n', 1);
    text = text.section(QRegularExpression(heading.startsWith(".SH") ? "\n\\.SH " : "\n\\.S[HS] "),
                        0, 0);
    return text.remove(QRegularExpression("\\\\f[BIR]")).replace("\\-", "-");
}

// The options at the head of an entry, and those that an entry of another command describes.
QStringList options_in(const QString& section) {
    QStringList found = found_in(section, "^(?:-\\w, )?(--[a-zA-Z][-\\w]*)");
    for (const QString& others : found_in(section, "^As [-a-z]+: (.*)$")) {
        found += others.split(", ");
    }
    found.sort();
    return found;
}

}  // namespace

class TestManPages : public QObject {
    Q_OBJECT

private slots:
    void every_option_of_each_command_is_on_its_page_and_no_other() {
        const QStringList commands = commands_of(VYBEG_CLI);
        QVERIFY(commands.contains("analyze"));
        for (const auto& [name, heading] :
             {std::pair{"vybeg-cli", "OPTIONS"}, std::pair{"ru/vybeg-cli", "ПАРАМЕТРЫ"}}) {
            const QString text = page(name);
            QCOMPARE(found_in(text, "^\\.SS (.*)$"), commands);
            for (const QString& command : commands) {
                QStringList options = described_options(help_of(VYBEG_CLI, command));
                QVERIFY(options.removeOne("--help"));
                QCOMPARE(options_in(section(text, ".SS " + command)), options);
            }
            QCOMPARE(options_in(section(text, QString(".SH ") + heading)),
                     described_options(help_of(VYBEG_CLI, "")));
        }
    }

    void the_desktop_programs_options_are_on_its_page_and_no_other() {
        const QStringList options = described_options(help_of(VYBEG_GUI, ""));
        QVERIFY(options.contains("--figure"));
        QCOMPARE(options_in(section(page("vybeg"), ".SH OPTIONS")), options);
        QCOMPARE(options_in(section(page("ru/vybeg"), ".SH ПАРАМЕТРЫ")), options);
    }

    void options_described_elsewhere_are_described_there() {
        const QString text = page("vybeg-cli");
        int shared = 0;
        for (const QString& command : commands_of(VYBEG_CLI)) {
            const QRegularExpression line("^As ([-a-z]+): (.*)$",
                                          QRegularExpression::MultilineOption);
            for (auto lines = line.globalMatch(section(text, ".SS " + command)); lines.hasNext();) {
                const QRegularExpressionMatch match = lines.next();
                const QString owner = section(text, ".SS " + match.captured(1));
                for (const QString& option : match.captured(2).split(", ")) {
                    const QString entry = "^(?:-\\w, )?" + option + "(?: .*)?\n(.+)$";
                    VYBEG_EQUAL(found_in(owner, entry).size(), 1, qPrintable(option));
                    ++shared;
                }
            }
        }
        VYBEG_MORE(shared, 20);
    }

    void an_option_keeps_its_text() {
        const QString analyze = section(page("vybeg-cli"), ".SS analyze");
        QVERIFY(
            analyze.contains("\n--window N\nWindow length, samples (default 60). Not together with "
                             "--periods.\n"));
        const QString identify = section(page("vybeg-cli"), ".SS identify");
        QVERIFY(
            identify.contains("\n--set NAME\nThe set of the list (default: its only one). Needs "
                              "--list.\n"));
        QVERIFY(
            identify.contains("\n--tolerance NAME=X[,NAME=X]\nHow well the channels are known"));
    }

    // What has no option of its own, in both languages.
    void work_without_a_screen_is_explained() {
        for (const char* name : {"vybeg-cli", "ru/vybeg-cli"}) {
            const QString text = page(name);
            const QStringList headings = found_in(text, "^\\.SH (.*)$");
            QCOMPARE(headings.size(), 14);
            for (const char* told :
                 {"FROM history WHERE gyro", "sqlar_uncompress(json", "temperature_c", "unfinished",
                  "\nparameter,least,greatest,gyro_type\n", "limits\\-not\\-kept", "undecided",
                  "\"reason\"", "parallel \\-k", "/help/"}) {
                QVERIFY2(text.contains(told), told);
            }
        }
        QVERIFY(page("vybeg-cli").contains("\n.SH DATABASE\n"));
        QVERIFY(page("ru/vybeg-cli").contains("\n.SH БАЗА ДАННЫХ\n"));
    }

    void mandoc_and_groff_find_no_fault_data() {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("mandoc") << "mandoc" << QStringList{"-T", "lint", "-W", "warning"};
        QTest::newRow("groff") << "groff" << QStringList{"-man", "-ww",  "-W", "break", "-z",
                                                         "-K",   "utf8", "-T", "utf8"};
    }

    void mandoc_and_groff_find_no_fault() {
        QFETCH(QString, tool);
        QFETCH(QStringList, arguments);
        if (QStandardPaths::findExecutable(tool).isEmpty()) {
            QSKIP(qPrintable(tool + " is NOT INSTALLED: the man pages are not checked by it."));
        }
        for (const char* program : {"vybeg", "vybeg-cli", "ru/vybeg", "ru/vybeg-cli"}) {
            QProcess process;
            process.setProcessChannelMode(QProcess::MergedChannels);
            process.start(tool,
                          arguments + QStringList{QString(VYBEG_MAN_FOLDER "/%1.1").arg(program)});
            QVERIFY(process.waitForFinished());
            QCOMPARE(process.readAll(), QByteArray());
            QCOMPARE(process.exitCode(), 0);
        }
    }
};

VYBEG_TEST(TestManPages)

}  // namespace test_man_pages

#include "test_man_pages.moc"
