#include "core/recording/text/uff_dataset.h"

#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/samples/vocabulary.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace vybeg {
namespace {

constexpr int time_response = 1;
constexpr int general = 0;
constexpr int time_axis = 17;
constexpr int unknown_axis = 0;

// The characters of a line of fixed columns, without blanks; empty behind its end.
std::string_view field(std::string_view line, std::size_t begin, std::size_t width) {
    return begin < line.size() ? trimmed(line.substr(begin, width)) : std::string_view{};
}

// Writers put "NONE" where they have nothing to tell.
std::string told(std::string_view text) {
    text = trimmed(text);
    return text == "NONE" ? std::string{} : to_utf8(text);
}

template <class Number>
std::optional<Number> number(std::string_view text) {
    Number value{};
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = parsed.ec == std::errc{} && parsed.ptr == text.data() + text.size();
    return whole ? std::optional(value) : std::nullopt;
}

// E.g. "12+X": the direction is 1, 2, 3 for the axes, 4, 5, 6 for rotations, negative the other
// way.
std::string node_and_direction(std::string_view line) {
    const auto direction = number<int>(field(line, 51, 4));
    const std::string_view node = field(line, 41, 10);
    if (!direction || *direction == 0 || std::abs(*direction) > 6 || node.empty()) {
        return {};
    }
    constexpr std::array<const char*, 6> axes{"X", "Y", "Z", "RX", "RY", "RZ"};
    return std::string(node) + (*direction > 0 ? "+" : "-") +
           axes[static_cast<std::size_t>(std::abs(*direction) - 1)];
}

}  // namespace

bool UffFunction::is_time_response() const {
    return (function == time_response || function == general) &&
           (abscissa == time_axis || abscissa == unknown_axis);
}

std::optional<UffFunction> parse_uff_header(const std::vector<std::string>& lines) {
    const std::string& kind = lines[5];
    const std::string& form = lines[6];
    const std::string& abscissa = lines[7];
    const std::string& ordinate = lines[8];
    const auto function = number<int>(field(kind, 0, 5));
    const auto data_type = number<int>(field(form, 0, 10));
    const auto count = number<std::int64_t>(field(form, 10, 10));
    const auto spacing = number<int>(field(form, 20, 10));
    const auto axis = number<int>(field(abscissa, 0, 10));
    std::vector<double> step;
    if (!function || !data_type || *data_type < 1 || *data_type > 6 || !count || *count < 0 ||
        !spacing || !axis || !parse_uff_values(field(form, 43, 13), step) || step.size() != 1) {
        return std::nullopt;
    }
    UffFunction found;
    found.name = told(lines[0]);
    if (found.name.empty()) {
        found.name = node_and_direction(kind);
    }
    found.start = told(lines[2]);
    found.unit = told(field(ordinate, 47, 20));
    found.function = *function;
    found.abscissa = *axis;
    found.data_type = *data_type;
    found.is_complex = *data_type >= 5;
    found.is_even = *spacing == 1;
    found.count = *count;
    found.step_s = step[0] * seconds_per(told(field(abscissa, 47, 20))).value_or(1);
    // Written as Fortran does, with the exponent of E or D: every digit counts, zeros too.
    const NumberDigits digits = digits_of(usual_number(field(form, 43, 13), false));
    found.step_relative_sd =
        step[0] > 0 ? std::pow(10.0, -digits.decimals) / std::sqrt(12.0) / step[0] : 0;
    return found;
}

std::optional<UffBinary> parse_uff_binary(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_of("bB") + 1, line.size()));
    std::array<std::int64_t, 4> numbers{};
    for (std::int64_t& value : numbers) {
        line = trimmed(line);
        const std::string_view word = line.substr(0, line.find(' '));
        const auto parsed = number<std::int64_t>(word);
        if (!parsed || *parsed < 0) {
            return std::nullopt;
        }
        value = *parsed;
        line.remove_prefix(word.size());
    }
    return UffBinary{static_cast<int>(std::min<std::int64_t>(numbers[0], 9)),
                     static_cast<int>(std::min<std::int64_t>(numbers[1], 9)), numbers[2],
                     numbers[3]};
}

bool parse_uff_values(std::string_view line, std::vector<double>& values) {
    std::string copy;
    if (line.find_first_of("Dd") != line.npos) {
        copy = line;
        std::replace_if(
            copy.begin(), copy.end(), [](char c) { return c == 'D' || c == 'd'; }, 'E');
        line = copy;
    }
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
        line.remove_prefix(line.front() == '+' ? 1 : 0);
        double value = 0;
        const auto parsed = fast_float::from_chars(line.data(), line.data() + line.size(), value);
        if (parsed.ec == std::errc::invalid_argument) {
            return false;
        }
        values.push_back(std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN());
        line.remove_prefix(static_cast<std::size_t>(parsed.ptr - line.data()));
    }
    return true;
}

}  // namespace vybeg
