#include "core/base/number_text.h"
#include "tests/core/recording/recording_files.h"
#include "tests/test_registry.h"

#include <QProcess>

#include <clocale>
#include <cstdio>
#include <cstdlib>

namespace test_comma_locale {

using namespace vybeg;
using namespace vybeg::test;

// Qt sets the C locale of the program to the user's: a Russian or German one writes 1,5.
class TestCommaLocale : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        // Makes its own Russian locale where the machine has none.
        if (!std::setlocale(LC_ALL, "ru_RU.UTF-8") && !std::setlocale(LC_ALL, "de_DE.UTF-8")) {
            QProcess::execute("localedef",
                              {"-i", "ru_RU", "-f", "UTF-8", locales_.filePath("ru_RU.UTF-8")});
            ::setenv("LOCPATH", locales_.path().toUtf8().constData(), 1);
            std::setlocale(LC_ALL, "ru_RU.UTF-8");
        }
        char text[8];
        std::snprintf(text, sizeof text, "%.1f", 1.5);
        if (std::string(text) != "1,5") {
            QSKIP("NOT TESTED: no locale with a decimal comma, and localedef could not make one");
        }
    }

    void text_is_read_as_everywhere_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("decimal point")
            << QByteArray("t,C,D\n0.0,1.5,-2.25e-1\n0.5,1.5,2\n1.0,1.5,2\n1.5,1.5,2\n2.0,1.5,2\n");
        QTest::newRow("decimal comma")
            << QByteArray("t;C;D\n0,0;1,5;-2,25e-1\n0,5;1,5;2\n1,0;1,5;2\n1,5;1,5;2\n2,0;1,5;2\n");
    }

    void text_is_read_as_everywhere() {
        QFETCH(QByteArray, text);
        const Folder folder;
        const Recording recording = opened(folder.write("run", text.toStdString()));
        QCOMPARE(recording.rate_hz, 2.0);
        QCOMPARE(read_all(recording).c, std::vector<double>(5, 1.5));
        QCOMPARE(read_all(recording).d, (std::vector<double>{-0.225, 2, 2, 2, 2}));
    }

    void messages_and_diagnostics_are_written_as_everywhere() {
        const Folder folder;
        const auto backwards = open(folder.write("run", "t,C,D\n0.5,1,2\n0.25,1,2\n0.75,1,2\n"));
        QVERIFY(!backwards);
        QCOMPARE(backwards.error().args, (std::vector<MessageArg>{"3", "0.25", "0.5"}));
        const Recording gap = opened(folder.write(
            "run", "t,C,D\n0.5,1,2\n0.75,1,2\n1.0,1,2\n1.25,1,2\n1.5,1,2\n2.0,1,2\n2.25,1,2\n"));
        QCOMPARE(gap.diagnostics.at(0).args, (std::vector<MessageArg>{"1", "1.25"}));
        // The reason comes from the operating system, whose messages are translated.
        QVERIFY(
            english(open(folder.file("none")).error()).ends_with("Check the name and the folder."));
    }

private:
    QTemporaryDir locales_;
};

VYBEG_TEST(TestCommaLocale)

}  // namespace test_comma_locale

#include "test_comma_locale.moc"
