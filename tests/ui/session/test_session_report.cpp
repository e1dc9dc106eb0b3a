// The report of a session, as the program writes it without a window.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QtEndian>
#include <QtTest>

namespace test_session_report {

using namespace vybeg::ui;

class TestSessionReport : public QObject {
    Q_OBJECT

    GuiTestHome home_;

    struct Outcome {
        int status;
        QString err;
    };

    static Outcome run(const QStringList& arguments) {
        QProcess program;
        program.start(VYBEG_PROGRAM, arguments);
        program.waitForFinished(60000);
        return {program.exitStatus() == QProcess::NormalExit ? program.exitCode() : -1,
                QString::fromUtf8(program.readAllStandardError())};
    }

    // A recording that states its date, in a list of informations behind its samples.
    QString dated(const QString& name) {
        QFile file(home_.recording(name));
        if (!file.open(QIODevice::ReadWrite)) {
            return {};
        }
        const QByteArray list(
            "LIST\x16\0\0\0INFOICRD\x0a\0\0\0"
            "2026-11-28",
            30);
        QByteArray bytes = file.readAll() + list;
        qToLittleEndian(static_cast<quint32>(bytes.size() - 8), bytes.data() + 4);
        file.seek(0);
        file.write(bytes);
        return file.fileName();
    }

    // The date of measurement in the title of the report that the arguments make.
    QString dateOf(const QStringList& arguments) {
        const QString report = home_.path("dated.pdf");
        const Outcome made = run(arguments + QStringList{"--report", report, "--summary"});
        QProcess reader;
        reader.start("pdftotext", {"-layout", report, "-"});
        reader.waitForFinished();
        static const QRegularExpression date(QStringLiteral("Date of measurement +(\\S+)"));
        return made.status == 0 ? date.match(reader.readAllStandardOutput()).captured(1) : made.err;
    }

private slots:
    // Of a list comes first, then that of the command line, then that of the files, whether a
    // session has them or not.
    void the_date_of_the_command_line_takes_the_place_of_that_of_the_files() {
        if (QStandardPaths::findExecutable("pdftotext").isEmpty()) {
            QSKIP("poppler-utils is missing");
        }
        const QString recording = dated("dated.wav");
        const auto session = [this](const char* name, const char* sets) {
            return home_.file(name, QByteArray(R"({"vybeg_session": 1, "recordings": [
                    {"path": "dated.wav", "runs": [{"name": "run"}]}], "current": 0, "sets": [)") +
                                        sets + "]}");
        };
        const QString with_set = session("with.vybeg", R"({"name": "S", "recordings": [0]})");
        const QString without_set = session("without.vybeg", "");
        for (const QString& input : {recording, with_set, without_set}) {
            QCOMPARE(dateOf({input}), QString("2026-11-28"));
            QCOMPARE(dateOf({input, "--date", "2026-05-04"}), QString("2026-05-04"));
        }
        const QString list = home_.file("dated.csv", "file,date\ndated.wav,2025-01-02\n");
        QCOMPARE(dateOf({"--list", list, "--date", "2026-05-04"}), QString("2025-01-02"));
    }

    void a_session_has_its_report_without_a_display() {
        home_.recording("of_session.wav");
        const QString report = home_.path("session.pdf");
        const QString session = home_.file("report.vybeg", R"({"vybeg_session": 1,
            "recordings": [{"path": "of_session.wav",
                            "runs": [{"name": "run", "settings": {"window": "80"}}]}],
            "sets": [{"name": "S", "recordings": [0]}], "gyro": {"serial": "HRG-5"}})");
        const Outcome made = run({session, "--report", report});
        VYBEG_EQUAL(made.status, 0, qPrintable(made.err));
        QFile file(report);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray pdf = file.readAll();
        QVERIFY(pdf.startsWith("%PDF-"));
        VYBEG_MORE(pdf.size(), 20'000);
        const Outcome idle = run({session, "--report", home_.path("idle.pdf"), "--kappa", "1.5",
                                  "--channels", "2,1", "--tolerance", "kappa=0.1"});
        QCOMPARE(idle.status, 0);
        for (const QString option : {"--kappa", "--channels", "--tolerance"}) {
            QVERIFY2(idle.err.contains(option + " has no effect"), qPrintable(idle.err));
        }
        const Outcome lacking =
            run({home_.file("lacking.vybeg", R"({"vybeg_session": 1, "recordings": [
                     {"path": "of_session.wav"}, {"path": "no.wav"}],
                     "sets": [{"name": "S", "recordings": [0, 1]}]})"),
                 "--report", home_.path("lacking.pdf")});
        QCOMPARE(lacking.status, 2);
        QVERIFY2(lacking.err.contains("a recording of the set S is not there"),
                 qPrintable(lacking.err));
        QVERIFY(!QFile::exists(home_.path("lacking.pdf")));
        // Likewise where it cannot be read.
        home_.file("empty.wav", "");
        const Outcome unread =
            run({home_.file("unread.vybeg", R"({"vybeg_session": 1, "recordings": [
                     {"path": "of_session.wav"}, {"path": "empty.wav"}],
                     "sets": [{"name": "S", "recordings": [0, 1]}]})"),
                 "--report", home_.path("lacking.pdf")});
        QCOMPARE(unread.status, 2);
        QVERIFY2(unread.err.contains("a recording of the set S is not there, or cannot be read"),
                 qPrintable(unread.err));
        const Outcome broken = run({home_.file("broken.vybeg", "{"), "--report", report});
        QCOMPARE(broken.status, 3);
        QVERIFY2(broken.err.contains("not a session that can be read"), qPrintable(broken.err));
        file.seek(0);
        QCOMPARE(file.readAll(), pdf);  // the report of before stays
        const Outcome gone =
            run({home_.file("gone.vybeg",
                            R"({"vybeg_session": 1, "recordings": [{"path": "no.wav"}]})"),
                 "--report", report});
        QCOMPARE(gone.status, 2);
    }
};

VYBEG_TEST(TestSessionReport)

}  // namespace test_session_report

#include "test_session_report.moc"
