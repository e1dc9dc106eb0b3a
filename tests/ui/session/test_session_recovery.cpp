// A program killed at any moment leaves a whole copy of its session, which the next one recovers.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/message_bar.h"
#include "ui/session/session_keeper.h"
#include "ui/session/session_writer.h"
#include "ui/window/main_window.h"
#include "ui/window/status_line.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <random>
#include <sys/stat.h>

namespace test_session_recovery {

using namespace vybeg::ui;

class TestSessionRecovery : public QObject {
    Q_OBJECT

    GuiTestHome home_;

    // Where this program and the killed ones keep their copies.
    QDir copies() {
        return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/backups");
    }

    // Whether this process is one that a_killed_recovery_loses_nothing() starts and kills.
    static bool isRecovering() { return qEnvironmentVariableIsSet("VYBEG_RECOVERING"); }

    // Whether a killed program has left the only copy, of the recording in windows of 77 samples.
    bool leaveCopyOf(const QString& recording) {
        const auto program = started({recording, "--window", "77"});
        const bool copied =
            program &&
            QTest::qWaitFor(
                [this] { return !copies().entryList({"*.vybeg"}, QDir::Files).isEmpty(); }, 20000);
        // It still runs.
        const bool locked = SessionBackup::abandoned().isEmpty();
        program->kill();
        return program->waitForFinished() && copied && locked &&
               SessionBackup::abandoned().size() == 1;
    }

    std::unique_ptr<QProcess> started(const QStringList& arguments) {
        auto program = std::make_unique<QProcess>();
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("QT_QPA_PLATFORM", "offscreen");
        environment.insert("XDG_DATA_HOME", home_.path("data"));
        environment.insert("XDG_CONFIG_HOME", home_.path("config"));
        program->setProcessEnvironment(environment);
        program->start(VYBEG_PROGRAM, arguments);
        return program->waitForStarted() ? std::move(program) : nullptr;
    }

private slots:
    void initTestCase() {
        // As the program itself: its own name, and no folder of Qt's for tests.
        QStandardPaths::setTestModeEnabled(false);
        QCoreApplication::setOrganizationName(QStringLiteral("vybeg"));
        QCoreApplication::setApplicationName(QStringLiteral("vybeg"));
        if (!isRecovering()) {
            qputenv("XDG_DATA_HOME", home_.path("data").toUtf8());
        }
    }

    void a_killed_program_leaves_a_whole_copy_or_none() {
        const QString recording = home_.recording("killed.wav");
        std::mt19937_64 random(5);
        // Up to twice the time after which the first copy is there.
        QElapsedTimer needed;
        needed.start();
        const auto first = started({recording});
        QTRY_VERIFY_WITH_TIMEOUT(!copies().entryList({"*.vybeg"}, QDir::Files).isEmpty(), 60000);
        std::uniform_int_distribution<int> any_ms(0, static_cast<int>(2 * needed.elapsed()));
        first->kill();
        QVERIFY(first->waitForFinished());
        for (const QString& path : SessionBackup::abandoned()) {
            SessionBackup::discard(path);
        }
        int copied = 0;
        for (int round = 0; round < 20; ++round) {
            const auto program = started({recording});
            QVERIFY(program);
            QTest::qWait(any_ms(random));  // the moment of the kill
            QCOMPARE(program->state(), QProcess::Running);
            program->kill();
            QVERIFY(program->waitForFinished());
            for (const QString& path : SessionBackup::abandoned()) {
                QFile file(path);
                QVERIFY(file.open(QIODevice::ReadOnly));
                const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
                QCOMPARE(json["vybeg_session"].toInt(), 1);
                QCOMPARE(json["recordings"].toArray().size(), 1);
                ++copied;
                SessionBackup::discard(path);
            }
        }
        VYBEG_MORE(copied, 0);
        VYBEG_LESS(copied, 20);
        QVERIFY(QFile::exists(recording));
    }

    void the_next_program_recovers_it() {
        QVERIFY(leaveCopyOf(home_.recording("recovered.wav")));
        const auto window = shownWindow();
        window->session().offerAbandoned();
        auto& bar = childOf<MessageBar>(*window);
        QVERIFY(bar.texts().join('\n').contains("can be recovered"));
        QTest::mouseClick(bar.findChild<QPushButton*>(), Qt::LeftButton);
        QTRY_VERIFY(!window->document().busy() && window->document().analyses().size() == 1);
        QCOMPARE(window->document().analyses().front().shown.analysis->plan.length, 77);
        QTRY_VERIFY(window->session().isModified());  // until it is saved
        QTRY_VERIFY(SessionBackup::abandoned().isEmpty());
        window->session().end();
    }

    // The window that a_killed_recovery_loses_nothing() kills; by itself, a recovery to its end.
    void a_recovery_leaves_one_copy() {
        if (!isRecovering()) {
            QVERIFY(leaveCopyOf(home_.recording("alone.wav")));
        }
        const QStringList left = SessionBackup::abandoned();
        QCOMPARE(left.size(), 1);
        const auto window = shownWindow();
        window->session().offerAbandoned();
        QTest::mouseClick(childOf<MessageBar>(*window).findChild<QPushButton*>(), Qt::LeftButton);
        QTRY_VERIFY(!QFile::exists(left.first()));
        QCOMPARE(copies().entryList({"*.vybeg"}, QDir::Files).size(), 1);
        if (isRecovering()) {
            QTest::qWait(60000);  // for the kill
        }
        window->session().end();
    }

    // Each process recovers what the one before it has left, and is killed at any moment of that:
    // 10 times, or as often as VYBEG_KILLS says.
    void a_killed_recovery_loses_nothing() {
        QVERIFY(leaveCopyOf(home_.recording("lasts.wav")));
        const auto recovering = [this] {
            auto program = std::make_unique<QProcess>();
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert("VYBEG_RECOVERING", "1");
            program->setProcessEnvironment(environment);
            program->start(QCoreApplication::applicationFilePath(),
                           {"TestSessionRecovery", "a_recovery_leaves_one_copy"});
            return program->waitForStarted() ? std::move(program) : nullptr;
        };
        QElapsedTimer needed;
        needed.start();
        const QString first = SessionBackup::abandoned().value(0);
        const auto undisturbed = recovering();
        QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists(first), 60000);
        std::uniform_int_distribution<int> any_ms(0, static_cast<int>(3 * needed.elapsed() / 2));
        undisturbed->kill();
        QVERIFY(undisturbed->waitForFinished());

        bool given = false;
        const int wanted = qEnvironmentVariableIntValue("VYBEG_KILLS", &given);
        const int kills = given ? wanted : 10;
        std::mt19937_64 random(25);
        int replaced = 0;
        for (int k = 0; k < kills; ++k) {
            const QStringList before = SessionBackup::abandoned();
            const auto program = recovering();
            QVERIFY(program);
            QTest::qWait(any_ms(random));  // the moment of the kill
            QVERIFY2(program->state() == QProcess::Running, program->readAllStandardOutput());
            program->kill();
            QVERIFY(program->waitForFinished());
            QStringList left = SessionBackup::abandoned();
            QVERIFY(!left.isEmpty());
            for (const QString& path : left) {
                QFile file(path);
                QVERIFY(file.open(QIODevice::ReadOnly));
                const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
                QCOMPARE(json["recordings"].toArray().size(), 1);
                QCOMPARE(json["settings"]["window"].toVariant().toInt(), 77);
            }
            replaced += left.last() != before.last() ? 1 : 0;
            while (left.size() > 1) {  // between the new copy and the old one's end
                SessionBackup::discard(left.takeFirst());
            }
        }
        VYBEG_MORE(replaced, 0);
        VYBEG_LESS(replaced, kills);
        SessionBackup::discard(SessionBackup::abandoned().first());
    }

    // Killed once more before it has a copy of its own, the program leaves the first one.
    void a_copy_stays_until_there_is_another_one() {
        QVERIFY(leaveCopyOf(home_.recording("twice.wav")));
        const QStringList left = SessionBackup::abandoned();
        const auto window = shownWindow();
        window->session().offerAbandoned();
        QTest::mouseClick(childOf<MessageBar>(*window).findChild<QPushButton*>(), Qt::LeftButton);
        QVERIFY(QFile::exists(left.first()));
        QTRY_VERIFY(!QFile::exists(left.first()));
        QCOMPARE(copies().entryList({"*.vybeg"}, QDir::Files).size(), 1);  // its own
        window->session().end();
    }

    void a_copy_that_is_declined_stays_and_is_not_offered_again() {
        const QString copy = home_.file("declined.vybeg", "{}");
        QVERIFY(copies().mkpath("."));
        const QString left = copies().filePath("20260101-000000-000-1.vybeg");
        QVERIFY(QFile::copy(copy, left));
        QVERIFY(SessionBackup::abandoned().contains(left));
        SessionBackup::setAside(left);
        QVERIFY(!SessionBackup::abandoned().contains(left));
        QVERIFY(QFile::remove(left + ".declined"));
    }

    // One line, whatever the number of copies; a name tells which session it is.
    void the_newest_copy_is_offered_first_and_says_what_it_holds() {
        QVERIFY(copies().mkpath("."));
        const auto left = [this](const char* name, const char* json) {
            const QString path = copies().filePath(QLatin1String(name));
            QFile file(path);
            return file.open(QIODevice::WriteOnly) && file.write(json) > 0 ? path : QString();
        };
        const QString older =
            left("20260101-000000-000-1.vybeg",
                 R"({"vybeg_session": 1, "recordings": [{"path": "/a/r.1.wav"}]})");
        const QString newer = left("20260101-000001-000-1.vybeg",
                                   R"({"vybeg_session": 1, "gyro": {"serial": "HRG-17"},
                                       "recordings": [{"path": "/a/r2.wav"}, {"path": "/b.wav"}]})");
        const auto window = shownWindow();
        window->session().offerAbandoned();
        auto& bar = childOf<MessageBar>(*window);
        QCOMPARE(bar.texts().size(), 1);
        QVERIFY2(bar.texts().first().contains("HRG-17, 2 recordings, 20"),
                 qPrintable(bar.texts().first()));
        QVERIFY2(bar.texts().first().startsWith("Session 1 of 2"), qPrintable(bar.texts().first()));
        const auto press = [&bar](const QString& text) {
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            for (QPushButton* button : bar.findChildren<QPushButton*>()) {
                if (button->text() == text) {
                    QTest::mouseClick(button, Qt::LeftButton);
                    return;
                }
            }
            QFAIL(qPrintable(text));
        };
        press("Another…");  // looks at the older one, and back
        QVERIFY2(bar.texts().first().contains("r.1, 1 recording, 20"),
                 qPrintable(bar.texts().first()));
        press("Another…");
        QVERIFY(bar.texts().first().contains("HRG-17"));
        QVERIFY(SessionBackup::abandoned().contains(newer));
        press("Forget");
        QVERIFY(childOf<StatusLine>(*window).text().contains(newer + ".declined"));
        QCOMPARE(bar.texts().size(), 1);
        QVERIFY2(bar.texts().first().contains("r.1, 1 recording, 20"),
                 qPrintable(bar.texts().first()));
        SessionBackup::discard(older);
        QVERIFY(QFile::remove(newer + ".declined"));
        window->session().end();
    }

    void a_copy_that_cannot_be_read_stays_and_is_named() {
        QVERIFY(copies().mkpath("."));
        const QString path = copies().filePath("20260101-000000-000-1.vybeg");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\"vybeg_session\": ");
        file.close();
        const auto window = shownWindow();
        window->session().offerAbandoned();
        auto& bar = childOf<MessageBar>(*window);
        QTest::mouseClick(bar.findChild<QPushButton*>(), Qt::LeftButton);
        QTRY_VERIFY(bar.texts().join('\n').contains(path));
        QTest::qWait(600);  // past the moment of the next copy
        QVERIFY(QFile::exists(path));
        SessionBackup::discard(path);
        window->session().end();
    }

    // Neither waits for a writer nor reads without end.
    void what_is_no_file_is_no_session() {
        const QString pipe = home_.path("pipe.vybeg");
        QCOMPARE(mkfifo(pipe.toUtf8().constData(), 0600), 0);
        const auto window = shownWindow();
        for (const QString& path : {pipe, QStringLiteral("/dev/zero"), home_.path(".")}) {
            QVERIFY(!window->session().openSession(path));
            QVERIFY2(childOf<MessageBar>(*window).texts().join('\n').contains(path),
                     qPrintable(path));
        }
    }

    void a_program_that_ends_leaves_none() {
        const auto window = shownWindow();
        window->document().open({home_.recording("ends.wav")});
        QTRY_VERIFY(!copies().entryList({"*.vybeg"}, QDir::Files).isEmpty());
        QVERIFY(window->close());
        QVERIFY(copies().entryList({"*.vybeg"}, QDir::Files).isEmpty());
    }
};

VYBEG_TEST(TestSessionRecovery, first)

}  // namespace test_session_recovery

#include "test_session_recovery.moc"
