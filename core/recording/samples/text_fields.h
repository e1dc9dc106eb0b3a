#pragma once

#include "core/base/number_text.h"
#include "core/base/plain_text.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// Of the Latin alphabet.
constexpr bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// What lines without any number or word consist of: delimiters, quotes and blanks.
inline constexpr std::string_view no_content = " \t\v\f\x1A,;|\"";

// Whether a text is one of digits alone, one or more.
constexpr bool are_digits(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// Without spaces and tabs at both ends.
std::string_view trimmed(std::string_view text);

// Whether a line begins with #, %, // or, if it is not the delimiter, ';'.
bool is_comment(std::string_view line, char delimiter);

// Splits a line at the delimiter into `fields`, without surrounding spaces and double quotes; a
// delimiter inside quotes does not split. ' ' means any number of spaces and tabs. A delimiter
// after the last field, or a '|' at both ends, adds no field.
void split_fields(std::string_view line, char delimiter, std::vector<std::string_view>& fields);

// The fields of a line above a table. A name with its unit in brackets or after a comma is one
// field even if blanks separate fields: "S_C [V]", "t, ms".
std::vector<std::string> header_fields(std::string_view line, char delimiter);

std::string_view without_comment_mark(std::string_view line);

// Number of a whole field: NaN for an empty field or a mark of a missing value ("nan", "NA"),
// infinite for an overload ("inf", U+221E, "OVLD", 9.9E37 to 3.5E38); empty for other texts.
// Independent of the locale. Fortran's D is read as E, the sign U+2212 as a minus; with a decimal
// comma, blanks and points separate thousands.
std::optional<double> parse_field(std::string_view field, bool decimal_comma);

// Least magnitude of a number that may be a mark of overload.
inline constexpr double least_mark = 9.9e37;

// Usual text of a number with Fortran's exponent or the sign U+2212, or with blanks or points
// between its thousands.
std::string usual_number(std::string_view field, bool groups);

// Resolution of the text of a number: 12.50e-3 has 5 decimals and 4 significant digits.
struct NumberDigits {
    int decimals = 0;     // digits after the decimal sign, less the exponent
    int significant = 0;  // digits from the first nonzero one on
};
// Precondition: parse_field() reads the field as a number.
NumberDigits digits_of(std::string_view field);

// A date, a time of day, or both, in one field of a table.
struct ClockField {
    bool timed = false;        // else a date alone
    std::int64_t whole_s = 0;  // seconds from midnight
    double fraction_s = 0;     // below one second
    int decimals = 0;          // digits of the fraction
};

// "12:00:05.25", "12:00:05,25 PM", "2024-05-01T12:00:05.25Z", "01.05.2024 12:00:05", "5/1/2024",
// "12:00:05+03:00 2024-05-01", "01-May-2024", ... Nothing for any other text. Zones and the order
// of day and month do not matter: a recording counts from its first row.
std::optional<ClockField> parse_clock(std::string_view field);

// Seconds from the second `from_s` of the day on. Half a day back is the next day.
double seconds_after(const ClockField& clock, std::int64_t from_s);

}  // namespace vybeg
