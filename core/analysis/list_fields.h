#pragma once

#include <string>

namespace vybeg {

// Fields of a measurement list.

// The value of an option as the command line takes it: a comma in a number becomes a point. Of
// options that take `several` values, those between semicolons: "5000,5;5600" is 5000.5,5600.
std::string usual_option(const std::string& field, bool several);

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
