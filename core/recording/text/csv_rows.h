#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace vybeg {

// One row of a CSV file; `line` is that on which it begins, from 1.
struct CsvRow {
    std::int64_t line = 0;
    std::vector<std::string> fields;
};

// A table of texts: a row of names, then the rows that hold any text. No row has more fields than
// there are names; fields missing at its end are empty.
struct CsvRows {
    std::string file;  // its path, for errors
    std::vector<std::string> names;
    std::vector<CsvRow> rows;

    bool has(const std::string& name) const;
    // Empty where no column has the name.
    const std::string& field(const CsvRow& row, const std::string& name) const;
    // list_invalid of this file.
    Error invalid(std::int64_t line, const std::string& column, MessageArg reason) const;
};

// The fields of one row with commas between them; quotes as in read_csv().
std::vector<std::string> csv_fields(const std::string& row);

// The usual name of a column that is written in other letters or in another language.
using UsualName = std::function<std::string(const std::string&)>;
inline const UsualName same_name = [](const std::string& name) { return name; };

// Reads a CSV file of spreadsheets: comma, semicolon or tabulator, whichever separates a name
// `needed` from the others; before the names empty lines, a line `sep=;` and lines with `#`. Fields
// in double quotes (RFC 4180) may hold separators, line ends and doubled quotes. UTF-8 with or
// without byte order mark, UTF-16 with it, otherwise Windows-1251. Spaces around a field are
// removed. Errors: those of reading a file; format_limit for a line longer than 1 MiB; list_invalid
// with the line and the column.
Result<CsvRows> read_csv(const std::filesystem::path& path, const std::string& needed,
                         const UsualName& usual = same_name);

// Whether the first row of such a file has this name; false also for a file that cannot be read.
bool csv_has_name(const std::filesystem::path& path, const std::string& name,
                  const UsualName& usual = same_name);

}  // namespace vybeg
