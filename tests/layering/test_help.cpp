#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QDir>
#include <QProcess>
#include <QRegularExpression>
#include <QtTest>

namespace test_help {

using namespace vybeg;

namespace {

const QStringList languages{"en", "ru"};
const QDir help_folder(VYBEG_ROOT "/resources/help");

// The whole text on one line, so that no pattern minds where a line is broken.
QString pageText(const QString& path) {
    QFile file(help_folder.filePath(path));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()).simplified()
                                          : QString();
}

// What a pattern's only group captures, throughout a text.
QStringList captures(const QString& text, const QString& pattern) {
    const QRegularExpression expression(pattern, QRegularExpression::DotMatchesEverythingOption);
    QStringList found;
    for (auto matches = expression.globalMatch(text); matches.hasNext();) {
        found += matches.next().captured(1).simplified();
    }
    return found;
}

// The formulas of a page in their order; Russian writes tg where English writes tan.
QStringList formulas(const QString& text) {
    QStringList found = captures(text, "<(?:span|td) class=\"f\">(.*?)</(?:span|td)>");
    found.replaceInStrings(QRegularExpression("\\btan\\b"), "tg");
    return found;
}

QStringList pages(const QString& language) {
    return QDir(help_folder.filePath(language)).entryList({"*.html"}, QDir::Files, QDir::Name);
}

QStringList pictures(const QString& language) {
    return QDir(help_folder.filePath(language + "/pictures"))
        .entryList({"*.png"}, QDir::Files, QDir::Name);
}

QString withoutTags(QString html) {
    html.remove(QRegularExpression("<[^>]*>"));
    return html.replace("&nbsp;", " ").simplified();
}

// The long options that a text names, without repetition, in alphabetical order.
QStringList options(const QString& text) {
    QStringList found = captures(text, "(?<![-\\w])(--[a-zA-Z][-\\w]*)");
    found.removeDuplicates();
    found.sort();
    return found;
}

// The options that `vybeg-cli COMMAND --help` names, but for --help and --output, which is -o.
QStringList optionsOf(const QString& command) {
    QProcess program;
    program.start(VYBEG_CLI, {command, "--help"});
    program.waitForFinished();
    QStringList found = options(QString::fromUtf8(program.readAllStandardOutput()));
    found.removeOne("--help");
    found.removeOne("--output");
    return found;
}

void addPages() {
    QTest::addColumn<QString>("page");
    for (const QString& page : pages("en")) {
        QTest::newRow(qPrintable(page)) << page;
    }
}

}  // namespace

class TestHelp : public QObject {
    Q_OBJECT

private slots:
    void bothLanguagesHaveTheSamePages() {
        QVERIFY(pages("en").contains("index.html"));
        QCOMPARE(pages("ru"), pages("en"));
        QVERIFY(pictures("en").contains("tracks.png"));
        QCOMPARE(pictures("ru"), pictures("en"));
    }

    void everyPageIsInTheResources() {
        QFile file(VYBEG_ROOT "/resources/resources.qrc");
        QVERIFY(file.open(QIODevice::ReadOnly));
        QStringList listed = captures(QString::fromUtf8(file.readAll()), "<file>(.*?)</file>");
        const QDir resources(VYBEG_ROOT "/resources");
        QStringList present{"help/help.css"};
        for (const QString& language : languages) {
            for (const QString& page : pages(language)) {
                present += "help/" + language + '/' + page;
            }
            for (const QString& picture : pictures(language)) {
                present += "help/" + language + "/pictures/" + picture;
            }
        }
        for (const QString& icon : QDir(resources.filePath("icons")).entryList({"*.svg"})) {
            present += "icons/" + icon;
        }
        listed.sort();
        present.sort();
        QCOMPARE(listed, present);
    }

    void bothLanguagesHaveTheSameStructureAndFormulas_data() { addPages(); }

    void bothLanguagesHaveTheSameStructureAndFormulas() {
        QFETCH(QString, page);
        const QString english = pageText("en/" + page);
        const QString russian = pageText("ru/" + page);
        const QString tags = "<(h1|h2|table|tr|td|th|pre|li)[ >]";
        QCOMPARE(captures(russian, tags), captures(english, tags));
        const QString anchors = "<a name=\"(.*?)\"";
        QCOMPARE(captures(russian, anchors), captures(english, anchors));
        QCOMPARE(formulas(russian), formulas(english));
    }

    void everyLinkLeadsSomewhere_data() { addPages(); }

    void everyLinkLeadsSomewhere() {
        QFETCH(QString, page);
        for (const QString& language : languages) {
            const QString text = pageText(language + '/' + page);
            const QStringList links = captures(text, "href=\"(.*?)\"");
            QVERIFY(links.contains("../help.css"));
            for (const QString& picture : captures(text, "<img src=\"(.*?)\"")) {
                QVERIFY2(QFile::exists(help_folder.filePath(language + '/' + picture)),
                         qPrintable(page + ": " + picture));
            }
            for (const QString& link : links) {
                const QString target = link.section('#', 0, 0);
                const QString anchor = link.section('#', 1);
                const QString path =
                    target.isEmpty() ? language + '/' + page : language + '/' + target;
                QVERIFY2(QFile::exists(help_folder.filePath(path)), qPrintable(page + ": " + link));
                QVERIFY2(anchor.isEmpty() || pageText(path).contains("<a name=\"" + anchor + "\">"),
                         qPrintable(page + ": " + link));
            }
        }
    }

    void russianPagesAreInRussian_data() { addPages(); }

    void russianPagesAreInRussian() {
        QFETCH(QString, page);
        // A sentence left in English: three ordinary words of it in a row, outside of code and
        // messages.
        QString text = pageText("ru/" + page);
        text.remove(
            QRegularExpression("<(code|pre|style)>.*?</\\1>|<span class=\"(f|msg)\">.*?</span>",
                               QRegularExpression::DotMatchesEverythingOption));
        QCOMPARE(captures(withoutTags(text), "\\b([a-z]{2,} [a-z]{2,} [a-z]{2,})\\b"),
                 QStringList{});
        VYBEG_MORE(captures(text, "([а-я]{3,})").size(), 50);
    }

    void allNineCorrectionsAreToldInBothLanguages_data() {
        QTest::addColumn<QString>("equation");
        QTest::addColumn<QString>("printed");
        QTest::addColumn<QString>("correct");
        const auto row = [](const char* name, const char* equation, const char* printed,
                            const char* correct) {
            QTest::newRow(name) << equation << printed << correct;
        };
        row("1", "(8)", "B = aB cos τ", "B = aB sin τ");
        row("2", "(11), (12)", "aA aB = aC aD sin ΔφCD", "aA aB = −aC aD sin ΔφCD");
        row("3", "(17), (18)", "SC + SD", "SA = SC cos 2θA + SD sin 2θA");
        row("4", "(18), (28)", "tg α = ⟨X cos ωt⟩ / ⟨X sin ωt⟩", "tg α = ⟨X sin ωt⟩ / ⟨X cos ωt⟩");
        row("5", "(15)", "tg 2θA = √(⟨D2⟩ / ⟨C2⟩)", "tg 2θA = ±√(⟨D2⟩ / ⟨C2⟩)");
        row("6", "(20)", "4⟨SC SD⟩ / [⟨SC2⟩ − ⟨SD2⟩]", "2⟨SC SD⟩ / [⟨SC2⟩ − ⟨SD2⟩]");
        row("7", "(23), (24)",
            "E2 = … + 4⟨SC SD(t − t3)⟩, F2 = … − 4⟨SC SD(t − t3)⟩, aB = +2⟨SC SD(t − t3)⟩ / aA",
            "E2 = … − 4⟨SC SD(t − t3)⟩, F2 = … + 4⟨SC SD(t − t3)⟩, aB = −2⟨SC SD(t − t3)⟩ / aA");
        row("8", "(32)", "sin 2Φ = L / (aA2 − aB2)", "2Φ = atan2(L, K), K = Cx2 + Cy2 − Sx2 − Sy2");
        row("9", "F,", "SD − (aA cos τ sin 2θA − aB sin τ cos 2θA)",
            "SD − (aA cos τ sin 2θA + aB sin τ cos 2θA)");
    }

    void allNineCorrectionsAreToldInBothLanguages() {
        QFETCH(QString, equation);
        QFETCH(QString, printed);
        QFETCH(QString, correct);
        for (const QString& language : languages) {
            const QStringList rows =
                captures(pageText(language + "/corrections.html"), "<tr>(<td>.*?)</tr>");
            QCOMPARE(rows.size(), 9);
            QStringList cells =
                captures(rows[QByteArray(QTest::currentDataTag()).toInt() - 1], "<td>(.*?)</td>");
            QCOMPARE(cells.size(), 5);
            cells.replaceInStrings(QRegularExpression("\\btan\\b"), "tg");
            QCOMPARE(cells[0], QTest::currentDataTag());
            QVERIFY(withoutTags(cells[1]).startsWith(equation));
            QCOMPARE(withoutTags(cells[2]), printed);
            QCOMPARE(withoutTags(cells[3]), correct);
            VYBEG_MORE(withoutTags(cells[4]).size(), 10);
        }
    }

    void everyQuotedMessageIsOneOfTheProgram() {
        QStringList messages;
        for (int code = 0; code <= static_cast<int>(ErrorCode::interrupted); ++code) {
            messages += QString::fromStdString(
                sentence_for(false, message_row(static_cast<ErrorCode>(code)).sentence));
        }
        for (int kind = 0; *message_row(static_cast<DiagnosticKind>(kind)).sentence != '\0';
             ++kind) {
            messages += QString::fromStdString(
                sentence_for(false, message_row(static_cast<DiagnosticKind>(kind)).sentence));
        }
        const QString pattern = "<span class=\"msg\">(.*?)</span>";
        const QStringList quoted = captures(pageText("en/troubleshooting.html"), pattern);
        VYBEG_MORE(quoted.size(), 15);
        QCOMPARE(captures(pageText("ru/troubleshooting.html"), pattern), quoted);
        for (const QString& quote : quoted) {
            // An ellipsis stands for what the message fills in.
            const QStringList parts = quote.split(" … ");
            QVERIFY2(std::any_of(messages.begin(), messages.end(),
                                 [&parts](const QString& message) {
                                     return std::all_of(parts.begin(), parts.end(),
                                                        [&message](const QString& part) {
                                                            return message.contains(part);
                                                        });
                                 }),
                     qPrintable(quote));
        }
    }

    void theOptionsAreThoseOfTheCommandLine() {
        const QStringList analyze = optionsOf("analyze");
        QVERIFY(analyze.contains("--algorithm"));
        QStringList all = analyze + optionsOf("info") + optionsOf("simulate") +
                          optionsOf("identify") + optionsOf("compare") + optionsOf("batch") +
                          optionsOf("drift") +
                          QStringList{"--figure",  "--report", "--gyro",       "--operator",
                                      "--comment", "--number", "--instrument", "--date",
                                      "--summary", "--windows"};  // those of the desktop program
        all.removeDuplicates();
        all.sort();
        for (const QString& language : languages) {
            QCOMPARE(options(pageText(language + "/files.html")), all);
        }
    }
};

VYBEG_TEST(TestHelp)

}  // namespace test_help

#include "test_help.moc"
