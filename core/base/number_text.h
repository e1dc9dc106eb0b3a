#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace vybeg {

// Numbers as text, always with a point, whatever the locale (Qt sets the C locale, and printf and
// strtod then follow it).

// Shortest text that reads back as the same double; "nan" where there is no value.
std::string round_trip_text(double value);
// The same, appended.
void append_round_trip(std::string& text, double value);
// The same into `to`, which has room for longest_round_trip characters; returns where it ends. For
// files of millions of numbers.
inline constexpr std::size_t longest_round_trip = 32;
char* write_round_trip(char* to, double value);
// `digits` significant digits; numbers below a million have no power of ten for their size.
std::string short_text(double value, int digits = 6);
std::string integer_text(std::int64_t value);
// The whole of `text` as a number (no spaces, no sign but '-', "nan" and "inf" understood), or
// nothing.
std::optional<double> parse_number(std::string_view text);

// The whole of a text as a number of this type, in digits with a '-' at most before them.
template <class Number>
std::optional<Number> whole_number(std::string_view text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    return parsed.ec == std::errc{} && parsed.ptr == end ? std::optional(number) : std::nullopt;
}

}  // namespace vybeg
