// The report of a session, as the program writes it without a window.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"

#include <QFile>
#include <QProcess>
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

private slots:
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
