#pragma once

#include "core/database/sqlite.h"
#include "core/database/stored_result.h"

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace vybeg {

// Results as rows of the tables of results_database.cpp. All throw SqliteFailure; the reading ones
// also DamagedRow.

// A row whose texts are not what was written.
struct DamagedRow : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Adds or replaces the result of this key, and returns its id: of a new one `wanted` where that is
// free. Within a transaction of the caller.
std::int64_t write_result(SqliteConnection& connection, const StoredResult& result,
                          std::optional<std::int64_t> wanted = {});

// All rows of a result; nothing: there is none.
std::optional<StoredResult> read_result(SqliteConnection& connection, std::int64_t id);

// The points of a parameter of one gyro, or of all, in no order.
std::vector<HistoryPoint> read_history(SqliteConnection& connection,
                                       const std::optional<std::string>& gyro,
                                       const std::string& parameter);

}  // namespace vybeg
