#pragma once

#include "core/base/diagnostic.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/database/sqlite.h"
#include "core/database/stored_result.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// A gyro of a database.
struct StoredGyro {
    std::string name;  // empty: results that name none
    std::int64_t results = 0;
};

// What a result is called.
struct StoredName {
    std::string set;
    std::string gyro;

    friend bool operator==(const StoredName&, const StoredName&) = default;
};

// The warning that a database keeps one result for these two names.
Diagnostic same_recordings(const StoredName& kept, const StoredName& lost);

// Results of a laboratory in one SQLite file, which several programs on several machines may write
// at once. Each result is there whole or not at all. Not for two threads at once.
class ResultsDatabase {
public:
    enum class Access { read, write };
    using WhenWaiting = std::function<void(const Diagnostic&)>;

    // Opens the file; to write, makes it where there is none. `patience_s`: how long any later call
    // waits for other writers; `waits` receives a diagnostic once in each wait that is longer than
    // half a second. `job`: an interruption ends the wait. Errors, also of all calls
    // below: interrupted; to write output_failed, to read file_missing and file_read_failed, with
    // the reason: the system's, a lock, damage, another kind of file, a later schema.
    static Result<ResultsDatabase> open(const std::filesystem::path& path, Access access,
                                        const JobControl& job, double patience_s = 60,
                                        WhenWaiting waits = {});

    // Made at random with the file: another file at this path has another.
    Result<std::string> identity();

    // The largest id of a result; 0: there is none.
    Result<std::int64_t> last_id();

    // Writes a result in one transaction and returns its id, `wanted` where that is free; it is on
    // the disk then. A result whose key the file has already replaces that one and keeps its id:
    // the same recordings and settings were computed again, perhaps by a later version or with
    // corrected conditions.
    Result<std::int64_t> add(const StoredResult& result, std::optional<std::int64_t> wanted = {});

    // Set and gyro of the result of this key; nothing: there is none.
    Result<std::optional<StoredName>> holder(const std::string& key);

    // By name.
    Result<std::vector<StoredGyro>> gyros();
    // The results that have this parameter, by date; those without a date last, in the order in
    // which they came. Without `gyro`, of all gyros.
    Result<std::vector<HistoryPoint>> history(const std::optional<std::string>& gyro,
                                              const std::string& parameter);
    // All of a result; nothing: the file has no such id.
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
