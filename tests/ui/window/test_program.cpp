// The desktop program as a process: its command line and exit statuses (help, files.html).
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QMap>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTest>

#include <functional>
#include <sys/resource.h>
#include <unistd.h>

namespace test_program {

using namespace vybeg::ui;

class TestProgram : public QObject {
    Q_OBJECT

    GuiTestHome home_;

    struct Outcome {
        int status = -1;
        QString out;
        QString err;
    };

    // Without any display, as on a server, but for `variables`. `prepare` runs in the child first.
    Outcome run(const QStringList& arguments, const QMap<QString, QString>& variables = {},
                const std::function<void()>& prepare = {}) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
            environment.remove(name);
        }
        environment.insert("XDG_RUNTIME_DIR", home_.path("."));
        for (auto variable = variables.cbegin(); variable != variables.cend(); ++variable) {
            environment.insert(variable.key(), variable.value());
        }
        QProcess program;
        program.setProcessEnvironment(environment);
        if (prepare) {
            program.setChildProcessModifier(prepare);
        }
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
        for (const char* option : {"--figure", "--windows", "--report", "--tolerance",
                                   "--algorithm", "--kappa", "--raw"}) {
            QVERIFY2(help.out.contains(option), option);
        }
        const Outcome mistyped = run({"--reprot", "x.pdf"});
        QCOMPARE(mistyped.status, 2);
        QVERIFY2(mistyped.err.contains("no option --reprot. Did you mean --report?"),
                 qPrintable(mistyped.err));
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
        VYBEG_MORE(widths.at(0), 300);
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
        QTest::newRow("figure without a name") << QStringList{good, "--figure", ""} << 2;
        QTest::newRow("windows and window")
            << QStringList{good, "--figure", figure, "--windows", "8,80", "--window", "80"} << 2;
        QTest::newRow("windows and periods")
            << QStringList{good, "--figure", figure, "--windows", "8", "--periods", "10"} << 2;
        QTest::newRow("figure twice")
            << QStringList{good, "--figure", figure, "--figure", figure} << 2;
        QTest::newRow("far electrode")
            << QStringList{good, "--figure", figure, "--angle-zero", "1e308"} << 2;
        QTest::newRow("missing") << QStringList{home_.path("none.wav"), "--figure", figure} << 3;
        QTest::newRow("empty") << QStringList{home_.file("empty.wav", ""), "--figure", figure} << 3;
        QTest::newRow("window too long")
            << QStringList{good, "--figure", figure, "--window", "1000000"} << 4;
        QTest::newRow("report without recording")
            << QStringList{"--report", home_.path("wrong.pdf")} << 2;
        QTest::newRow("report of a session beside a recording")
            << QStringList{home_.path("one.vybeg"), good, "--report", home_.path("wrong.pdf")} << 2;
        QTest::newRow("title without report") << QStringList{good, "--gyro", "SN_7"} << 2;
        QTest::newRow("list and recording")
            << QStringList{good, "--list", good, "--report", home_.path("wrong.pdf")} << 2;
        QTest::newRow("report and figure")
            << QStringList{good, "--figure", figure, "--report", home_.path("wrong.pdf")} << 2;
        QTest::newRow("report that is no PDF")
            << QStringList{good, "--report", home_.path("wrong.svg")} << 2;
        QTest::newRow("report twice over the same recording")
            << QStringList{good, good, "--report", home_.path("wrong.pdf")} << 4;
        QTest::newRow("report of two recordings with one channel D")
            << QStringList{good,       home_.recording("other.wav"), "--channel-d", good,
                           "--report", home_.path("wrong.pdf")}
            << 2;
        QTest::newRow("report of nothing")
            << QStringList{home_.path("none.wav"), "--report", home_.path("wrong.pdf")} << 3;
        QTest::newRow("report into no folder")
            << QStringList{good, "--report", home_.path("none/a.pdf")} << 5;
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
        QVERIFY(!QFile::exists(home_.path("wrong.pdf")));
    }

    void a_report_is_written_without_a_display_in_the_language_of_the_system_data() {
        QTest::addColumn<QString>("locale");
        QTest::addColumn<QString>("page");
        QTest::newRow("English") << "en_US.UTF-8"
                                 << "Page 1 of ";
        QTest::newRow("Russian") << "ru_RU.UTF-8"
                                 << "Страница 1 из ";
    }
    void a_report_is_written_without_a_display_in_the_language_of_the_system() {
        QFETCH(QString, locale);
        QFETCH(QString, page);
        const QString report = home_.path("report.pdf");
        const Outcome written =
            run({home_.recording("reported.wav"), "--report", report, "--tolerance", "skew=0.1deg"},
                {{"LC_ALL", locale}, {"LANGUAGE", locale.left(2)}});
        VYBEG_EQUAL(written.status, 0, qPrintable(written.err));
        QFile file(report);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.read(5) == "%PDF-");
        if (QStandardPaths::findExecutable("pdftotext").isEmpty()) {
            qWarning("pdftotext is missing: the report's text is not tested.");
            QSKIP("poppler-utils is missing");
        }
        QProcess reader;
        reader.start("pdftotext", {"-layout", report, "-"});
        QVERIFY(reader.waitForFinished());
        const QString text = QString::fromUtf8(reader.readAllStandardOutput());
        QVERIFY2(text.contains(page), qPrintable(text));
        QVERIFY(text.contains("reported.wav"));
        QFile samples(home_.path("reported.wav"));
        QVERIFY(samples.open(QIODevice::ReadOnly));
        const QByteArray hash =
            QCryptographicHash::hash(samples.readAll(), QCryptographicHash::Sha256).toHex();
        QVERIFY(text.contains(QString::fromLatin1(hash)));
    }

    // In different seconds, by different processes.
    void the_same_figure_and_report_are_the_same_bytes() {
        const QString recording = home_.recording("same.wav");
        const auto written = [&](const QString& name, const QStringList& arguments,
                                 const QMap<QString, QString>& variables = {}) {
            const QString path = home_.path(name);
            const Outcome outcome = run(arguments + QStringList{path}, variables);
            QFile file(path);
            return outcome.status == 0 && file.open(QIODevice::ReadOnly) ? file.readAll()
                                                                         : QByteArray();
        };
        const QMap<QString, QString> day{{"SOURCE_DATE_EPOCH", "1774958400"}};  // 2026-03-31 12:00Z
        std::vector<QByteArray> first;
        for (int round = 0; round < 2; ++round) {
            std::vector<QByteArray> all;
            for (const char* figure : {"a.pdf", "a.svg", "a.png"}) {
                all.push_back(written(figure, {recording, "--figure"}));
            }
            all.push_back(written("a-report.pdf", {recording, "--report"}, day));
            for (const QByteArray& bytes : all) {
                QVERIFY(!bytes.isEmpty());
            }
            if (round == 0) {
                first = all;
                const auto second = QDateTime::currentSecsSinceEpoch();
                QTRY_VERIFY(QDateTime::currentSecsSinceEpoch() > second);
            }
            QVERIFY(all == first);
        }
        if (!QStandardPaths::findExecutable("pdftotext").isEmpty()) {
            QProcess reader;
            reader.start("pdftotext", {"-layout", home_.path("a-report.pdf"), "-"});
            QVERIFY(reader.waitForFinished());
            const QByteArray text = reader.readAllStandardOutput();
            QVERIFY2(text.contains("2026-03-31, Vybeg"), text);
        }
    }

    // A chapter for each set of a list, also for the one that has no result; the title block from
    // the list.
    void a_list_is_reported_set_by_set() {
        if (QStandardPaths::findExecutable("pdftotext").isEmpty()) {
            qWarning("pdftotext is missing: the report's text is not tested.");
            QSKIP("poppler-utils is missing");
        }
        (void)home_.recording("listed_1.wav");
        (void)home_.recording("listed_2.wav");
        const QString list = home_.file("list.csv",
                                        "set,file,gyro,operator,comment\n"
                                        "first,listed_1.wav,SN_0042,Ivanov,cold\n"
                                        "second,listed_2.wav,SN_0043,Petrov,warm\n"
                                        "third,missing.wav,SN_0044,,\n");
        const QString report = home_.path("list.pdf");
        const auto text = [&report] {
            QProcess reader;
            reader.start("pdftotext", {"-layout", report, "-"});
            reader.waitForFinished();
            return QString::fromUtf8(reader.readAllStandardOutput()).simplified();
        };
        const Outcome all = run({"--list", list, "--report", report});
        VYBEG_EQUAL(all.status, 0, qPrintable(all.err));
        QVERIFY2(all.err.contains("missing.wav"), qPrintable(all.err));
        const QString told = text();
        for (const char* word : {"list.csv", "SN_0042", "SN_0043", "SN_0044", "Ivanov", "Petrov",
                                 "cold", "warm", "listed_1.wav", "listed_2.wav", "missing.wav"}) {
            QVERIFY2(told.contains(word), word);
        }
        const Outcome one = run({"--list", list, "--set", "second", "--report", report});
        VYBEG_EQUAL(one.status, 0, qPrintable(one.err));
        QVERIFY(text().contains("SN_0043") && !text().contains("SN_0042"));
        QCOMPARE(run({"--list", list, "--set", "third", "--report", report}).status, 3);
        QCOMPARE(run({"--list", list, "--set", "fourth", "--report", report}).status, 2);
        QCOMPARE(run({"--list", list}).status, 2);
        // Neither the list nor a recording gives its place to the report.
        const QString listed = home_.path("listed_1.pdf");
        QVERIFY(QFile::link(home_.path("listed_1.wav"), listed));
        QCOMPARE(run({"--list", list, "--report", listed}).status, 2);
        QCOMPARE(run({home_.path("listed_1.wav"), "--report", listed}).status, 2);
    }

    void the_command_line_fills_the_title_of_a_report() {
        const QString report = home_.path("title.pdf");
        const Outcome written =
            run({home_.recording("titled.wav"), "--report", report, "--gyro", "SN_7", "--operator",
                 "Сидоров", "--comment", "after balancing", "--number", "12/26", "--instrument",
                 "E-502", "--date", "2026-05-04", "--summary"});
        VYBEG_EQUAL(written.status, 0, qPrintable(written.err));
        if (QStandardPaths::findExecutable("pdftotext").isEmpty()) {
            QSKIP("poppler-utils is missing");
        }
        QProcess reader;
        reader.start("pdftotext", {"-layout", report, "-"});
        QVERIFY(reader.waitForFinished());
        const QString text = QString::fromUtf8(reader.readAllStandardOutput()).simplified();
        for (const char* word : {"SN_7", "Сидоров", "after balancing", "12/26", "E-502",
                                 "2026-05-04", "Page 1 of 1"}) {
            QVERIFY2(text.contains(word), qPrintable(text));
        }
    }

    void a_display_that_cannot_be_opened_is_a_sentence_data() {
        QTest::addColumn<QString>("variable");
        QTest::addColumn<QString>("value");
        QTest::addColumn<bool>("figure");
        QTest::newRow("X") << "DISPLAY"
                           << ":77777" << false;
        QTest::newRow("Wayland") << "WAYLAND_DISPLAY"
                                 << "wayland-77777" << false;
        QTest::newRow("platform") << "QT_QPA_PLATFORM"
                                  << "nonsense" << false;
        QTest::newRow("platform of a figure") << "QT_QPA_PLATFORM"
                                              << "nonsense" << true;
        QTest::newRow("X by name") << "QT_QPA_PLATFORM"
                                   << "xcb" << false;
    }
    void a_display_that_cannot_be_opened_is_a_sentence() {
        QFETCH(QString, variable);
        QFETCH(QString, value);
        QFETCH(bool, figure);
        QStringList arguments{home_.recording("good.wav")};
        if (figure) {
            arguments << "--figure" << home_.path("wrong.svg");
        }
        const Outcome outcome = run(arguments, {{variable, value}});
        VYBEG_EQUAL(outcome.status, 2, qPrintable(outcome.err));
        QVERIFY2(outcome.err.startsWith("vybeg: "), qPrintable(outcome.err));
        QCOMPARE(outcome.err.count('\n'), 1);
    }

    void a_figure_takes_no_recordings_place() {
        const QString recording = home_.path("plot.png");
        QVERIFY(QFile::copy(home_.recording("drawn.wav"), recording));
        const QString link = home_.path("link.svg");
        QVERIFY(QFile::link(recording, link));
        const auto bytes = [&] {
            QFile file(recording);
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        const QByteArray before = bytes();
        QVERIFY(!before.isEmpty());
        for (const QString& figure : {recording, home_.path("./plot.png"), link}) {
            const Outcome outcome =
                run({home_.recording("other.wav"), recording, "--figure", figure});
            VYBEG_EQUAL(outcome.status, 2, qPrintable(outcome.err));
            QVERIFY2(outcome.err.contains("--figure cannot be"), qPrintable(outcome.err));
            QVERIFY(bytes() == before);
        }
    }

    void a_disk_that_fills_leaves_the_old_figure_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("option");
        for (const char* name : {"full.svg", "full.pdf", "full.png"}) {
            QTest::newRow(name) << name << "--figure";
        }
        QTest::newRow("report.pdf") << "report.pdf"
                                    << "--report";
    }
    void a_disk_that_fills_leaves_the_old_figure() {
        QFETCH(QString, option);
        QFETCH(QString, name);
        const QString recording = home_.recording("full.wav", 0.2);
        QVERIFY(QDir().mkpath(home_.path("figures")));
        const QString figure = home_.path("figures/" + name);
        QCOMPARE(run({recording, option, figure}).status, 0);
        const qint64 whole = QFileInfo(figure).size();
        constexpr int sizes = 15;
        VYBEG_MORE(whole, sizes);
        for (int k = 0; k < sizes; ++k) {
            QFile old(figure);
            QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
            old.close();
            const auto most = static_cast<rlim_t>(whole * k / sizes);
            const Outcome outcome = run({recording, option, figure}, {}, [most] {
                const rlimit both{most, most};
                setrlimit(RLIMIT_FSIZE, &both);
            });
            const QString about = QString("%1 bytes: %2").arg(most).arg(outcome.err);
            VYBEG_EQUAL(outcome.status, 5, qPrintable(about));
            QVERIFY2(outcome.err.contains("cannot be written"), qPrintable(about));
            QCOMPARE(outcome.err.count('\n'), 1);
            QVERIFY(old.open(QIODevice::ReadOnly));
            QVERIFY2(old.readAll() == "old", qPrintable(about));
            QCOMPARE(QDir(home_.path("figures"))
                         .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
                     QStringList{name});
        }
        QVERIFY(QFile::remove(figure));
    }

    void closed_standard_descriptors_put_nothing_into_the_figure() {
        const QString recording = home_.recording("closed.wav");
        const auto bytes = [this](const QString& name) {
            QFile file(home_.path(name));
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        // --rate has no effect here, which is warned of.
        QCOMPARE(run({recording, "--figure", home_.path("usual.png")}).status, 0);
        const Outcome closed =
            run({recording, "--rate", "1", "--figure", home_.path("shut.png")}, {}, [] {
                for (const int descriptor : {0, 1, 2}) {
                    close(descriptor);
                }
            });
        QCOMPARE(closed.status, 0);
        QVERIFY(!bytes("usual.png").isEmpty());
        QVERIFY(bytes("shut.png") == bytes("usual.png"));
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

VYBEG_TEST(TestProgram)

}  // namespace test_program

#include "test_program.moc"
