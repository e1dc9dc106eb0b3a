#pragma once

#include "core/recording/samples/recording.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The words that files use for columns, units and rates: one table of names, one of units, and one
// spelling in which names are compared.
namespace vybeg {

// The meaning of the name of a column, a variable or an attribute, or of the first field of a line
// above a table.
enum class Meaning : std::uint8_t {
    other,
    time,       // "t", "Time", "Время"
    counter,    // number of the row: "n", "#", "No.", no name at all
    remark,     // a field after the last column that may have no numbers below it: "Comment"
    channel_c,  // that pick-off alone: "C", "s_c", "Channel C"
    channel_d,
    rate,       // sample rate
    step,       // its inverse
    start,      // of the times
    names,      // the line names the columns
    units,      // the line or attribute has units
    axis_unit,  // the line has the unit of the times
    unit        // a unit below the name of a column; anywhere else a name: "counts", "a"
};

// Names that mean something in one kind of file only.
enum class NamedIn : std::uint8_t { any_file, text, variables };

// Precondition: UTF-8. Case, blanks, also those that no line breaks at, minus signs, quotes, colons
// and a pair of brackets round the name do not matter.
Meaning meaning_of(std::string_view name, NamedIn where = NamedIn::any_file);

// The spelling in which names are compared: "Vertical Units :" is "verticalunits".
std::string normal_name(std::string_view name);

// "[V]" and "(V)" as "V".
std::string_view without_brackets(std::string_view text);

// The name and unit in one field of a header: "S_C [V]", "C (V)", "Time, s", "CH1 in V", "C/V".
Channel name_and_unit(std::string_view field);

// Columns of whole-angle logs: the angle of the wave, and the efforts of its control.
inline const std::vector<const char*> wave_angle_names{
    "theta",       "theta_rad", "theta_deg",       "theta_A",
    "theta_A_rad", "angle",     "two_theta_A_rad", "угол"};
inline const std::vector<const char*> amplitude_effort_names{
    "amplitude", "amplitude effort", "amplitude_effort", "амплитуда", "усилие амплитуды"};
inline const std::vector<const char*> quadrature_effort_names{
    "quadrature", "quadrature effort", "quadrature_effort", "квадратура", "усилие квадратуры"};

// Part after the last '.' or '/' of a path: "C" of "run.C" or "/run/C".
std::string_view last_name(std::string_view path);

// Whether a column of this name is the time: t, time, sec, "t_ms", "Время", ...
bool is_time_name(std::string_view name);

// Whether a name begins like one: "Time - Voltage_0", "Zeit 1".
bool begins_as_time_name(std::string_view name);

// Unit of a time column, from the header's unit or the end of the name ("t_ms"); empty without
// either.
std::string time_unit(const Channel& column);

// Seconds per unit of time ("ms", "us", "мкс", ...); empty for other texts.
std::optional<double> seconds_per(std::string_view unit);

// Hertz per unit of a rate: 1000 of "kHz" and "kS/s". Empty for other units.
std::optional<double> hertz_per(std::string_view unit);

// Sample rate (Hz) from a number of a file: the number itself of a Meaning::rate, its inverse of a
// Meaning::step. `unit` is that of the number ("kHz", "ms"), empty: Hz or s. Empty for other
// meanings, unsuitable units and rates that are not positive.
std::optional<double> rate_in_hz(Meaning meaning, double value, std::string_view unit);

// The same of a named number.
std::optional<double> rate_by_name(std::string_view name, double value, std::string_view unit = {});

// Factor from the unit `from` of samples to the unit `to`: 1e-3 from "mV" to "V", 1 from "Volt" to
// "В", 1 for equal texts. Empty for units of different quantities and for unknown units.
std::optional<double> unit_ratio(std::string_view from, std::string_view to);

// Whether the text is a unit of samples with or without a prefix ("V", "мВ", "m/s").
bool is_known_unit(std::string_view text);

// The same, or a unit of time.
bool is_any_unit(std::string_view text);

// The same in a line of units below the names, where a text is hardly a name: also "mv", "counts".
bool is_unit_below_name(std::string_view text);

}  // namespace vybeg
