#include "core/database/results_database.h"

#include "core/base/message_arg.h"
#include "core/resonator/results/resonator_parameters.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <fcntl.h>
#include <mutex>
#include <new>
#include <sqlite3.h>
#include <sys/stat.h>
#include <tuple>
#include <unistd.h>
#include <utility>

namespace vybeg {
namespace {

using Clock = std::chrono::steady_clock;

// The tables of a database of results, `PRAGMA user_version` 4. README.md has the columns.
constexpr int results_schema = 4;
// `PRAGMA application_id`: "VybR".
constexpr int results_application = 0x56796252;

constexpr const char* results_tables = R"sql(
CREATE TABLE about (identity TEXT NOT NULL);
INSERT INTO about VALUES (lower(hex(randomblob(16))));

CREATE TABLE result (
    id INTEGER PRIMARY KEY,
    key TEXT NOT NULL UNIQUE,
    set_name TEXT NOT NULL,
    gyro TEXT NOT NULL,
    date TEXT NOT NULL,
    date_from TEXT NOT NULL CHECK (date_from IN ('', 'list', 'recording')),
    program TEXT NOT NULL,
    model TEXT NOT NULL,
    warnings TEXT NOT NULL DEFAULT ''
);
CREATE INDEX result_gyro ON result (gyro);

CREATE TABLE recording (
    result INTEGER NOT NULL REFERENCES result ON DELETE CASCADE,
    position INTEGER NOT NULL,
    file TEXT NOT NULL,
    path TEXT NOT NULL,
    name TEXT NOT NULL,
    sha256 TEXT NOT NULL,
    start TEXT NOT NULL,
    seconds REAL,
    rate_hz REAL,
    f0_hz REAL,
    channel_c INTEGER NOT NULL,
    channel_d INTEGER NOT NULL,
    gyro TEXT NOT NULL,
    date TEXT NOT NULL,
    bias_v REAL,
    temperature_c REAL,
    exchanged INTEGER NOT NULL,
    operator TEXT NOT NULL,
    comment TEXT NOT NULL,
    others TEXT NOT NULL,
    opening TEXT NOT NULL DEFAULT '[]',
    PRIMARY KEY (result, position)
) WITHOUT ROWID;

CREATE TABLE parameter (
    name TEXT NOT NULL,
    result INTEGER NOT NULL REFERENCES result ON DELETE CASCADE,
    position INTEGER NOT NULL,
    value REAL,
    sd REAL,
    u REAL,
    reason TEXT NOT NULL,
    reason_args TEXT NOT NULL,
    PRIMARY KEY (name, result)
) WITHOUT ROWID;
CREATE INDEX parameter_result ON parameter (result);

CREATE TABLE document (
    result INTEGER PRIMARY KEY REFERENCES result ON DELETE CASCADE,
    raw_names TEXT NOT NULL,
    raw_values TEXT NOT NULL,
    raw_covariance TEXT NOT NULL,
    json TEXT NOT NULL
);
)sql";

// What a database of schema 1 lacks, and what one of schema 2 does, besides the view. One of schema
// 3 has the long texts of its documents as they are.
constexpr const char* opening_column =
    "ALTER TABLE recording ADD COLUMN opening TEXT NOT NULL DEFAULT '[]'";
constexpr const char* warnings_column =
    "ALTER TABLE result ADD COLUMN warnings TEXT NOT NULL DEFAULT ''";

// A pause between two attempts to get the lock, ms.
constexpr int pause_ms = 10;

// A wait that is not worth a word, s.
constexpr double quiet_s = 0.5;

MessageArg damage(const std::string& what) {
    return Phrase::tr(
        "the database is damaged (%1); take an earlier copy, or save what \"sqlite3 FILE "
        ".recover\" finds",
        {what});
}

// A file that is no database of results of this version.
struct OtherFile {
    MessageArg what;
};

struct Found {
    bool empty = false;
    std::int64_t application = 0;
    std::int64_t schema = 0;
};

std::int64_t one_number(SqliteConnection& connection, const char* sql) {
    SqliteStatement statement(connection, sql);
    return statement.step() ? statement.whole(0) : 0;
}

// Within a transaction: between two of its questions another program may make the tables.
Found look_at(SqliteConnection& connection) {
    return {one_number(connection, "SELECT count(*) FROM sqlite_schema") == 0,
            one_number(connection, "PRAGMA application_id"),
            one_number(connection, "PRAGMA user_version")};
}

// Throws OtherFile.
void check_kind(const Found& found) {
    if (found.application != results_application) {
        throw OtherFile{Phrase::tr("it is a database of another program")};
    }
    if (found.schema > results_schema) {
        throw OtherFile{
            Phrase::tr("a later version of Vybeg has made it (schema %1; this one knows %2)",
                       {count_arg(found.schema), count_arg(results_schema)})};
    }
}

bool is_new(const Found& found) {
    return found.empty && found.application == 0 && found.schema == 0;
}

// A row for each result, for programs that read tables: its conditions in the list, and of each
// parameter the value, sd and u.
std::string history_view() {
    std::string columns;
    const auto add = [&columns](const std::string& name, const std::string& column) {
        for (const auto& [prefix, field] :
             {std::pair{"", "value"}, std::pair{"sd_", "sd"}, std::pair{"u_", "u"}}) {
            columns += ",\n    max(CASE p.name WHEN '" + name + "' THEN p." + field + " END) AS " +
                       prefix + column;
        }
    };
    for (const ResonatorParameter& parameter : resonator_parameters) {
        add(parameter.name, parameter.name);
    }
    for (const std::string& mode : std::array<std::string, 2>{"0", "1"}) {
        for (const ModeParameter& parameter : mode_parameters) {
            add("modes[" + mode + "]." + parameter.name, "mode_" + mode + "_" + parameter.name);
        }
    }
    return R"sql(CREATE VIEW history AS SELECT r.id AS result, r.set_name, r.gyro, r.date,
    (SELECT max(bias_v) FROM recording WHERE result = r.id) AS bias_v,
    (SELECT avg(temperature_c) FROM recording WHERE result = r.id) AS temperature_c,
    (SELECT max(exchanged) FROM recording WHERE result = r.id) AS exchanged,
    (SELECT group_concat(DISTINCT operator) FROM recording
        WHERE result = r.id AND operator <> '') AS operator,
    (SELECT group_concat(DISTINCT comment) FROM recording
        WHERE result = r.id AND comment <> '') AS comment,
    r.warnings, r.program, r.model)sql" +
           columns + R"sql(
FROM result r LEFT JOIN parameter p ON p.result = r.id GROUP BY r.id)sql";
}

MessageArg label(const StoredName& name) {
    return name.gyro.empty() ? MessageArg(name.set)
                             : Phrase::tr("%1 (gyro %2)", {name.set, name.gyro});
}

// Several programs may do it at once: the first one does.
void make_tables(SqliteConnection& connection) {
    SqliteTransaction transaction(connection, "BEGIN IMMEDIATE");
    const Found found = look_at(connection);
    if (is_new(found)) {
        connection.run(results_tables);
    } else {
        check_kind(found);
        if (found.schema < 2) {
            connection.run(opening_column);
        }
        if (found.schema < 3) {
            connection.run(warnings_column);
        }
    }
    if (found.schema < 3) {
        connection.run(history_view().c_str());
    }
    if (found.schema < results_schema) {
        const std::string marks = "PRAGMA application_id = " + std::to_string(results_application) +
                                  "; PRAGMA user_version = " + std::to_string(results_schema);
        connection.run(marks.c_str());
    }
    transaction.commit();
}

}  // namespace

std::vector<Diagnostic> same_recordings(const StoredName& kept, const StoredName& lost) {
    std::vector<Diagnostic> warnings;
    if (kept != lost) {
        warnings.push_back({DiagnosticKind::same_recordings, {label(kept), label(lost)}});
    }
    return warnings;
}

ResultsDatabase::ResultsDatabase(std::filesystem::path path, Access access, const JobControl& job,
                                 double patience_s)
    : path_(std::move(path)), access_(access), job_(job), patience_s_(patience_s) {}

// The exceptions of `work` as errors.
template <class Work>
auto ResultsDatabase::guarded(const Work& work) -> Result<decltype(work())> {
    try {
        return work();
    } catch (const SqliteFailure& failure) {
        return error_of_failure(failure);
    } catch (const DamagedRow& row) {
        return refused(damage(row.what()));
    } catch (const OtherFile& file) {
        return refused(file.what);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_memory, {}, {}};
    }
}

Result<ResultsDatabase> ResultsDatabase::open(const std::filesystem::path& path, Access access,
                                              const JobControl& job, WhenWaiting waits,
                                              double patience_s) {
    ResultsDatabase database(path, access, job, patience_s);
    const Result<bool> connected = database.guarded([&] {
        database.connect(std::move(waits));
        return true;
    });
    return connected ? Result(std::move(database)) : connected.error();
}

void ResultsDatabase::connect(WhenWaiting waits) {
    if (access_ == Access::write) {
        // With the permissions that the user's mask gives, as every output. O_EXCL and one thread
        // at a time: closing a descriptor drops the locks that this process has on its file.
        static std::mutex making;
        const std::lock_guard alone(making);
        const int made = ::open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (made >= 0) {
            close(made);
        } else if (errno != EEXIST) {
            throw SqliteFailure(SQLITE_CANTOPEN, errno, "");
        }
    }
    struct stat status {};
    if (stat(path_.c_str(), &status) != 0) {
        throw SqliteFailure(SQLITE_CANTOPEN, errno, "");
    }
    if (S_ISDIR(status.st_mode)) {
        throw OtherFile{Phrase::tr("it is a folder")};
    }
    if (!S_ISREG(status.st_mode)) {
        throw OtherFile{Phrase::tr("it is no regular file")};
    }
    // SQLite gives ":memory:" and an empty name meanings of their own, an absolute path none.
    connection_ = std::make_unique<SqliteConnection>(
        std::filesystem::absolute(path_).string(),
        [job = job_, patience = patience_s_, waits = std::move(waits), name = path_.string(),
         begun = Clock::time_point(), told = false](int times) mutable {
            begun = times == 0 ? Clock::now() : begun;
            told = told && times > 0;
            const std::chrono::duration<double> waited = Clock::now() - begun;
            if (job.cancelled() || waited.count() > patience) {
                return false;
            }
            if (!told && waited.count() > quiet_s && waits) {
                told = true;
                waits({DiagnosticKind::database_waits, {name, number_arg(patience, 3)}});
            }
            sqlite3_sleep(pause_ms);
            return true;
        });
    if (access_ == Access::read) {
        connection_->run("PRAGMA query_only = ON");
    }
    const Found found = [this] {
        SqliteTransaction transaction(*connection_, "BEGIN");
        return look_at(*connection_);
    }();
    if (!is_new(found)) {
        check_kind(found);
    } else if (access_ == Access::read) {
        throw OtherFile{Phrase::tr("it holds no results")};
    }
    if (access_ == Access::write && connection_->read_only()) {
        throw SqliteFailure(SQLITE_READONLY, 0, "");
    }
    if (access_ == Access::write && found.schema < results_schema) {
        make_tables(*connection_);
    }
}

Error ResultsDatabase::refused(const MessageArg& reason) const {
    return {access_ == Access::read ? ErrorCode::file_read_failed : ErrorCode::output_failed,
            path_.string(),
            {reason}};
}

Error ResultsDatabase::error_of_failure(const SqliteFailure& failure) const {
    const auto system = [&failure](int otherwise) {
        return system_reason(failure.system_error != 0 ? failure.system_error : otherwise);
    };
    switch (failure.code & 0xFF) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return job_.cancelled()
                       ? Error{ErrorCode::interrupted, {}, {}}
                       : refused(Phrase::tr("another program has kept it locked for %1 s",
                                            {number_arg(patience_s_, 3)}));
        case SQLITE_NOTADB: return refused(Phrase::tr("it is another kind of file"));
        case SQLITE_FULL: return refused(system_reason(ENOSPC));
        case SQLITE_READONLY:
        case SQLITE_PERM:
        case SQLITE_AUTH: return refused(system(EACCES));
        case SQLITE_CANTOPEN:
        case SQLITE_IOERR:
            return access_ == Access::read && failure.system_error == ENOENT
                       ? Error{ErrorCode::file_missing, path_.string(), {}}
                       : refused(system(EIO));
        default: return refused(damage(failure.what()));
    }
}

Result<std::string> ResultsDatabase::identity() {
    return guarded([this] {
        SqliteStatement statement(*connection_, "SELECT identity FROM about");
        if (!statement.step()) {
            throw DamagedRow("it has no identity");
        }
        return statement.text(0);
    });
}

Result<std::int64_t> ResultsDatabase::last_id() {
    return guarded([this] { return one_number(*connection_, "SELECT max(id) FROM result"); });
}

Result<AddedResult> ResultsDatabase::add(const StoredResult& result,
                                         std::optional<std::int64_t> wanted) {
    return guarded([&] {
        SqliteTransaction transaction(*connection_, "BEGIN IMMEDIATE");
        AddedResult added = write_result(*connection_, result, wanted);
        transaction.commit();
        return added;
    });
}

Result<std::vector<StoredGyro>> ResultsDatabase::gyros() {
    return guarded([this] {
        SqliteStatement statement(*connection_,
                                  "SELECT gyro, count(*) FROM result GROUP BY gyro ORDER BY gyro");
        std::vector<StoredGyro> gyros;
        while (statement.step()) {
            gyros.push_back({statement.text(0), statement.whole(1)});
        }
        return gyros;
    });
}

Result<std::vector<HistoryPoint>> ResultsDatabase::history(const std::optional<std::string>& gyro,
                                                           const std::string& parameter) {
    return guarded([&] {
        std::vector<HistoryPoint> points = read_history(*connection_, gyro, parameter);
        // Those without a date last.
        const auto order = [](const HistoryPoint& point) {
            return std::tuple(std::isnan(point.time_s),
                              std::isnan(point.time_s) ? 0.0 : point.time_s, point.id);
        };
        std::ranges::sort(points, {}, order);
        return points;
    });
}

Result<std::optional<StoredResult>> ResultsDatabase::result(std::int64_t id) {
    return guarded([&] {
        // One state of the file, whatever is written meanwhile.
        const SqliteTransaction transaction(*connection_, "BEGIN");
        return read_result(*connection_, id);
    });
}

}  // namespace vybeg
