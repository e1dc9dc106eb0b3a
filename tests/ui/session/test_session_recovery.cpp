// A program killed at any moment leaves a whole copy of its session, which the next one recovers.
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/message_bar.h"
#include "ui/session/session_backup.h"
#include "ui/session/session_keeper.h"
#include "ui/window/main_window.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QPushButton>
#include <QTest>

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
        qputenv("XDG_DATA_HOME", home_.path("data").toUtf8());
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
        const QString recording = home_.recording("recovered.wav");
        const auto program = started({recording, "--window", "77"});
        QVERIFY(program);
        QTRY_VERIFY_WITH_TIMEOUT(!copies().entryList({"*.vybeg"}, QDir::Files).isEmpty(), 20000);
        QVERIFY(SessionBackup::abandoned().isEmpty());  // it still runs
        program->kill();
        QVERIFY(program->waitForFinished());
        QCOMPARE(SessionBackup::abandoned().size(), 1);

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

    // Killed once more before it has a copy of its own, the program leaves the first one.
    void a_copy_stays_until_there_is_another_one() {
        const auto program = started({home_.recording("twice.wav")});
        QVERIFY(program);
        QTRY_VERIFY_WITH_TIMEOUT(!copies().entryList({"*.vybeg"}, QDir::Files).isEmpty(), 20000);
        program->kill();
        QVERIFY(program->waitForFinished());
        const QStringList left = SessionBackup::abandoned();
        QCOMPARE(left.size(), 1);
        const auto window = shownWindow();
        window->session().offerAbandoned();
        QTest::mouseClick(childOf<MessageBar>(*window).findChild<QPushButton*>(), Qt::LeftButton);
        QVERIFY(QFile::exists(left.first()));
        QTRY_VERIFY(!QFile::exists(left.first()));
        QCOMPARE(copies().entryList({"*.vybeg"}, QDir::Files).size(), 1);  // its own
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

VYBEG_TEST(TestSessionRecovery)

}  // namespace test_session_recovery

#include "test_session_recovery.moc"
