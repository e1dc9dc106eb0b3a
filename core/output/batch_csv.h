#pragma once

#include "core/analysis/identify.h"
#include "core/analysis/measurement_list.h"
#include "core/base/error.h"
#include "core/output/identify_json.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vybeg {

// The table of a batch, RESULTS.csv of the help, line by line without line feeds.

// The names of the table's own columns; those of the list come behind them.
std::vector<std::string> batch_columns();

// Whether the file begins as a table of batch_head() does, whose program is the command line.
bool is_batch_table(const std::filesystem::path& path);

// "# " lines and the line of names, for a list with these unknown columns. An unknown column whose
// name is one of the table's has "list_" before it.
std::string batch_head(std::span<const std::string> header,
                       std::span<const std::string> other_columns);

// The row of a set that has no result.
std::string batch_row(const MeasurementSet& set, const Error& error);

// The row of a set; `comparison`: with its gyro's passport, null: there is none. A serious warning
// stands as the message, in place of a verdict.
std::string batch_row(const MeasurementSet& set, const Identification& found,
                      const PassportComparison* comparison);

// Texts as a row of such a table: in quotes where they hold a separator.
std::string csv_row(const std::vector<std::string>& texts);

}  // namespace vybeg
