#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/measurement_list.h"
#include "core/base/error.h"
#include "core/output/identify_json.h"
#include "core/resonator/results/resonator_parameters.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vybeg {

// The table of a batch, RESULTS.csv of the help: its head and lines without line feeds, and the
// fields of its rows, which are plain texts.
using BatchRow = std::vector<std::string>;

// Column `passed` of a table with limits, beside `failed_by`, and its field: "yes", "no",
// "undecided"; empty: no limit is one of this set.
inline constexpr const char* passed_column = "passed";
const char* passed_text(const std::optional<Conformity>& conformity);

// The names of the table's own columns; those of the list follow them. `limits`: with the
// fields above.
std::vector<std::string> batch_columns(bool limits = false);

// Whether the file begins as a table of batch_head() does, whose program is the command line.
bool is_batch_table(const std::filesystem::path& path);

// "# " lines and the line of names, for a list with these unknown columns. An unknown column whose
// name is one of the table's has "list_" before it.
std::string batch_head(std::span<const std::string> header,
                       std::span<const std::string> other_columns, bool limits = false);

// The row of a set as the list has it; status and message are empty.
BatchRow batch_row(const MeasurementSet& set);

// The row of a set that has no result; `limits`: none, the table has none.
BatchRow batch_row(const MeasurementSet& set, const Error& error,
                   const std::optional<LimitVerdict>& limits);

// The row of a set. A serious warning is its message, in place of a verdict.
BatchRow batch_row(const SetResult& result, const std::optional<LimitVerdict>& limits);

// The head of the same table for table programs: a byte order mark and the line of names.
std::string excel_head(const std::string& head);

// A row of the table as table programs of countries with a decimal comma read it: ";" between its
// fields, a comma in the numbers of the table's own columns.
std::string excel_row(BatchRow row, bool limits);

// Whether a resonator keeps its limits. Numbers that may be wrong by a serious warning decide
// nothing, nor does a set without a result (null).
LimitVerdict limit_verdict(const Identification* found, const std::vector<ParameterLimit>& limits);

// Texts as a row of such a table: in quotes where they hold a separator.
std::string csv_row(const std::vector<std::string>& texts, char separator = ',');

// A number as a field of a row: empty where there is none.
std::string csv_number(double value);

// The lines above such a table.
std::string comment_lines(std::span<const std::string> lines);

}  // namespace vybeg
