// Sessions on a slow or failing disk: the window goes on, the newest state wins, closing loses
// nothing.
#include "core/output/output_file.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/heartbeat.h"
#include "ui/panels/message_bar.h"
#include "ui/session/session_keeper.h"
#include "ui/session/session_writer.h"

#include <QFile>
#include <QJsonDocument>
#include <QMessageBox>
#include <QMutex>
#include <QTest>
#include <QThread>

#include <memory>

namespace test_session_writer {

using namespace vybeg;
using namespace vybeg::ui;

class TestSessionWriter : public QObject {
    Q_OBJECT

    GuiTestHome home_;
    QMutex lock_;
    QStringList written_;  // "name: state", in the order of writing

    // A disk that takes so long for each file.
    void useDisk(unsigned long ms, bool works = true) {
        SessionWriter::setDisk(
            [this, ms, works](const QString& path, const QByteArray& bytes) -> Status {
                QThread::msleep(ms);
                if (!works) {
                    return Error{ErrorCode::output_failed, path.toStdString(), {"no space"}};
                }
                {
                    const QMutexLocker locker(&lock_);
                    const int state = QJsonDocument::fromJson(bytes).object()["state"].toInt();
                    written_ << QStringLiteral("%1: %2").arg(path).arg(state);
                }
                return write_file(path.toStdU16String(), bytes.toStdString(), JobControl());
            });
    }

    static bool isSession(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) &&
               QJsonDocument::fromJson(file.readAll()).object()["vybeg_session"].toInt() == 1;
    }

    std::unique_ptr<MainWindow> windowWith(const QString& recording) {
        auto window = shownWindow();
        window->document().open({home_.recording(recording)});
        const bool open = QTest::qWaitFor(
            [&] { return !window->document().busy() && window->document().analyses().size() == 1; },
            20000);
        return open ? std::move(window) : nullptr;
    }

private slots:
    void init() { written_.clear(); }
    void cleanup() { SessionWriter::setDisk({}); }

    void of_the_states_that_wait_for_a_file_the_newest_is_written() {
        useDisk(100);
        SessionWriter writer;
        int done = 0;
        const auto write = [&](const char* name, int state) {
            writer.write(home_.path(name), {{"state", state}},
                         [&](const Result<QByteArray>& digest) { done += digest ? 1 : 0; });
        };
        for (int state = 1; state <= 5; ++state) {
            write("one.vybeg", state);
        }
        write("two.vybeg", 6);
        writer.finish();
        const QString one = home_.path("one.vybeg");
        QCOMPARE(written_,
                 (QStringList{one + ": 1", one + ": 5", home_.path("two.vybeg") + ": 6"}));
        QCOMPARE(done, 6);
        QVERIFY(!writer.busy());
    }

    void a_writer_that_goes_has_written_all() {
        useDisk(100);
        {
            SessionWriter writer;
            const auto never = [](const Result<QByteArray>&) { QFAIL("its owner is gone"); };
            writer.write(home_.path("gone.vybeg"), {{"state", 1}}, never);
            writer.write(home_.path("gone.vybeg"), {{"state", 2}}, never);
        }
        QCOMPARE(written_.last(), home_.path("gone.vybeg") + ": 2");
    }

    void a_slow_disk_does_not_stop_the_window() {
        const auto window = windowWith("slow.wav");
        QVERIFY(window);
        useDisk(1500);
        Heartbeat heart;
        window->session().save(home_.path("slow.vybeg"));
        heart.reset();
        QTRY_VERIFY_WITH_TIMEOUT(!window->session().isSaving(), 20000);
        VYBEG_MORE(heart.beats(), 20, qPrintable(heart.text()));
        VYBEG_LESS(heart.longestMs(), 500, qPrintable(heart.text()));
        QVERIFY(isSession(home_.path("slow.vybeg")));
        window->session().end();
    }

    void closing_waits_for_the_session_that_is_being_saved() {
        const auto window = windowWith("closed.wav");
        QVERIFY(window);
        useDisk(800);
        const QString path = home_.path("closed.vybeg");
        window->session().save(path);
        QVERIFY(!window->close());
        QVERIFY(!QFile::exists(path));
        QTRY_VERIFY_WITH_TIMEOUT(!window->isVisible(), 20000);
        QVERIFY(isSession(path));
        QVERIFY(!window->findChild<QMessageBox*>());
    }

    void a_session_that_cannot_be_written_is_told_and_keeps_the_window() {
        const auto window = windowWith("full.wav");
        QVERIFY(window);
        useDisk(200, false);
        QVERIFY(!savedTo(*window, home_.path("full.vybeg")));
        QVERIFY(childOf<MessageBar>(*window).texts().join('\n').contains("no space"));
        QVERIFY(window->session().path().isEmpty());
        SessionWriter::setDisk({});
        QVERIFY(savedTo(*window, home_.path("full.vybeg")));
        QVERIFY(!window->session().isModified());
        window->document().dossier().setGyro({"17", {}, {}, {}});
        useDisk(200, false);
        window->session().save(home_.path("full.vybeg"));
        QVERIFY(!window->close());
        QTRY_VERIFY(window->findChild<QMessageBox*>());  // the change is not in the file
        QVERIFY(window->isVisible());
        window->session().end();
    }
};

VYBEG_TEST(TestSessionWriter, threads)

}  // namespace test_session_writer

#include "test_session_writer.moc"
