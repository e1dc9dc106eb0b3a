#pragma once

#include "core/analysis/passport.h"
#include "core/base/diagnostic.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/database/sqlite.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace vybeg {

// Where the date of a result is from.
enum class DateSource { none, list, recording };

// The date of a result, ISO 8601; empty: neither the list nor a recording has one.
struct StoredDate {
    std::string text;
    DateSource source = DateSource::none;

    friend bool operator==(const StoredDate&, const StoredDate&) = default;
};

// What a result is called.
struct StoredName {
    std::string set;   // in its list
    std::string gyro;  // empty: not stated

    friend bool operator==(const StoredName&, const StoredName&) = default;
};

// One result in the history of a parameter.
struct HistoryPoint : StoredName {
    std::int64_t id = 0;  // of ResultsDatabase::result()
    StoredDate date;
    double time_s = 0;   // of the date, iso_seconds(); NaN: there is none
    Estimate f_mean_hz;  // mean frequency, which follows the temperature
    Estimate value;      // without one: NaN with the reason
    // Of the recordings that state them; NaN: none does. The temperature is their mean.
    double bias_v = 0;
    double temperature_c = 0;
    bool exchanged = false;
    std::string program;
    std::string warnings;  // warning_kinds() of the result
};

// A parameter by its name in identify JSON: those of resonator_parameters.h, and of each mode
// "modes[0].f_hz", ...
struct StoredParameter {
    std::string name;
    Estimate estimate;
};

// The result of one set as the database keeps it.
struct StoredResult : StoredName {
    std::string key;  // what makes it the same result: SHA-256 of its recordings and settings
    StoredDate date;
    std::string program;                   // name and version
    std::string model;                     // "structured" or "free"
    std::string warnings;                  // warning_kinds()
    std::vector<RecordingRef> recordings;  // with absolute paths
    std::string json;                      // as identify writes it
    // For history() and other programs; ResultsDatabase::result() leaves these empty.
    std::vector<StoredParameter> parameters;
    RawParameters raw;
};

// The first date in the list, otherwise the first start of a recording that is ISO 8601.
StoredDate date_of(const MeasurementSet& set);

// A result as it is to be stored; `json` of identify_json(). The key depends on the content of the
// recordings, on the channels, options and settings with which each was read, and on the settings
// of the fit, not on names, conditions, threads, the program's version or the order of the
// recordings. Errors: those of text_sha256().
Result<StoredResult> stored_result(const SetResult& result, std::string json);

// Results as rows of the tables of results_database.cpp. All throw SqliteFailure; the reading ones
// also DamagedRow.

// A row whose texts are not what was written.
struct DamagedRow : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A result that has been written.
struct AddedResult {
    std::int64_t id = 0;
    std::optional<StoredName> replaced;  // what the result of this key was called before
};

// Adds or replaces the result of this key: a new one with the id `wanted` where that is free.
// Within a transaction of the caller.
AddedResult write_result(SqliteConnection& connection, const StoredResult& result,
                         std::optional<std::int64_t> wanted = {});

// A result without its parameters; nothing: there is none.
std::optional<StoredResult> read_result(SqliteConnection& connection, std::int64_t id);

// The points of a parameter of one gyro, or of all, in no order.
std::vector<HistoryPoint> read_history(SqliteConnection& connection,
                                       const std::optional<std::string>& gyro,
                                       const std::string& parameter);

// A gyro of a database.
struct StoredGyro {
    std::string name;  // empty: results that name none
    std::int64_t results = 0;
};

// The warning that a database keeps one result for these two names; none: they are the same.
std::vector<Diagnostic> same_recordings(const StoredName& kept, const StoredName& lost);

// Results of a laboratory in one SQLite file, which several programs on several machines may write
// at once. Each result is there whole or not at all. Not for two threads at once.
class ResultsDatabase {
public:
    enum class Access { read, write };
    using WhenWaiting = std::function<void(const Diagnostic&)>;

    // Opens the file; to write, makes it where there is none. `waits` receives a diagnostic once in
    // each wait for other writers that is longer than half a second; `patience_s`: how long any
    // later call waits. `job`: an interruption ends the wait. Errors, also of all calls
    // below: interrupted; to write output_failed, to read file_missing and file_read_failed, with
    // the reason: the system's, a lock, damage, another kind of file, a later schema.
    static Result<ResultsDatabase> open(const std::filesystem::path& path, Access access,
                                        const JobControl& job, WhenWaiting waits = {},
                                        double patience_s = 60);

    // Made at random with the file: another file at this path has another.
    Result<std::string> identity();

    // The largest id of a result; 0: there is none.
    Result<std::int64_t> last_id();

    // Writes a result in one transaction, with the id `wanted` where that is free; it is on the
    // disk then. A result whose key the file has already replaces that one and keeps its id:
    // the same recordings and settings were computed again, perhaps by a later version or with
    // corrected conditions.
    Result<AddedResult> add(const StoredResult& result, std::optional<std::int64_t> wanted = {});

    // By name.
    Result<std::vector<StoredGyro>> gyros();
    // The results that have this parameter, by date; those without a date last, in the order in
    // which they came. Without `gyro`, of all gyros.
    Result<std::vector<HistoryPoint>> history(const std::optional<std::string>& gyro,
                                              const std::string& parameter);
    // A result without its parameters; nothing: the file has no such id.
    Result<std::optional<StoredResult>> result(std::int64_t id);

private:
    ResultsDatabase(std::filesystem::path path, Access access, const JobControl& job,
                    double patience_s);
    void connect(WhenWaiting waits);
    Error refused(const MessageArg& reason) const;
    Error error_of_failure(const SqliteFailure& failure) const;
    template <class Work>
    auto guarded(const Work& work) -> Result<decltype(work())>;

    std::filesystem::path path_;
    Access access_;
    JobControl job_;
    double patience_s_;
    std::unique_ptr<SqliteConnection> connection_;
};

}  // namespace vybeg
