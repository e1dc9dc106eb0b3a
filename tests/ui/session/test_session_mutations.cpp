// Damaged sessions in the window: refused by name with everything that is open kept, or opened and
// as good as any other. 60 of them, or as many as VYBEG_MUTATIONS says.
#include "tests/closeness.h"
#include "tests/fuzz/mutation.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "tests/ui/resonator_runs.h"
#include "ui/panels/message_bar.h"
#include "ui/session/session_keeper.h"
#include "ui/window/main_window.h"

#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <random>

namespace test_session_mutations {

using namespace vybeg;
using namespace vybeg::ui;

// Changes one value of a session: to one of another kind, to one that nothing takes, to what stands
// elsewhere; or leaves it out.
class JsonDamage {
public:
    JsonDamage(const QJsonValue& whole, std::uint64_t seed) : random_(seed) { collect(whole); }

    QJsonValue apply(const QJsonValue& whole) {
        at_ = static_cast<qsizetype>(random_() % static_cast<std::uint64_t>(values_.size()));
        seen_ = 0;
        return changed(whole);
    }
    QString what() const { return what_; }

private:
    void collect(const QJsonValue& value) {
        values_ << value;
        for (const QJsonValue& each : value.toArray()) {
            collect(each);
        }
        for (const QJsonValue& each : value.toObject()) {
            collect(each);
        }
    }

    QJsonValue changed(const QJsonValue& value) {
        if (seen_++ == at_) {
            const QJsonValue other = otherValue();
            what_ = QString::fromUtf8(
                QJsonDocument(QJsonArray{value, other}).toJson(QJsonDocument::Compact).left(300));
            return other;
        }
        if (value.isArray()) {
            QJsonArray array;
            for (const QJsonValue& each : value.toArray()) {
                array << changed(each);
            }
            return array;
        }
        if (value.isObject()) {
            QJsonObject object = value.toObject();
            for (const QString& key : object.keys()) {
                object[key] = changed(object.value(key));  // an undefined value removes the key
            }
            return object;
        }
        return value;
    }

    QJsonValue otherValue() {
        const QList<QJsonValue> extremes{QJsonValue::Null,
                                         true,
                                         0,
                                         -1,
                                         1,
                                         2147483648.0,
                                         1e300,
                                         -1e300,
                                         1e-300,
                                         0.5,
                                         QString(),
                                         "/",
                                         "/dev/zero",
                                         "..",
                                         "nan",
                                         QString(100000, QLatin1Char('x')),
                                         QString(QChar(0)),
                                         QJsonArray(),
                                         QJsonArray{QJsonArray{1}},
                                         QJsonObject(),
                                         QJsonObject{{"value", -1}},
                                         QJsonValue::Undefined};
        if (random_() % 3 == 0) {
            return values_[static_cast<qsizetype>(random_() %
                                                  static_cast<std::uint64_t>(values_.size()))];
        }
        return extremes[static_cast<qsizetype>(random_() %
                                               static_cast<std::uint64_t>(extremes.size()))];
    }

    std::mt19937_64 random_;
    QList<QJsonValue> values_;
    qsizetype at_ = 0;
    qsizetype seen_ = 0;
    QString what_;
};

class TestSessionMutations : public QObject, private WindowTest {
    Q_OBJECT

    QByteArray sound_;  // a session with all that sessions hold

    SessionKeeper& session() { return window_->session(); }
    bool isIdle() { return !document().busy() && !session().isOpening(); }
    QString messages() { return childOf<MessageBar>(*window_).texts().join('\n'); }

    // Damage to the text, or to a value of it.
    QByteArray damaged(std::uint64_t seed, QString& what) {
        if (seed % 3 == 0) {
            const fuzz::Mutation mutation = fuzz::mutated({sound_.toStdString()}, seed);
            what = QString::fromStdString(mutation.what);
            return QByteArray::fromStdString(mutation.bytes);
        }
        const QJsonValue whole = QJsonDocument::fromJson(sound_).object();
        JsonDamage damage(whole, seed);
        const QJsonValue value = damage.apply(whole);
        what = damage.what();
        return value.isArray() ? QJsonDocument(value.toArray()).toJson()
                               : QJsonDocument(value.toObject()).toJson();
    }

private slots:
    void initTestCase() {
        const QStringList files = resonatorRuns(home_, QStringLiteral("run"));
        window_ = shownWindow();
        document().open(files);
        QTRY_VERIFY_WITH_TIMEOUT(isIdle(), 60000);
        std::vector<RecordingId> ids;
        for (const RecordingEntry& entry : document().recordings()) {
            const auto id = entry.id;
            QTRY_VERIFY(document().recording(id)->recording);
            ids.push_back(id);
        }
        document().sets().add(ids);
        window_->action(Command::identify)->trigger();
        document().dossier().setGyro({"HRG-17", "30 mm", "Orlova", "after annealing"});
        document().dossier().setLimits({{"split_hz", std::nullopt, 0.001}, {"q", 1e7, 2e7}});
        QTRY_VERIFY_WITH_TIMEOUT(isIdle(), 60000);
        QVERIFY(savedTo(*window_, home_.path("sound.vybeg")));
        QFile file(home_.path("sound.vybeg"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        sound_ = file.readAll();
    }

    void cleanupTestCase() { session().end(); }

    void a_damaged_session_is_refused_by_name_or_opened_whole() {
        bool given = false;
        const int wanted = qEnvironmentVariableIntValue("VYBEG_MUTATIONS", &given);
        const int count = given ? wanted : 60;
        int refused = 0;
        int opened = 0;
        QElapsedTimer timer;
        qint64 slowest_ms = 0;
        for (int k = 0; k < count; ++k) {
            const auto seed = static_cast<std::uint64_t>(k + 1);
            QString what;
            const QString path = home_.file("damaged.vybeg", damaged(seed, what));
            const QByteArray told = QString("seed %1: %2").arg(seed).arg(what).toUtf8();
            const std::size_t recordings = document().recordings().size();
            const std::size_t sets = document().sets().all().size();
            childOf<MessageBar>(*window_).clear();
            timer.start();
            if (!session().openSession(path)) {
                ++refused;
                QVERIFY2(messages().contains("damaged.vybeg"), told + "\n" + messages().toUtf8());
                VYBEG_EQUAL(document().recordings().size(), recordings, told);
                VYBEG_EQUAL(document().sets().all().size(), sets, told);
                continue;
            }
            ++opened;
            QVERIFY2(QTest::qWaitFor([&] { return isIdle(); }, 60000), told);
            slowest_ms = std::max(slowest_ms, timer.elapsed());
            // What is opened is as good as any other: it is saved, and that opens again.
            const QString saved = home_.path("saved.vybeg");
            QFile::remove(saved);
            session().save(saved);
            QVERIFY2(QTest::qWaitFor([&] { return !session().isSaving(); }, 20000), told);
            QVERIFY2(QFile::exists(saved), told + "\n" + messages().toUtf8());
            QVERIFY2(session().openSession(saved), told + "\n" + messages().toUtf8());
            QVERIFY2(QTest::qWaitFor([&] { return isIdle(); }, 60000), told);
        }
        qInfo("%d refused, %d opened, the slowest within %lld ms", refused, opened,
              static_cast<long long>(slowest_ms));
        VYBEG_AT_LEAST(refused, count / 5, "too few damages are found");
        VYBEG_AT_LEAST(opened, count / 5, "too few damages get beyond the JSON");
    }
};

VYBEG_TEST(TestSessionMutations, first)

}  // namespace test_session_mutations

#include "test_session_mutations.moc"
