#include "core/recording/samples/text_fields.h"

#include "core/base/plain_text.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace vybeg {
namespace {

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\x1A';
}

std::string_view unquoted(std::string_view field) {
    field = trimmed(field);
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"') {
        field = trimmed(field.substr(1, field.size() - 2));
    }
    return field;
}

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double most_mark = 3.5e38;        // the largest number of 32 bits, and its neighbours
constexpr double no_number_mark = 9.91e37;  // SCPI's NaN; its infinity is least_mark

constexpr std::string_view minus_sign = "\xE2\x88\x92";     // U+2212
constexpr std::string_view infinity_sign = "\xE2\x88\x9E";  // U+221E
constexpr std::size_t longest_unusual = 64;                 // bytes of such a number or word

constexpr std::array<std::string_view, 6> missing_words{"na", "n/a", "#n/a", "null", "--", "---"};
constexpr std::array<std::string_view, 7> over_range_words{
    "overload", "ovld", "overrange", "over range", "over", "clipped", "overflow"};

// Whether one of the words is the field, in lower or upper case; of a head most fields are asked.
template <std::size_t count>
bool says(const std::array<std::string_view, count>& words, std::string_view field) {
    const auto same = [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b + 32 : b); };
    return std::ranges::any_of(words, [&](std::string_view word) {
        return std::equal(word.begin(), word.end(), field.begin(), field.end(), same);
    });
}

std::optional<double> usual_value(std::string_view field, bool decimal_comma) {
    if (field.front() == '+' && field.size() > 1 && field[1] != '-') {
        field.remove_prefix(1);
    }
    // "1, 2", split at the blank, is no pair of numbers with decimal commas.
    if (decimal_comma && field.back() == ',') {
        return std::nullopt;
    }
    double value = 0;
    const char* end = field.data() + field.size();
    const auto parsed = fast_float::from_chars_advanced(
        field.data(), end, value,
        fast_float::parse_options(fast_float::chars_format::general, decimal_comma ? ',' : '.'));
    if (parsed.ec == std::errc::invalid_argument || parsed.ptr != end) {
        return std::nullopt;
    }
    const double magnitude = std::abs(value);
    if (magnitude == no_number_mark) {
        return missing;
    }
    const bool mark = magnitude >= least_mark && magnitude <= most_mark;
    return mark ? std::copysign(std::numeric_limits<double>::infinity(), value) : value;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && is_blank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

bool is_comment(std::string_view line, char delimiter) {
    line = trimmed(line);
    return line.starts_with('#') || line.starts_with('%') || line.starts_with("//") ||
           (delimiter != ';' && line.starts_with(';'));
}

void split_fields(std::string_view line, char delimiter, std::vector<std::string_view>& fields) {
    fields.clear();
    // A leading tab is an empty first field of a tab-separated line: only blanks may be trimmed.
    if (delimiter != '\t') {
        line = trimmed(line);
    }
    if (delimiter == '|' && line.starts_with('|')) {
        line.remove_prefix(1);
    }
    const auto cuts = [delimiter](char c) {
        return c == delimiter || (delimiter == ' ' && is_blank(c));
    };
    std::size_t begin = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        quoted = line[i] == '"' ? !quoted : quoted;
        if (quoted || !cuts(line[i])) {
            continue;
        }
        fields.push_back(unquoted(line.substr(begin, i - begin)));
        while (delimiter == ' ' && i + 1 < line.size() && is_blank(line[i + 1])) {
            ++i;
        }
        begin = i + 1;
    }
    if (!trimmed(line.substr(begin)).empty()) {
        fields.push_back(unquoted(line.substr(begin)));
    }
}

std::string_view without_comment_mark(std::string_view line) {
    line = trimmed(line);
    while (!line.empty() && (line.front() == '#' || line.front() == '%' || line.front() == ';')) {
        line.remove_prefix(1);
    }
    while (line.starts_with("//")) {
        line.remove_prefix(2);
    }
    return trimmed(line);
}

std::vector<std::string> header_fields(std::string_view line, char delimiter) {
    std::vector<std::string_view> parts;
    split_fields(is_comment(line, delimiter) ? without_comment_mark(line) : line, delimiter, parts);
    std::vector<std::string> fields;
    for (const std::string_view part : parts) {
        // "S_C [V]", "t, ms" between blanks
        if (delimiter == ' ' && !fields.empty() &&
            (part.starts_with('[') || part.starts_with('(') || fields.back().ends_with(','))) {
            fields.back().append(" ").append(part);
        } else {
            fields.emplace_back(part);
        }
    }
    return fields;
}

std::string usual_number(std::string_view field, bool groups) {
    // A blank, or a point, before three digits and no fourth, after another digit; without a
    // break, also of Windows-1251.
    const auto group_blank = [](std::string_view rest) -> std::size_t {
        for (const std::string_view blank : {" ", "\xC2\xA0", "\xE2\x80\xAF", "\xA0", "."}) {
            if (rest.starts_with(blank)) {
                const std::string_view digits = rest.substr(blank.size());
                const auto count = std::min(digits.find_first_not_of("0123456789"), digits.size());
                return count == 3 ? blank.size() : 0;
            }
        }
        return 0;
    };
    std::string text;
    for (std::size_t i = 0; i < field.size(); ++i) {
        const std::string_view rest = field.substr(i);
        if (const auto blank =
                groups && !text.empty() && is_digit(text.back()) ? group_blank(rest) : 0) {
            i += blank - 1;
        } else if (rest.starts_with(minus_sign)) {
            text += '-';
            i += minus_sign.size() - 1;
        } else if (rest.starts_with(infinity_sign)) {
            text += "inf";
            i += infinity_sign.size() - 1;
        } else {
            const bool exponent =
                (field[i] == 'd' || field[i] == 'D') && i > 0 &&
                (is_digit(field[i - 1]) || field[i - 1] == '.' || field[i - 1] == ',');
            text += exponent ? 'e' : field[i];
        }
    }
    return text;
}

std::optional<double> parse_field(std::string_view field, bool decimal_comma) {
    if (field.empty()) {
        return missing;
    }
    if (const auto value = usual_value(field, decimal_comma)) {
        return value;
    }
    if (field.size() > longest_unusual) {
        return std::nullopt;
    }
    if (says(missing_words, field)) {
        return missing;
    }
    if (says(over_range_words, field)) {
        return std::numeric_limits<double>::infinity();
    }
    const std::string usual = usual_number(field, decimal_comma);
    return usual == field ? std::nullopt : usual_value(usual, decimal_comma);
}

NumberDigits digits_of(std::string_view field) {
    std::size_t end = 0;  // of the digits, where the exponent begins
    std::size_t sign = std::string_view::npos;
    std::size_t first = std::string_view::npos;  // position of the first digit other than 0
    for (; end < field.size() && field[end] != 'e' && field[end] != 'E'; ++end) {
        if (field[end] == '.' || field[end] == ',') {
            sign = end;
        } else if (first > end && field[end] >= '1' && field[end] <= '9') {
            first = end;
        }
    }
    NumberDigits digits;
    if (sign != std::string_view::npos) {
        digits.decimals = static_cast<int>(end - sign - 1);
    }
    if (first != std::string_view::npos) {
        const bool with_sign = sign != std::string_view::npos && sign > first;
        digits.significant = static_cast<int>(end - first - (with_sign ? 1 : 0));
    }
    std::size_t i = end + 1;
    i += i < field.size() && field[i] == '+' ? 1 : 0;
    int exponent = 0;
    if (i < field.size()) {
        std::from_chars(field.data() + i, field.data() + field.size(), exponent);
    }
    digits.decimals -= exponent;
    return digits;
}

namespace {

constexpr std::int64_t day_s = 86400;
constexpr std::size_t most_fraction_digits = 18;

// Takes the characters off the front of `text` that `is` holds for.
template <class Predicate>
std::string_view take_while(std::string_view& text, Predicate is) {
    std::size_t count = 0;
    while (count < text.size() && is(text[count])) {
        ++count;
    }
    const std::string_view taken = text.substr(0, count);
    text.remove_prefix(count);
    return taken;
}

// A number of one or two digits below `limit`; -1 where there is none.
int small_number(std::string_view digits, int limit) {
    const auto value = digits.size() <= 2 ? whole_number<int>(digits) : std::nullopt;
    return value && *value < limit ? *value : -1;
}

// Takes a date and what separates it from a time; false where the text does not begin with one.
bool take_date(std::string_view& text) {
    const auto is_day = [](std::string_view digits) { return small_number(digits, 32) >= 1; };
    const auto is_one_of = [](std::string_view all, char c) {
        return all.find(c) != std::string_view::npos;
    };
    std::string_view rest = text;
    const std::string_view first = take_while(rest, is_digit);
    const char separator = rest.empty() ? '\0' : rest.front();
    if (!is_one_of("-/.", separator)) {
        return false;
    }
    rest.remove_prefix(1);
    const bool named = !rest.empty() && is_letter(rest.front());
    const std::string_view middle = take_while(rest, named ? is_letter : is_digit);
    if (!rest.starts_with(separator) || !(named ? middle.size() == 3 : is_day(middle))) {
        return false;
    }
    rest.remove_prefix(1);
    const std::string_view last = take_while(rest, is_digit);
    const bool is_date =
        first.size() == 4 ? is_day(last) : is_day(first) && (last.size() == 2 || last.size() == 4);
    // Only a time may follow a date: 1.5.24.7 is none.
    if (!is_date || (!rest.empty() && !is_one_of("T _", rest.front()))) {
        return false;
    }
    rest.remove_prefix(rest.empty() ? 0 : 1);
    text = trimmed(rest);
    return true;
}

// Takes "AM", "PM" or a zone; false where anything else is left.
bool take_ending(std::string_view text, std::int64_t& whole_s) {
    text = trimmed(text);
    if (text == "AM" || text == "am" || text == "PM" || text == "pm") {
        const bool afternoon = text.front() == 'P' || text.front() == 'p';
        whole_s = whole_s % (day_s / 2) + (afternoon ? day_s / 2 : 0);
        return true;
    }
    if (text.starts_with("UTC") || text.starts_with("GMT")) {
        text.remove_prefix(3);
    } else if (text.starts_with('Z')) {
        text.remove_prefix(1);
    }
    if (!text.empty() && (text.front() == '+' || text.front() == '-')) {
        text.remove_prefix(1);
        take_while(text, [](char c) { return is_digit(c) || c == ':'; });
    }
    return text.empty();
}

}  // namespace

std::optional<ClockField> parse_clock(std::string_view field) {
    if (field.empty() || !is_digit(field.front())) {
        return std::nullopt;
    }
    ClockField clock;
    const bool dated = take_date(field);
    if (dated && field.empty()) {
        return clock;
    }
    clock.timed = true;
    const int hours = small_number(take_while(field, is_digit), 25);
    int parts = 1;
    for (; !field.empty() && field.front() == ':' && parts < 3; ++parts) {
        field.remove_prefix(1);
        // Of seconds there are 61 where one is inserted.
        const int part = small_number(take_while(field, is_digit), parts == 1 ? 60 : 61);
        if (part < 0) {
            return std::nullopt;
        }
        clock.whole_s = 60 * clock.whole_s + part;
    }
    if (hours < 0 || parts < 3) {
        return std::nullopt;
    }
    clock.whole_s += 3600 * static_cast<std::int64_t>(hours);
    if (!field.empty() && (field.front() == '.' || field.front() == ',' || field.front() == ':')) {
        field.remove_prefix(1);
        const std::string_view digits = take_while(field, is_digit);
        if (digits.empty() || digits.size() > most_fraction_digits) {
            return std::nullopt;
        }
        std::int64_t value = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
        clock.decimals = static_cast<int>(digits.size());
        clock.fraction_s = static_cast<double>(value) / std::pow(10.0, clock.decimals);
    }
    // "12:00:05+03:00 2024-05-01": after the time, its zone and the date.
    const std::string_view behind = trimmed(field);
    const std::size_t blank = dated ? std::string_view::npos : behind.rfind(' ');
    std::string_view date = behind.substr(blank == std::string_view::npos ? 0 : blank + 1);
    if (!dated && take_date(date) && date.empty()) {
        field = behind.substr(0, blank == std::string_view::npos ? 0 : blank);
    }
    return take_ending(field, clock.whole_s) ? std::optional(clock) : std::nullopt;
}

double seconds_after(const ClockField& clock, std::int64_t from_s) {
    std::int64_t whole = clock.whole_s - from_s;
    whole += whole < -day_s / 2 ? day_s : 0;
    return static_cast<double>(whole) + clock.fraction_s;
}

}  // namespace vybeg
