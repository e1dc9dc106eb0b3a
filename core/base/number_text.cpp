#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace vybeg {
namespace {

template <class... Format>
void append(std::string& text, double value, Format... format) {
    if (std::isnan(value)) {
        text += "nan";  // to_chars may write "-nan"
        return;
    }
    std::array<char, 64> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...);
    text.append(buffer.data(), end.ptr);
}

}  // namespace

std::string round_trip_text(double value) {
    std::string text;
    append(text, value);
    return text;
}

void append_round_trip(std::string& text, double value) {
    append(text, value);
}

char* write_round_trip(char* to, double value) {
    if (std::isnan(value)) {
        constexpr std::string_view nan = "nan";
        return std::copy(nan.begin(), nan.end(), to);
    }
    return std::to_chars(to, to + longest_round_trip, value).ptr;
}

std::string short_text(double value, int digits) {
    std::string text;
    append(text, value, std::chars_format::general, digits);
    // "100" rather than "1e+02".
    constexpr double most_plain = 1e6;
    if (text.find("e+") != std::string::npos && std::abs(value) < most_plain) {
        const double rounded = parse_number(text).value_or(value);
        text.clear();
        append(text, rounded, std::chars_format::fixed, 0);
    }
    return text;
}

std::string integer_text(std::int64_t value) {
    return std::to_string(value);
}

std::optional<double> parse_number(std::string_view text) {
    double value = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end.ec != std::errc{} || end.ptr != text.data() + text.size()) {
        return std::nullopt;
    }
    return value;
}

}  // namespace vybeg
