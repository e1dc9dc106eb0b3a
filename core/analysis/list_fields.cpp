#include "core/analysis/list_fields.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string_view>

namespace vybeg {
namespace {

// Takes `count` digits off the front of a text.
std::optional<int> digits(std::string_view& text, std::size_t count) {
    int number = 0;
    const std::string_view front = text.substr(0, count);
    const bool only = front.size() == count &&
                      std::ranges::all_of(front, [](char c) { return c >= '0' && c <= '9'; });
    if (!only) {
        return {};
    }
    std::from_chars(front.data(), front.data() + front.size(), number);
    text.remove_prefix(count);
    return number;
}

bool take(std::string_view& text, char character) {
    const bool there = text.starts_with(character);
    text.remove_prefix(there ? 1 : 0);
    return there;
}

// 14:05, and where `seconds` are allowed 14:05:30.5.
bool take_time(std::string_view& text, bool seconds) {
    const auto hour = digits(text, 2);
    if (!hour || *hour > 23 || !take(text, ':')) {
        return false;
    }
    const auto minute = digits(text, 2);
    if (!minute || *minute > 59) {
        return false;
    }
    if (!seconds || !take(text, ':')) {
        return true;
    }
    const auto second = digits(text, 2);
    if (!second || *second > 60) {  // 60: a leap second
        return false;
    }
    if (take(text, '.') || take(text, ',')) {
        const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
        text.remove_prefix(end);
        return end > 0;
    }
    return true;
}

bool take_date(std::string_view& text) {
    const auto year = digits(text, 4);
    if (!year || !take(text, '-')) {
        return false;
    }
    const auto month = digits(text, 2);
    if (!month || !take(text, '-')) {
        return false;
    }
    const auto day = digits(text, 2);
    return day && std::chrono::year_month_day(std::chrono::year(*year),
                                              std::chrono::month(static_cast<unsigned>(*month)),
                                              std::chrono::day(static_cast<unsigned>(*day)))
                      .ok();
}

// A name without capitals, with "-" between its words.
std::string plain_name(std::string name) {
    for (char& c : name) {
        c = c == '_' || c == ' ' ? '-' : c;
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return name;
}

}  // namespace

bool names_resemble(const std::string& one, const std::string& other) {
    constexpr std::size_t shortest = 4;
    std::string a = plain_name(one);
    std::string b = plain_name(other);
    if (std::min(a.size(), b.size()) < shortest) {
        return a == b;
    }
    const auto [begin_a, begin_b] = std::ranges::mismatch(a, b);
    a.erase(a.begin(), begin_a);
    b.erase(b.begin(), begin_b);
    while (!a.empty() && !b.empty() && a.back() == b.back()) {
        a.pop_back();
        b.pop_back();
    }
    const bool exchanged = a.size() == 2 && b.size() == 2 && a[0] == b[1] && a[1] == b[0];
    return exchanged || std::max(a.size(), b.size()) <= 1;
}

std::string usual_option(const std::string& field, bool several) {
    std::string text = field;
    if (several && field.find(';') == std::string::npos) {
        return text;
    }
    std::ranges::replace(text, ',', '.');
    std::ranges::replace(text, ';', ',');
    return several || parse_number(text) ? text : field;
}

bool is_iso_date(const std::string& text) {
    std::string_view left = text;
    if (!take_date(left)) {
        return false;
    }
    if (left.empty()) {
        return true;
    }
    if (!(take(left, 'T') || take(left, ' ')) || !take_time(left, true)) {
        return false;
    }
    if (take(left, 'Z') || left.empty()) {
        return left.empty();
    }
    return (take(left, '+') || take(left, '-')) && take_time(left, false) && left.empty();
}

}  // namespace vybeg
