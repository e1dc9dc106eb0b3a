// The file of a session: what others wrote into it is neither lost nor mistaken.
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/message_bar.h"
#include "ui/session/session_keeper.h"
#include "ui/window/file_commands.h"

#include <QAbstractButton>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMessageBox>
#include <QtTest>

#include <cmath>

namespace test_session_file {

using namespace vybeg;
using namespace vybeg::ui;

class TestSessionFile : public QObject, private WindowTest {
    Q_OBJECT

    SessionKeeper& session() { return window_->session(); }
    QString messages() { return childOf<MessageBar>(*window_).texts().join('\n'); }

    static QByteArray bytesOf(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    static QJsonObject jsonOf(const QString& path) {
        return QJsonDocument::fromJson(bytesOf(path)).object();
    }

    // A session of one recording and one set, saved.
    QString saved(const QString& name) {
        window_->files().open({home_.recording(name + ".wav")});
        [&] { QTRY_COMPARE_WITH_TIMEOUT(document().analyses().size(), std::size_t(1), 20000); }();
        document().sets().addToCurrent({document().recordings()[0].id});
        const QString path = home_.path(name + ".vybeg");
        return savedTo(*window_, path) ? path : QString();
    }

    void opened(const QString& path) {
        window_ = shownWindow();
        window_->files().open({path});
        QTRY_VERIFY_WITH_TIMEOUT(!document().analyses().empty() && !session().isOpening(), 20000);
    }

    QMessageBox& question() { return childOf<QMessageBox>(*window_); }
    void press(const char* text) {
        for (QAbstractButton* button : question().buttons()) {
            if (button->text().remove('&') == QLatin1String(text)) {
                button->click();
                return;
            }
        }
        QFAIL(text);
    }

private slots:
    void init() { window_ = shownWindow(); }
    void cleanup() { session().end(); }

    void what_a_later_version_knows_of_recordings_and_sets_is_kept() {
        const QString path = saved("later");
        QJsonObject json = jsonOf(path);
        const auto add = [&json](const char* list) {
            QJsonArray array = json[list].toArray();
            QJsonObject element = array[0].toObject();
            element["later"] = list;
            array[0] = element;
            json[list] = array;
        };
        add("recordings");
        add("sets");
        home_.file("later.vybeg", QJsonDocument(json).toJson());
        opened(path);
        document().dossier().setGyro({"17", {}, {}, {}});
        QVERIFY(savedTo(*window_, path));
        for (const char* list : {"recordings", "sets"}) {
            QCOMPARE(jsonOf(path)[list].toArray()[0].toObject()["later"].toString(), list);
        }
    }

    void a_wrong_kind_of_value_is_named_and_nothing_is_opened() {
        const QJsonObject sound = jsonOf(saved("sound"));
        for (const char* key :
             {"recordings", "sets", "settings", "gyro", "limits", "passport", "view"}) {
            for (const QJsonValue& wrong :
                 {QJsonValue("text"), QJsonValue(7), QJsonValue(QJsonArray{1, 2})}) {
                QJsonObject json = sound;
                json[key] = wrong;
                childOf<MessageBar>(*window_).clear();
                window_->files().open({home_.file("wrong.vybeg", QJsonDocument(json).toJson())});
                QVERIFY2(messages().contains("damaged") && messages().contains(key),
                         qPrintable(key + messages()));
                QCOMPARE(session().path(), home_.path("sound.vybeg"));
                QCOMPARE(document().recordings().size(), std::size_t(1));
            }
        }
    }

    void a_setting_that_none_can_have_is_named_with_its_file() {
        QJsonObject json = jsonOf(saved("sound"));
        json["tolerance"] = "nOne";
        window_->files().open({home_.file("wrong.vybeg", QJsonDocument(json).toJson())});
        QVERIFY2(messages().contains("wrong.vybeg cannot be opened") && messages().contains("nOne"),
                 qPrintable(messages()));
        QCOMPARE(session().path(), home_.path("sound.vybeg"));
    }

    void a_recording_under_another_name_is_found_by_its_content() {
        const QString path = saved("renamed");
        QTRY_VERIFY(!document().recordings()[0].sha256.isEmpty());
        QVERIFY(savedTo(*window_, path));
        QVERIFY(QFile::rename(home_.path("renamed.wav"), home_.path("another.wav")));
        opened(path);
        QCOMPARE(document().recordings().size(), std::size_t(1));
        QCOMPARE(document().recordings()[0].path, home_.path("another.wav"));
        QCOMPARE(messages(), QString());
    }

    void the_file_of_channel_d_and_pieces_move_with_their_session() {
        QByteArray c("t,C\n");
        QByteArray d("t,D\n");
        for (int k = 0; k < 8000; ++k) {
            const double t_s = k / 8000.0;
            const QByteArray time = QByteArray::number(t_s, 'f', 6) + ',';
            c += time + QByteArray::number(std::cos(6283 * t_s), 'f', 6) + '\n';
            d += time + QByteArray::number(0.4 * std::cos(6283 * t_s), 'f', 6) + '\n';
        }
        OpenOptions options;
        QVERIFY(QDir().mkpath(home_.path("pair")));
        home_.file("pair/c.csv", c);
        options.channel_d_file = home_.file("pair/d.csv", d).toStdString();
        document().open({home_.path("pair/c.csv")}, options);
        QTRY_COMPARE_WITH_TIMEOUT(document().recordings().size(), std::size_t(1), 20000);
        QTRY_VERIFY(document().recordings()[0].recording.has_value());
        QVERIFY(savedTo(*window_, home_.path("pair/one.vybeg")));
        QVERIFY(QDir().rename(home_.path("pair"), home_.path("moved")));
        window_ = shownWindow();
        window_->files().open({home_.path("moved/one.vybeg")});
        QTRY_COMPARE_WITH_TIMEOUT(document().recordings().size(), std::size_t(1), 20000);
        QTRY_VERIFY2(document().recordings()[0].recording.has_value(), qPrintable(messages()));
        QCOMPARE(document().recordings()[0].recording->more_files.size(), std::size_t(1));
    }

    // Two programs have the same session open; both save it.
    void changes_of_another_program_are_not_replaced_unasked() {
        const QString path = saved("shared");
        opened(path);
        QVERIFY(!session().isChangedElsewhere());
        document().dossier().setGyro({"here", {}, {}, {}});
        QJsonObject other = jsonOf(path);
        other["gyro"] = QJsonObject{{"serial", "there"}};
        const QByteArray theirs = QJsonDocument(other).toJson();
        home_.file("shared.vybeg", theirs);
        QTest::keyClick(window_.get(), Qt::Key_S, Qt::ControlModifier);
        QVERIFY(question().text().contains("shared.vybeg"));
        press("Cancel");
        QCOMPARE(bytesOf(path), theirs);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        window_->files().saveSession();
        press("Replace");
        QTRY_VERIFY(!session().isSaving());
        QCOMPARE(jsonOf(path)["gyro"].toObject()["serial"].toString(), QString("here"));
        // Its own file is no other program's.
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        document().dossier().setGyro({"here again", {}, {}, {}});
        window_->files().saveSession();
        QTRY_VERIFY(!session().isSaving());
        QVERIFY(!window_->findChild<QMessageBox*>());
        QCOMPARE(jsonOf(path)["gyro"].toObject()["serial"].toString(), QString("here again"));
    }
};

VYBEG_TEST(TestSessionFile)

}  // namespace test_session_file

#include "test_session_file.moc"
