#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vybeg {

// Numbers as text, always with a point, whatever the locale (Qt sets the C locale, and printf and
// strtod then follow it).

// Shortest text that reads back as the same double; "nan" where there is no value.
std::string round_trip_text(double value);
// The same, appended: for files of millions of numbers.
void append_round_trip(std::string& text, double value);
// `digits` significant digits.
std::string short_text(double value, int digits = 6);
std::string integer_text(std::int64_t value);
// The whole of `text` as a number (no spaces, no sign but '-', "nan" and "inf" understood), or
// nothing.
std::optional<double> parse_number(std::string_view text);

}  // namespace vybeg
