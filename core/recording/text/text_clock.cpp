#include "core/recording/text/text_clock.h"

#include "core/base/plain_text.h"
#include "core/recording/samples/text_fields.h"

#include <cmath>

namespace vybeg {
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
    if (digits.empty() || digits.size() > 2) {
        return -1;
    }
    int value = 0;
    for (const char c : digits) {
        value = 10 * value + (c - '0');
    }
    return value < limit ? value : -1;
}

// Takes a date and what separates it from a time; false where the text does not begin with one.
bool take_date(std::string_view& text) {
    std::string_view rest = text;
    const std::string_view first = take_while(rest, is_digit);
    const char separator = rest.empty() ? '\0' : rest.front();
    if (first.empty() || first.size() > 4 ||
        (separator != '-' && separator != '/' && separator != '.')) {
        return false;
    }
    rest.remove_prefix(1);
    const bool named = !rest.empty() && is_letter(rest.front());
    const std::string_view middle =
        named ? take_while(rest, is_letter) : take_while(rest, is_digit);
    if (rest.empty() || rest.front() != separator ||
        (named ? middle.size() != 3 : small_number(middle, 32) < 1)) {
        return false;
    }
    rest.remove_prefix(1);
    const std::string_view last = take_while(rest, is_digit);
    const bool year_first = first.size() == 4;
    if (year_first ? small_number(last, 32) < 1
                   : (small_number(first, 32) < 1 || (last.size() != 2 && last.size() != 4))) {
        return false;
    }
    // Behind a date stand a time or nothing: 1.5.24.7 is none.
    if (!rest.empty() && rest.front() != 'T' && rest.front() != ' ' && rest.front() != '_') {
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
        for (const char c : digits) {
            value = 10 * value + (c - '0');
        }
        clock.decimals = static_cast<int>(digits.size());
        clock.fraction_s = static_cast<double>(value) / std::pow(10.0, clock.decimals);
    }
    // "12:00:05+03:00 2024-05-01": behind the time, its zone and the date.
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
