#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// Without spaces and tabs at both ends.
std::string_view trimmed(std::string_view text);

// True for lines that begin with #, %, // or, where fields are not separated by it, ';'.
bool is_comment(std::string_view line, char delimiter);

// Cuts a line at the delimiter into `fields`, each without the spaces and the double quotes round
// it; a delimiter inside of quotes does not cut. ' ' stands for any run of spaces and tabs. A
// delimiter behind the last field, or a '|' at both ends, makes no field.
void split_fields(std::string_view line, char delimiter, std::vector<std::string_view>& fields);

// A whole field as a number; NaN where it is empty or says that there is none ("nan", "NA"),
// infinite where the sample lies beyond the range ("inf", U+221E, "OVLD", 9.9E37 to 3.5E38);
// nothing where it is anything else. The locale plays no part. With a decimal comma a point is no
// part of a number. Fortran's D is read as E, the sign U+2212 as a minus.
std::optional<double> parse_field(std::string_view field, bool decimal_comma);

// From this magnitude on a number may be a mark of parse_field().
inline constexpr double least_mark = 9.9e37;

// The text of a number with Fortran's exponent or the sign U+2212 as others write it.
std::string usual_number(std::string_view field);

// How finely the text of a number is written: 12.50e-3 has 5 decimals and 4 significant digits.
struct NumberDigits {
    int decimals = 0;     // digits behind the decimal sign, less the exponent
    int significant = 0;  // digits from the first that is not 0 on
};
// Precondition: parse_field() takes the field for a number.
NumberDigits digits_of(std::string_view field);

}  // namespace vybeg
