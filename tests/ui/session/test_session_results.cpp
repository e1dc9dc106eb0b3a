// Sessions keep what was identified, also where the recordings are away.
#include "core/output/passport_json.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/resonator_runs.h"
#include "ui/panels/message_bar.h"
#include "ui/resonator/resonator_page.h"
#include "ui/session/session.h"
#include "ui/session/session_keeper.h"
#include "ui/widgets/quantity_table.h"
#include "ui/window/file_commands.h"
#include "ui/window/main_window.h"

#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QGuiApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLabel>
#include <QPushButton>
#include <QStandardPaths>
#include <QTest>

namespace test_session_results {

using namespace vybeg;
using namespace vybeg::ui;

class TestSessionResults : public QObject, private WindowTest {
    Q_OBJECT

    // A session of an identified set, and what its window shows.
    struct Stored {
        QString path;
        QString resonator, modes, runs, waves;  // all numbers of the tables
        QString warnings, state;
    };

    QStringList files_;
    Stored fresh_;
    Stored stale_;

    SessionKeeper& session() { return window_->session(); }

    void waitIdle() {
        QVERIFY(
            QTest::qWaitFor([&] { return !document().busy() && !session().isOpening(); }, 60000));
    }

    // Four runs as a set, identified: as they are, and with settings that change afterwards.
    void identifyOnce() {
        window_ = shownWindow();
        window_->action(Command::page_resonator)->trigger();
        document().open(files_);
        QVERIFY(QTest::qWaitFor(
            [&] {
                return !document().busy() &&
                       std::ranges::all_of(document().recordings(), [](const auto& entry) {
                           return entry.recording && !entry.sha256.isEmpty();
                       });
            },
            60000));
        std::vector<RecordingId> ids;
        for (const RecordingEntry& entry : document().recordings()) {
            ids.push_back(entry.id);
        }
        document().sets().add(ids);
        window_->action(Command::identify)->trigger();
        waitIdle();
        QVERIFY(outcome());
        store(fresh_, "fresh.vybeg");
        Settings settings = document().settings();
        settings.from_s = 0.5;
        document().setSettings(settings);
        waitIdle();
        store(stale_, "stale.vybeg");
    }

    void store(Stored& stored, const QString& name) {
        stored = {home_.path(name), numbers("resonator"), numbers("modes"), numbers("runs"),
                  numbers("waves"), warnings(),           state()};
        QVERIFY(savedTo(*window_, stored.path));
    }

    // A copy, which a function may change.
    QString copyOf(const Stored& stored, const QString& name) {
        QFile::copy(stored.path, home_.path(name));
        return home_.path(name);
    }

    void reopen(const QString& path) {
        session().end();
        window_ = shownWindow();
        window_->files().open({path});
        waitIdle();
    }

    std::shared_ptr<const SetResult> outcome() {
        const RecordingSet* set = document().sets().current();
        return set ? document().sets().outcome(*set) : nullptr;
    }

    // All numbers of a table at full precision, as it is copied.
    QString numbers(const char* table) {
        auto& view = childOf<QuantityTable>(*window_, QLatin1String(table));
        bringUp(view);
        view.setFocus();
        view.selectAll();
        QTest::keyClick(&view, Qt::Key_C, Qt::ControlModifier);
        return QGuiApplication::clipboard()->text();
    }

    QString state() { return childOf<QLabel>(*window_, QStringLiteral("state")).text(); }
    QString warnings() { return childOf<QLabel>(*window_, QStringLiteral("warnings")).text(); }

    QString messages() { return childOf<MessageBar>(*window_).texts().join('\n'); }

    // Whether the table has changes since the passport.
    bool isCompared() {
        return cellOf("resonator", "Frequency split", "Since the passport") != nullptr;
    }

    bool becomesCompared() {
        return QTest::qWaitFor([this] { return isCompared(); }, 60000);
    }

    // A session like `fresh_` in which the passport of that result is open, both of this name.
    QString compared(const QString& name) {
        const QString path = copyOf(fresh_, name + ".vybeg");
        reopen(path);
        const QString passport = home_.path(name + ".json");
        window_->files().savePassportTo(passport);
        const bool written = QTest::qWaitFor([&] { return QFile::exists(passport); }, 60000);
        document().passport().open(passport);
        const bool open = becomesCompared();
        return written && open && session().isModified() && savedTo(*window_, path) ? path
                                                                                    : QString();
    }

    static QJsonObject jsonOf(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                              : QJsonObject();
    }

    void hideRecordings() {
        for (const QString& file : files_) {
            QVERIFY(QFile::rename(file, file + ".away"));
        }
    }

private slots:
    void initTestCase() {
        files_ = resonatorRuns(home_, QStringLiteral("run"));
        identifyOnce();
    }
    void cleanup() {
        session().end();
        for (const QString& file : files_) {
            QFile::rename(file + ".away", file);
        }
        // Passports of the same result are the same, and found by their content.
        const QDir home(home_.path("."));
        for (const QString& passport : home.entryList({"*.json"}, QDir::Files)) {
            QFile::remove(home.filePath(passport));
        }
    }

    void a_reopened_session_identifies_its_sets_again() {
        QVERIFY(fresh_.resonator.contains("0.01"));
        reopen(copyOf(fresh_, "again.vybeg"));
        QVERIFY(outcome());
        QCOMPARE(numbers("resonator"), fresh_.resonator);
        QCOMPARE(numbers("runs"), fresh_.runs);
        QCOMPARE(numbers("waves"), fresh_.waves);
        QVERIFY(!session().isModified());
    }

    void without_its_recordings_a_session_shows_its_results() {
        const QString path = copyOf(fresh_, "away.vybeg");
        hideRecordings();
        reopen(path);
        QVERIFY(!outcome());
        QCOMPARE(numbers("resonator"), fresh_.resonator);
        QCOMPARE(numbers("modes"), fresh_.modes);
        QCOMPARE(numbers("runs"), fresh_.runs);
        QCOMPARE(warnings(), fresh_.warnings);
        QVERIFY2(state().contains("Result of the session"), qPrintable(state()));
        for (const QString& file : files_) {
            QVERIFY2(state().contains(QFileInfo(file).fileName()), qPrintable(state()));
        }
        QVERIFY(!childOf<QuantityTable>(*window_, QStringLiteral("waves")).isVisible());
        // Saved again, nothing of it is lost.
        const QJsonArray sets = jsonOf(path)["sets"].toArray();
        QVERIFY(savedTo(*window_, path));
        QCOMPARE(jsonOf(path)["sets"].toArray()[0].toObject()["result"],
                 sets[0].toObject()["result"]);
    }

    void a_result_of_other_settings_stays_out_of_date() {
        QVERIFY(stale_.state.contains("Out of date"));
        reopen(copyOf(stale_, "older.vybeg"));
        QVERIFY(!outcome());
        QCOMPARE(numbers("resonator"), stale_.resonator);
        QVERIFY(state().contains("Out of date"));
        window_->action(Command::identify)->trigger();
        waitIdle();
        QVERIFY(outcome());
        QVERIFY(!state().contains("Out of date"));
        QVERIFY(numbers("resonator") != stale_.resonator);
    }

    void a_result_that_is_not_understood_is_named_and_kept() {
        const QString path = copyOf(stale_, "newer.vybeg");
        QJsonObject json = jsonOf(path);
        QJsonArray sets = json["sets"].toArray();
        QJsonObject set = sets[0].toObject();
        QJsonObject result = set["result"].toObject();
        QJsonObject passport = result["passport"].toObject();
        passport["schema"] = 99;
        result["passport"] = passport;
        set["result"] = result;
        sets[0] = set;
        json["sets"] = sets;
        home_.file("newer.vybeg", QJsonDocument(json).toJson());
        reopen(path);
        QVERIFY2(state().contains("99"), qPrintable(state()));
        QVERIFY(!childOf<QuantityTable>(*window_, QStringLiteral("resonator")).isVisible());
        QVERIFY(savedTo(*window_, path));
        QCOMPARE(jsonOf(path)["sets"].toArray()[0].toObject()["result"].toObject(), result);
    }

    void a_passport_is_open_again_with_its_session() {
        const QString path = compared("gyro");
        const QJsonObject file = jsonOf(path)["passport"].toObject()["file"].toObject();
        QCOMPARE(file["path"].toString(), QString("gyro.json"));
        QVERIFY(!file["sha256"].toString().isEmpty());
        reopen(path);
        QVERIFY(becomesCompared());
        QCOMPARE(messages(), QString());
        QVERIFY(!session().isModified());
        document().passport().setFrequencyLimit(12);
        QVERIFY(session().isModified());
        QVERIFY(savedTo(*window_, path));
        reopen(path);
        QVERIFY(becomesCompared());
        QCOMPARE(document().passport().input().f_limit_ppm, 12.0);
        document().passport().close();
        QVERIFY(!isCompared() && session().isModified());
        document().undoStack().undo();
        QVERIFY(isCompared() && !session().isModified());
        document().undoStack().redo();
        QVERIFY(savedTo(*window_, path));
        QVERIFY(!jsonOf(path).contains("passport"));
        reopen(path);
        QVERIFY(!isCompared());
    }

    // Without its file the results are there, and the session keeps its place.
    void a_passport_that_is_away_is_told_of_and_kept() {
        const QString path = compared("lost");
        const QJsonValue stored = jsonOf(path)["passport"];
        QVERIFY(QFile::rename(home_.path("lost.json"), home_.path("elsewhere.txt")));
        reopen(path);
        QTRY_VERIFY2_WITH_TIMEOUT(messages().contains("The session's passport cannot be opened") &&
                                      messages().contains("lost.json"),
                                  qPrintable(messages()), 60000);
        QVERIFY(!isCompared());
        QCOMPARE(numbers("resonator"), fresh_.resonator);
        QVERIFY(!session().isModified());
        document().dossier().setGyro({"17", {}, {}, {}});
        QVERIFY(savedTo(*window_, path));
        QCOMPARE(jsonOf(path)["passport"], stored);
        QTest::mouseClick(childOf<MessageBar>(*window_).findChild<QPushButton*>(), Qt::LeftButton);
        auto& files = childOf<QFileDialog>(*window_, "files");
        QVERIFY(files.isVisible());
        emit files.fileSelected(home_.path("elsewhere.txt"));
        files.close();
        QVERIFY(becomesCompared());
        // Under another name beside the session it is found by its content.
        QVERIFY(QFile::rename(home_.path("elsewhere.txt"), home_.path("renamed.json")));
        reopen(path);
        QVERIFY(becomesCompared());
        QCOMPARE(messages(), QString());
    }

    void a_passport_that_has_changed_is_told_of_and_compared_with() {
        const QString path = compared("changed");
        QFile file(home_.path("changed.json"));
        QVERIFY(file.open(QIODevice::Append) && file.write("\n") == 1);
        file.close();
        reopen(path);
        QVERIFY(becomesCompared());
        QVERIFY2(messages().contains("changed.json is another passport"), qPrintable(messages()));
        QVERIFY(!session().isModified());
    }

    void the_result_of_a_session_is_compared_without_its_recordings() {
        const QString path = compared("alone");
        hideRecordings();
        reopen(path);
        QVERIFY(!outcome());
        QVERIFY(becomesCompared());
    }

    void what_a_later_version_knows_of_a_passport_is_kept() {
        const QString path = compared("later");
        QJsonObject json = jsonOf(path);
        QJsonObject passport = json["passport"].toObject();
        passport["later"] = 7;
        json["passport"] = passport;
        home_.file("later.vybeg", QJsonDocument(json).toJson());
        reopen(path);
        QVERIFY(becomesCompared());
        QVERIFY(savedTo(*window_, path));
        QCOMPARE(jsonOf(path)["passport"].toObject(), passport);
    }

    void a_copy_against_crashes_has_the_passport() {
        const QString path = compared("copied");
        const QDir copies(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                          "/backups");
        const auto copy = [&] {
            const QStringList names = copies.entryList({"*.vybeg"}, QDir::Files);
            return names.isEmpty() ? QString() : copies.filePath(names.last());
        };
        window_->action(Command::identify)->trigger();  // a result is copied at once
        QTRY_VERIFY_WITH_TIMEOUT(jsonOf(copy()).contains("passport"), 60000);
        const QString left = home_.path("left.vybeg");
        QVERIFY(QFile::copy(copy(), left));
        reopen(left);
        QVERIFY(becomesCompared());
        QVERIFY(session().isModified());
        QCOMPARE(session().path(), path);
    }

    void warnings_come_back_with_their_words() {
        SetResult outcome;
        for (const char* name : {"a.wav", "b.wav"}) {
            outcome.set.recordings.push_back({.file = name,
                                              .path = name,
                                              .sha256 = name,
                                              .seconds = 28,
                                              .rate_hz = 33333,
                                              .f0_hz = 5300});
        }
        outcome.identification.fit.runs.resize(2);
        outcome.identification.runs.resize(2);
        outcome.identification.runs[1].diagnostics = {
            {DiagnosticKind::samples_lost, {count_arg(3), number_arg(1.25)}}};
        outcome.identification.fit.warnings = {
            {DiagnosticKind::residual_above_noise, {number_arg(2.5, 3)}}};
        const auto read = read_saved_result(saved_result_json(outcome));
        QVERIFY(read);
        QCOMPARE(read->set.recordings, outcome.set.recordings);
        const Identification& found = read->identification;
        QVERIFY(found.runs[0].diagnostics.empty());
        QCOMPARE(found.runs[1].diagnostics, outcome.identification.runs[1].diagnostics);
        QCOMPARE(found.fit.warnings, outcome.identification.fit.warnings);
    }
};

VYBEG_TEST(TestSessionResults, threads)

}  // namespace test_session_results

#include "test_session_results.moc"
