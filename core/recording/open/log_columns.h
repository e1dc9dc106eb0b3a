#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/open_options.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vybeg {

// Logs and tracks: tables of numbers over time that are no signals, read by the readers of
// recordings.

// What a column may be. The time, where there is one, is the first of the roles.
struct ColumnRole {
    const char* name;                // in --columns
    std::vector<const char*> names;  // of such columns in files
    bool needed = true;
};

// A column that is asked for.
struct ColumnWish {
    ColumnRole role;
    std::string column;  // its name or its number, from 1, in the file; empty: by its usual names
    bool told = false;   // named by the user: then it has to be there

    bool required() const { return role.needed || told; }
};

// `text` names roles with commas between them, each with `=COLUMN` where the file calls it
// otherwise; empty: all roles by their usual names. Roles that need not be there follow after
// those that are named. Errors: setting_invalid.
Result<std::vector<ColumnWish>> column_wishes(const std::string& text,
                                              std::span<const ColumnRole> roles);

struct LogColumn {
    std::string role;            // ColumnRole::name
    std::string name;            // in the file; empty where the column is not there
    std::string unit;            // of the header, or of the end of the name
    std::vector<double> values;  // NaN where missing; empty where the column is not there
};

struct LogTable {
    std::vector<double> time_s;  // rising
    double begun_s = 0;  // by the clock that the times of files of one device have in common
    std::vector<LogColumn> columns;  // of the wishes, in their order; that of the time is empty

    // Precondition: the role is among the wishes.
    LogColumn& of(std::string_view role) {
        return *std::ranges::find(columns, role, &LogColumn::role);
    }
    // Null: the file has no such column.
    const LogColumn* find(std::string_view role) const {
        const auto found = std::ranges::find(columns, role, &LogColumn::role);
        return found == columns.end() || found->values.empty() ? nullptr : &*found;
    }
};

// Reads the columns of a text, of NPY, NPZ, MAT or HDF5. A text without names has them in the order
// of the wishes, an array in that of the stated ones. Of MAT they are vectors, or the columns of
// the table that Moku's converter writes. Times are those of the file, never brought onto a grid;
// those of a text without times follow from --rate. A row that repeats the time of the one before
// is left out. Times in ticks, as those of LabOne, are brought to seconds by --rate, or by the
// clockbase of the _header_ file beside it. A ZIP file of one text is that text. Errors: no_log,
// column_missing, rate_unknown and those of the readers.
Result<LogTable> read_log(const std::filesystem::path& path, const OpenOptions& options,
                          std::span<const ColumnWish> wishes, const JobControl& job);

// The time, which no log needs.
ColumnRole time_of_log();

// Leaves the rows from `from_s` to `to_s` after the first. Errors: range_empty.
Status keep_times(const std::filesystem::path& path, double from_s, double to_s, LogTable& table);

// Brings values to the unit of another column ("mV" to "V"); where one of the two is unknown, they
// stay as they are.
void bring_to_unit_of(const LogColumn& other, LogColumn& column);

// Least and largest value of a column that are not missing; infinity and -infinity where all are.
std::pair<double, double> range_of(const LogColumn& column);

// Factor from a column of angles to theta_A in rad: by its unit, or else by `told` (rad per unit,
// 0: not stated); a half where its name says that it is 2 theta_A. Errors: angle_unit_unknown.
Result<double> angle_factor(const std::filesystem::path& path, const LogColumn& column,
                            double told);

}  // namespace vybeg
