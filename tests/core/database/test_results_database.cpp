#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/database/results_database.h"
#include "tests/closeness.h"
#include "tests/core/database/made_result.h"
#include "tests/small_files.h"
#include "tests/test_registry.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <filesystem>
#include <sqlite3.h>
#include <stop_token>
#include <thread>

namespace test_results_database {

using namespace vybeg;
using namespace vybeg::test;

namespace {

using Access = ResultsDatabase::Access;

bool same_estimate(const Estimate& a, const Estimate& b) {
    const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return same(a.value, b.value) && same(a.sd, b.sd) && same(a.u, b.u) && a.reason == b.reason;
}

// SQL from outside the program; false: it failed.
bool run_sql(const QString& path, const char* sql) {
    sqlite3* connection = nullptr;
    const bool done = sqlite3_open(path.toUtf8().constData(), &connection) == SQLITE_OK &&
                      sqlite3_exec(connection, sql, nullptr, nullptr, nullptr) == SQLITE_OK;
    sqlite3_close(connection);
    return done;
}

// The rows of a query from outside the program, NULL as an empty text.
QList<QStringList> rows_of(const QString& path, const char* sql) {
    sqlite3* connection = nullptr;
    QList<QStringList> rows;
    const auto take = [](void* into, int count, char** texts, char**) {
        QStringList row;
        for (int k = 0; k < count; ++k) {
            row << QString::fromUtf8(texts[k]);
        }
        static_cast<QList<QStringList>*>(into)->append(row);
        return 0;
    };
    if (sqlite3_open(path.toUtf8().constData(), &connection) == SQLITE_OK) {
        sqlite3_exec(connection, sql, take, &rows, nullptr);
    }
    sqlite3_close(connection);
    return rows;
}

}  // namespace

class TestResultsDatabase : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::string path(const char* name) const { return folder_.filePath(name).toStdString(); }
    static Result<ResultsDatabase> open(const std::string& path, Access access = Access::write,
                                        double patience_s = 20) {
        return ResultsDatabase::open(path, access, JobControl(), {}, patience_s);
    }
    // The sentence of a file that is refused for writing and for reading.
    void refuses(const char* name, const QString& reason) const {
        for (const Access access : {Access::write, Access::read}) {
            const auto database = open(path(name), access, 0.1);
            QVERIFY(!database);
            const QString sentence = QString::fromStdString(english(database.error()));
            QVERIFY2(sentence.contains(reason) && sentence.contains(name), qPrintable(sentence));
            QCOMPARE(exit_status(database.error().code), access == Access::write ? 5 : 3);
        }
    }

private slots:
    void every_field_reads_back() {
        auto database = open(path("fields.db"));
        QVERIFY(bool(database));
        const StoredResult written = made_result(3);
        const auto added = database->add(written);
        QVERIFY(bool(added));
        const auto got = database->result(added->id);
        QVERIFY(got && *got);
        const StoredResult& read = **got;
        QCOMPARE(read.key, written.key);
        QCOMPARE(read.set, written.set);
        QCOMPARE(read.gyro, written.gyro);
        QVERIFY(read.date == written.date);
        QCOMPARE(read.program, written.program);
        QCOMPARE(read.model, written.model);
        QCOMPARE(read.json, written.json);
        QCOMPARE(read.recordings.size(), written.recordings.size());
        for (std::size_t k = 0; k < read.recordings.size(); ++k) {
            QVERIFY2(read.recordings[k] == written.recordings[k],
                     written.recordings[k].file.c_str());
        }
        for (const auto& [name, estimate] : written.parameters) {
            const auto points = database->history(std::nullopt, name);
            QVERIFY2(
                points && points->size() == 1 && same_estimate(points->front().value, estimate),
                name.c_str());
        }
        const auto counted =
            rows_of(folder_.filePath("fields.db"), "SELECT count(*) FROM parameter");
        QCOMPARE(counted, (QList<QStringList>{{QString::number(written.parameters.size())}}));
        const auto raw = rows_of(folder_.filePath("fields.db"),
                                 "SELECT raw_names, raw_values, hex(raw_covariance) FROM document");
        QCOMPARE(raw.size(), qsizetype{1});
        QCOMPARE(raw[0][0], QString("[\"f\",\"split\"]"));
        QCOMPARE(raw[0][1], QString("[5300.0026,0.30000000000000004]"));
        // qUncompress() reads four bytes of size before zlib's stream. The lower part, row by row.
        const QByteArray packed =
            QByteArray("\0\0\1\0", 4) + QByteArray::fromHex(raw[0][2].toLatin1());
        QCOMPARE(qUncompress(packed), QByteArray("[1e-12,-1e-13,null]"));
        QVERIFY(!*database->result(999));
    }

    void the_same_key_replaces_its_result() {
        auto database = open(path("twice.db"));
        StoredResult result = made_result(1);
        const auto first = database->add(result);
        QVERIFY(bool(database->add(made_result(2))));
        result.gyro = "G8";
        result.recordings.resize(1);
        result.parameters.resize(3);
        const auto again = database->add(result);
        QVERIFY(first && again);
        QCOMPARE(again->id, first->id);
        QVERIFY(!first->replaced);
        QVERIFY(again->replaced == StoredName(made_result(1)));
        const auto read = database->result(first->id);
        QCOMPARE((*read)->gyro, std::string("G8"));
        QCOMPARE((*read)->recordings.size(), std::size_t{1});
        QCOMPARE(rows_of(folder_.filePath("twice.db"),
                         "SELECT count(*) FROM parameter GROUP BY result ORDER BY 1")[0],
                 QStringList{"3"});
        QCOMPARE((*database->history(std::nullopt, "f_mean_hz")).size(), std::size_t{2});
    }

    void history_is_by_date_with_unknown_dates_last() {
        auto database = open(path("history.db"));
        const std::array<const char*, 4> dates{"", "2026-03-31T01:00+03:00", "2026-03-30T23:00Z",
                                               "2025-12-31"};
        for (int k = 0; k < 4; ++k) {
            StoredResult result = made_result(k);
            const bool dated = dates[static_cast<std::size_t>(k)][0] != '\0';
            result.date = {dates[static_cast<std::size_t>(k)],
                           dated ? DateSource::recording : DateSource::none};
            QVERIFY(bool(database->add(result)));
        }
        QVERIFY(bool(database->add(made_result(9, "other"))));
        const auto points = database->history("G7", "split_hz");
        QVERIFY(bool(points));
        std::vector<std::string> found;
        for (const HistoryPoint& point : *points) {
            found.push_back(point.date.text);
        }
        QVERIFY(found == (std::vector<std::string>{dates[3], dates[1], dates[2], dates[0]}));
        QVERIFY(std::isnan(points->back().time_s));
        VYBEG_CLOSE(points->front().time_s, 1767139200.0, 1e-6);  // date -u -d 2025-12-31 +%s
        const HistoryPoint& point = points->front();
        QVERIFY(point.value.reason.code == ReasonCode::one_direction);
        QVERIFY(std::isnan(point.value.value));
        VYBEG_CLOSE(point.f_mean_hz.value, 5300.003, 1e-9);
        VYBEG_CLOSE(point.f_mean_hz.u, 2e-6, 1e-12);
        VYBEG_CLOSE(point.temperature_c, 21.0, 1e-12);  // the mean of three that tell it
        VYBEG_CLOSE(point.bias_v, 60.5, 1e-12);
        QVERIFY(point.exchanged);
        QCOMPARE((*database->history(std::nullopt, "split_hz")).size(), std::size_t{5});
        QCOMPARE((*database->history("nobody", "split_hz")).size(), std::size_t{0});
        const auto gyros = database->gyros();
        QCOMPARE(gyros->size(), std::size_t{2});
        QCOMPARE((*gyros)[0].name, std::string("G7"));
        QCOMPARE((*gyros)[0].results, std::int64_t{4});
    }

    // One of them makes the file.
    void threads_open_a_new_database_at_once() {
        std::atomic<int> failed = 0;
        for (int round = 0; round < 40; ++round) {
            const std::string name = path(("new" + std::to_string(round) + ".db").c_str());
            std::vector<std::jthread> writers;
            for (int writer = 0; writer < 4; ++writer) {
                writers.emplace_back([&] { failed += open(name, Access::write, 60) ? 0 : 1; });
            }
        }
        QCOMPARE(failed.load(), 0);
    }

    void several_writers_lose_nothing() {
        std::vector<std::jthread> writers;
        std::atomic<int> failed = 0;
        for (int writer = 0; writer < 4; ++writer) {
            writers.emplace_back([&, writer] {
                auto database = open(path("many.db"), Access::write, 60);
                for (int k = 0; k < 25; ++k) {
                    // Every fifth is the same of all of them.
                    const int number = k % 5 == 0 ? k : 1000 * (writer + 1) + k;
                    failed += database && database->add(made_result(number)) ? 0 : 1;
                }
            });
        }
        writers.clear();
        QCOMPARE(failed.load(), 0);
        auto database = open(path("many.db"), Access::read);
        QCOMPARE((*database->history(std::nullopt, "q")).size(), std::size_t{4 * 20 + 5});
        QVERIFY(run_sql(folder_.filePath("many.db"), "PRAGMA integrity_check"));
    }

    void a_lock_ends_the_patience_and_an_interruption_at_once() {
        auto database = open(path("locked.db"), Access::write, 0.2);
        QVERIFY(bool(database));
        sqlite3* other = nullptr;
        QCOMPARE(sqlite3_open(path("locked.db").c_str(), &other), SQLITE_OK);
        QCOMPARE(sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr), SQLITE_OK);
        const auto added = database->add(made_result(1));
        QVERIFY(!added);
        QCOMPARE(QString::fromStdString(english(added.error())),
                 QString::fromStdString(path("locked.db")) +
                     " cannot be written: another program has kept it locked for 0.2 s. Nothing "
                     "was changed there.");
        std::stop_source stop;
        auto patient = ResultsDatabase::open(path("locked.db"), Access::write,
                                             JobControl(stop.get_token()), {}, 3600);
        QVERIFY(bool(patient));
        stop.request_stop();
        const auto stopped = patient->add(made_result(1));
        QVERIFY(!stopped && stopped.error().code == ErrorCode::interrupted);
        sqlite3_exec(other, "ROLLBACK", nullptr, nullptr, nullptr);
        sqlite3_close(other);
        QVERIFY(bool(database->add(made_result(1))));
    }

    void a_long_wait_is_told_once() {
        std::vector<Diagnostic> told;
        auto database = ResultsDatabase::open(
            path("waits.db"), Access::write, JobControl(),
            [&](const Diagnostic& each) { told.push_back(each); }, 0.7);
        QVERIFY(bool(database));
        QVERIFY(bool(database->add(made_result(1))));
        QVERIFY(told.empty());
        sqlite3* other = nullptr;
        QCOMPARE(sqlite3_open(path("waits.db").c_str(), &other), SQLITE_OK);
        QCOMPARE(sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr), SQLITE_OK);
        QVERIFY(!database->add(made_result(2)));
        QCOMPARE(told.size(), std::size_t{1});
        QVERIFY(told[0].kind == DiagnosticKind::database_waits);
        sqlite3_exec(other, "ROLLBACK", nullptr, nullptr, nullptr);
        sqlite3_close(other);
    }

    void a_result_gets_the_number_that_is_wanted_where_it_is_free() {
        auto database = open(path("numbers.db"));
        QCOMPARE(*database->last_id(), std::int64_t{0});
        QCOMPARE(database->add(made_result(1), 7)->id, std::int64_t{7});
        QCOMPARE(database->add(made_result(2), 5)->id, std::int64_t{5});
        QCOMPARE(database->add(made_result(3), 7)->id, std::int64_t{8});
        QCOMPARE(database->add(made_result(2), 20)->id, std::int64_t{5});  // keeps its own
        QCOMPARE(*database->last_id(), std::int64_t{8});
    }

    // The text of a document of 100 kB stands packed in the file, and comes back as it was.
    void documents_are_packed() {
        StoredResult result = made_result(1);
        result.json = "{\n";
        for (int k = 0; result.json.size() < 100000; ++k) {
            result.json +=
                "\"value_" + std::to_string(k) + "\": " + std::to_string(k * 1.2345e-3) + ",\n";
        }
        std::int64_t id = 0;
        {
            auto database = open(path("packed.db"));
            id = database->add(result)->id;
            QCOMPARE((**database->result(id)).json, result.json);
        }
        VYBEG_LESS(content(folder_.filePath("packed.db")).size(), 100000);
        // As schemas 1 to 3 have it.
        QVERIFY(run_sql(folder_.filePath("packed.db"), "UPDATE document SET json = '{}'"));
        QCOMPARE((**open(path("packed.db"))->result(id)).json, "{}");
        QVERIFY(run_sql(folder_.filePath("packed.db"), "UPDATE document SET json = x'00FF'"));
        QVERIFY(!open(path("packed.db"))->result(id));
    }

    // Schema 1 keeps the channels of a recording and no other option of opening it.
    void a_database_of_schema_1_is_read_and_goes_on() {
        const QString file = folder_.filePath("schema1.db");
        std::int64_t id = 0;
        {
            auto database = open(path("schema1.db"));
            QVERIFY(bool(database));
            id = database->add(made_result(1))->id;
        }
        QVERIFY(run_sql(file, "DROP VIEW history"));
        QVERIFY(run_sql(file, "ALTER TABLE result DROP COLUMN warnings"));
        QVERIFY(run_sql(file, "ALTER TABLE recording DROP COLUMN opening"));
        QVERIFY(run_sql(file, "PRAGMA user_version = 1"));
        const QByteArray before = content(file);
        {
            auto database = open(path("schema1.db"), Access::read);
            QVERIFY(bool(database));
            auto got = database->result(id);
            QVERIFY(got && *got);
            QVERIFY((**got).warnings.empty());
            QVERIFY((**got).recordings[0].open ==
                    (OpenOptions{.channel_c = made_opening().channel_c,
                                 .channel_d = made_opening().channel_d}));
        }
        QCOMPARE(content(file), before);
        auto database = open(path("schema1.db"));
        QVERIFY(bool(database));
        const auto later = database->add(made_result(2));
        QVERIFY(bool(later));
        const auto got = database->result(later->id);
        QVERIFY(got && *got);
        QVERIFY((**got).recordings[0].open == made_opening());
        QCOMPARE((**got).warnings, made_result(2).warnings);
        QVERIFY(bool(*database->result(id)));
        QCOMPARE(rows_of(file, "SELECT set_name, tau_s FROM history").size(), qsizetype(2));
    }

    // Long texts lie deflated; those of schema 3, which had them as they are, stay.
    void long_texts_are_packed_and_plain_ones_are_read() {
        const QString file = folder_.filePath("packed.db");
        StoredResult result = made_result(1);
        for (int k = 0; k < 2000; ++k) {
            result.json += "{\"value\": 0.5, \"sd\": 0.25}\n";
        }
        auto database = open(path("packed.db"));
        QVERIFY(bool(database));
        const auto added = database->add(result);
        QVERIFY(bool(added));
        const auto stored = rows_of(file,
                                    "SELECT typeof(json), length(json) < 2000, "
                                    "typeof(raw_covariance) FROM document");
        QCOMPARE(stored, (QList<QStringList>{{"blob", "1", "blob"}}));
        QCOMPARE((**database->result(added->id)).json, result.json);

        QVERIFY(run_sql(file,
                        "UPDATE document SET json = '{\"a\": 1}', "
                        "raw_covariance = '[1.0,2.0,2.0,null]'; PRAGMA user_version = 3"));
        const auto plain = open(path("packed.db"), Access::read)->result(added->id);
        QVERIFY(plain && *plain);
        QCOMPARE((**plain).json, std::string("{\"a\": 1}"));
        QVERIFY(bool(open(path("packed.db"))));
        QCOMPARE(rows_of(file, "PRAGMA user_version"), (QList<QStringList>{{"4"}}));
        QCOMPARE(rows_of(file, "SELECT set_name FROM history").size(), qsizetype(1));
    }

    void a_packed_text_that_is_damaged_or_too_long_is_an_error() {
        const QString file = folder_.filePath("bomb.db");
        auto database = open(path("bomb.db"));
        const auto added = database->add(made_result(1));
        QVERIFY(bool(added));
        // qCompress() writes four bytes of size before zlib's stream.
        const QByteArray packed = qCompress(QByteArray(70 << 20, ' '), 9).mid(4);
        for (const QByteArray& blob :
             {QByteArray("no stream"), packed.left(packed.size() / 2), packed}) {
            const QByteArray sql = "UPDATE document SET json = x'" + blob.toHex() + "'";
            QVERIFY(run_sql(file, sql.constData()));
            const auto read = database->result(added->id);
            QVERIFY(!read);
            const QString sentence = QString::fromStdString(english(read.error()));
            QVERIFY2(sentence.contains("the database is damaged"), qPrintable(sentence));
        }
    }

    // For other programs: a row for each result, a column for each parameter.
    void the_view_history_has_a_row_for_each_result() {
        {
            auto database = open(path("view.db"));
            QVERIFY(bool(database));
            QVERIFY(bool(database->add(made_result(1))));
            QVERIFY(bool(database->add(made_result(2, "G8"))));
        }
        const auto rows = rows_of(
            folder_.filePath("view.db"),
            "SELECT gyro, set_name, date, bias_v, temperature_c, exchanged, operator, comment, "
            "warnings, f_mean_hz, sd_f_mean_hz, u_f_mean_hz, split_hz, u_split_hz, mode_0_f_hz, "
            "u_mode_0_f_hz, mode_1_q FROM history ORDER BY result");
        QCOMPARE(rows.size(), qsizetype(2));
        QCOMPARE(rows[1],
                 (QStringList{"G8", QString::fromStdString(made_result(2).set),
                              QString::fromStdString(made_result(2).date.text), "60.5", "21.0", "1",
                              "И. О.", "quiet", "residual-coloured;offset", "5300.002", "1.0e-06",
                              "2.0e-06", "", "", "5300.0026", "", ""}));
    }

    void other_files_stay_as_they_are() {
        QVERIFY(put(folder_.filePath("text.db"), "set,gyro\nA,G7\n"));
        refuses("text.db", "it is another kind of file");
        QCOMPARE(content(folder_.filePath("text.db")), QByteArray("set,gyro\nA,G7\n"));

        QVERIFY(run_sql(folder_.filePath("foreign.db"), "CREATE TABLE t (x)"));
        const QByteArray foreign = content(folder_.filePath("foreign.db"));
        refuses("foreign.db", "it is a database of another program");
        QCOMPARE(content(folder_.filePath("foreign.db")), foreign);

        QVERIFY(bool(open(path("newer.db"))));
        QVERIFY(run_sql(folder_.filePath("newer.db"), "PRAGMA user_version = 7"));
        refuses("newer.db", "a later version of Vybeg has made it (schema 7; this one knows 4)");

        QVERIFY(QDir(folder_.path()).mkdir("folder"));
        refuses("folder", "it is a folder");
        const auto missing = open(path("missing.db"), Access::read);
        QVERIFY(!missing && missing.error().code == ErrorCode::file_missing);
        QVERIFY(!QFile::exists(folder_.filePath("missing.db")));
    }

    void a_damaged_file_is_named_and_harms_nothing() {
        {
            auto database = open(path("damaged.db"));
            for (int k = 0; k < 40; ++k) {
                QVERIFY(bool(database->add(made_result(k))));
            }
        }
        QByteArray bytes = content(folder_.filePath("damaged.db"));
        for (int at = 8192; at < bytes.size(); at += 64) {
            bytes[at] = static_cast<char>(bytes[at] ^ 0x5A);
        }
        QVERIFY(put(folder_.filePath("damaged.db"), bytes));
        auto database = open(path("damaged.db"), Access::read);
        const auto points = database ? database->history(std::nullopt, "q")
                                     : Result<std::vector<HistoryPoint>>(database.error());
        QVERIFY(!points);
        const QString sentence = QString::fromStdString(english(points.error()));
        QVERIFY2(sentence.contains("the database is damaged"), qPrintable(sentence));
    }

    void an_empty_file_becomes_a_database_and_names_of_sqlite_are_files() {
        QVERIFY(put(folder_.filePath("empty.db"), ""));
        QVERIFY(bool(open(path("empty.db"))));
        const QString before = QDir::currentPath();
        QVERIFY(QDir::setCurrent(folder_.path()));
        QVERIFY(bool(open(":memory:")));
        QVERIFY(bool(open("file:x?mode=memory")));
        // Qt would look for a resource under the first name.
        QVERIFY(std::filesystem::exists(":memory:") &&
                std::filesystem::exists("file:x?mode=memory"));
        QVERIFY(QDir::setCurrent(before));
    }

    void each_file_has_an_identity() {
        auto one = open(path("one.db"));
        auto two = open(path("two.db"));
        const auto identity = one->identity();
        QCOMPARE(identity->size(), std::size_t{32});
        QVERIFY(*identity != *two->identity());
        QCOMPARE(*open(path("one.db"), Access::read)->identity(), *identity);
    }
};

VYBEG_TEST(TestResultsDatabase)

}  // namespace test_results_database

#include "test_results_database.moc"
