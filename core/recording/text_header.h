#pragma once

#include "core/recording/recording.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// What the lines above the numbers call the columns.
struct TextHeader {
    std::vector<Channel> columns;  // one per column; empty names and units where they are not told
    int lines_used = 0;            // how many lines that took
};

// Names and units from the lines above the first row of numbers, of which the last ones count:
// "t [s];S_C [V]", "C (V)", "# C, V", or names and below them a line of units.
TextHeader read_header(std::span<const std::string> lines, char delimiter, int columns);

// The name and unit in one field of a header: "S_C [V]", "C (V)", "Time, s".
Channel name_and_unit(std::string_view field);

// Whether a column of this name is the time: t, time, sec, "t_ms", "Время", ...
bool is_time_name(std::string_view name);

// Whether a column of this name may number the rows: it has no name, or n, i, #, No, index, ...
bool is_counter_name(std::string_view name);

// Seconds per unit of time ("ms", "us", "мкс", ...), or nothing where it is none.
std::optional<double> seconds_per(std::string_view unit);

// The unit of a time column, from the header's unit or the end of the name ("t_ms"); empty where
// neither tells.
std::string time_unit(const Channel& column);

}  // namespace vybeg
