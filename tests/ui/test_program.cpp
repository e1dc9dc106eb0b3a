// The desktop program as a process: its command line and exit statuses (INTERFACE.md).
#include "tests/ui/gui_test.h"

#include <QFile>
#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>

using namespace vybeg::ui;

class TestProgram : public QObject {
    Q_OBJECT

    GuiTestHome home_;

    struct Outcome {
        int status = -1;
        QString out;
        QString err;
    };

    // Without any display, as on a server.
    Outcome run(const QStringList& arguments) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
            environment.remove(name);
        }
        environment.insert("XDG_RUNTIME_DIR", home_.path("."));
        QProcess program;
        program.setProcessEnvironment(environment);
        program.start(VYBEG_PROGRAM, arguments);
        if (!program.waitForFinished(60000) || program.exitStatus() != QProcess::NormalExit) {
            return {};
        }
        return {program.exitCode(), QString::fromUtf8(program.readAllStandardOutput()),
                QString::fromUtf8(program.readAllStandardError())};
    }

private slots:
    void help_and_version_need_no_display() {
        const Outcome help = run({"--help"});
        QCOMPARE(help.status, 0);
        for (const char* option : {"--figure", "--windows", "--algorithm", "--kappa", "--raw"}) {
            QVERIFY2(help.out.contains(option), option);
        }
        QVERIFY(!help.out.contains("--report"));
        const Outcome version = run({"--version"});
        QCOMPARE(version.status, 0);
        QVERIFY(version.out.startsWith("vybeg "));
    }

    void a_figure_is_drawn_without_a_display_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("begins");
        QTest::newRow("svg") << "figure.svg" << QByteArray("<?xml");
        QTest::newRow("pdf") << "figure.pdf" << QByteArray("%PDF-");
        QTest::newRow("png") << "figure.png" << QByteArray("\x89PNG");
    }
    void a_figure_is_drawn_without_a_display() {
        QFETCH(QString, name);
        QFETCH(QByteArray, begins);
        const QString figure = home_.path(name);
        const Outcome drawn =
            run({home_.recording("demo.wav"), "--figure", figure, "--windows", "8,80"});
        QCOMPARE(drawn.status, 0);
        QFile file(figure);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.read(begins.size()), begins);
    }

    void each_window_length_is_a_column() {
        const QString recording = home_.recording("columns.wav");
        QList<int> widths;
        for (const char* windows : {"80", "8,80", "8,40,80"}) {
            const QString figure = home_.path("columns.png");
            QCOMPARE(run({recording, "--figure", figure, "--windows", windows}).status, 0);
            widths << QImage(figure).width();
        }
        QVERIFY(widths.at(0) > 300);
        QCOMPARE(widths.at(1), 2 * widths.at(0));
        QCOMPARE(widths.at(2), 3 * widths.at(0));
    }

    void what_goes_wrong_has_its_exit_status_and_one_line_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("status");
        const QString good = home_.recording("good.wav");
        const QString figure = home_.path("wrong.svg");
        QTest::newRow("unknown option") << QStringList{good, "--nonsense"} << 2;
        QTest::newRow("bad number") << QStringList{good, "--figure", figure, "--kappa", "x"} << 2;
        QTest::newRow("bad windows")
            << QStringList{good, "--figure", figure, "--windows", "6,x"} << 2;
        QTest::newRow("no recording") << QStringList{"--figure", figure} << 2;
        QTest::newRow("windows without figure") << QStringList{good, "--windows", "6"} << 2;
        QTest::newRow("no display") << QStringList{good} << 2;
        QTest::newRow("missing") << QStringList{home_.path("none.wav"), "--figure", figure} << 3;
        QTest::newRow("empty") << QStringList{home_.file("empty.wav", ""), "--figure", figure} << 3;
        QTest::newRow("window too long")
            << QStringList{good, "--figure", figure, "--window", "1000000"} << 4;
        QTest::newRow("unknown ending") << QStringList{good, "--figure", home_.path("a.bmp")} << 5;
        QTest::newRow("no folder") << QStringList{good, "--figure", home_.path("none/a.svg")} << 5;
    }
    void what_goes_wrong_has_its_exit_status_and_one_line() {
        QFETCH(QStringList, arguments);
        QFETCH(int, status);
        const Outcome outcome = run(arguments);
        QCOMPARE(outcome.status, status);
        QVERIFY2(outcome.err.startsWith("vybeg: "), qPrintable(outcome.err));
        QCOMPARE(outcome.err.count('\n'), 1);
        QVERIFY(!QFile::exists(home_.path("wrong.svg")));
    }

    void files_named_on_the_command_line_are_opened_and_the_window_closes_on_term() {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("QT_QPA_PLATFORM", "offscreen");
        environment.insert("XDG_CONFIG_HOME", home_.path("config"));
        const QString recording = home_.recording("opened.wav");
        QProcess program;
        program.setProcessEnvironment(environment);
        program.start(VYBEG_PROGRAM, {recording, "--window", "80"});
        QVERIFY(program.waitForStarted());
        // The program notes a recording that it could open among the recent ones.
        const auto remembered = [&] {
            QFile settings(home_.path("config/vybeg/vybeg.conf"));
            return settings.open(QIODevice::ReadOnly) && settings.readAll().contains("opened.wav");
        };
        QVERIFY(QTest::qWaitFor(remembered, 20000));
        program.terminate();
        QVERIFY(program.waitForFinished(5000));
    }
};

QTEST_GUILESS_MAIN(TestProgram)
#include "test_program.moc"
