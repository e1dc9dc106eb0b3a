#pragma once

#include "core/recording/samples/recording.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The words above a table of numbers.
namespace vybeg {

// The name and unit in one field of a header: "S_C [V]", "C (V)", "Time, s", "CH1 in V", "C/V".
Channel name_and_unit(std::string_view field);

// The fields of a line above the table. A name with its unit in brackets or behind a comma is one
// field even if blanks separate fields: "S_C [V]", "t, ms".
std::vector<std::string> header_fields(std::string_view line, char delimiter);

std::string_view without_comment_mark(std::string_view line);

// Small letters for ASCII and for the Cyrillic letters А to Я.
std::string lower_text(std::string_view text);

// Whether a column of this name is the time: t, time, sec, "t_ms", "Время", ...
bool is_time_name(std::string_view name);

// Whether a name begins like one: "Time - Voltage_0", "Zeit 1".
bool begins_as_time_name(std::string_view name);

// Whether a column of this name may number the rows: it has no name, or n, i, #, No, index, ...
bool is_counter_name(std::string_view name);

// Whether a field after the last column may have no numbers below it: a comment, a marker, a flag.
bool is_remark_name(std::string_view name);

// 'c' or 'd' of a name that stands for that pick-off alone: "C", "s_d", "S_C"; 0 of others.
char channel_letter(std::string_view name);

// Seconds per unit of time ("ms", "us", "мкс", ...); empty for other texts.
std::optional<double> seconds_per(std::string_view unit);

// Unit of a time column, from the header's unit or the end of the name ("t_ms"); empty without
// either.
std::string time_unit(const Channel& column);

}  // namespace vybeg
