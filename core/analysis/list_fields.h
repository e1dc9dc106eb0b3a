#pragma once

#include <optional>
#include <string>

namespace vybeg {

// Fields of a measurement list.

// A name of a column in small letters, Latin or Russian, without the unit after a comma or in
// brackets and with "-" between its words; the usual one of names that mean the same, in Russian
// too: "Temperature, °C" and "Температура" are temperature-c.
std::string usual_column(const std::string& name);

// The value of an option as the command line takes it: a comma in a number becomes a point, signs
// of table programs (U+2212, blanks that do not break) are plain ones. Of options that take
// `several` values, those between semicolons: "5000,5;5600" is 5000.5,5600.
std::string usual_option(const std::string& field, bool several);

// A date as tables write it, 16.10.2026 or 2026-10-16, alone or with a time 9:05 or 14:05:30, as
// one of ISO 8601 with T before its time; any other text as it is.
std::string usual_date(const std::string& field);

// yes, no, да, нет, true, false, ИСТИНА, ЛОЖЬ, 1, 0, in any letters; nothing for another text.
std::optional<bool> yes_or_no(const std::string& field);

// Whether a table program runs the field as a formula: it begins with =, +, - or @, is no number
// and not this sign alone.
bool is_formula(const std::string& field);

// Whether two names, of four letters at least, differ by one letter left out, added, replaced or
// exchanged with its neighbour, or by capitals and by "_" or " " in place of "-" alone.
bool names_resemble(const std::string& one, const std::string& other);

// Whether a text is a date of ISO 8601, 2026-03-31, alone or with a time: T14:05, T14:05:30.5, with
// Z or a zone such as +03:00; a space instead of T.
bool is_iso_date(const std::string& text);

// Seconds from the start of 1970 to such a date; alone it means its start. Without a zone it counts
// as UTC, so that the dates of one laboratory keep their distances. NaN: the text is no such date.
double iso_seconds(const std::string& text);

}  // namespace vybeg
