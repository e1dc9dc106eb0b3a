#include "core/analysis/list_fields.h"

#include "core/base/number_text.h"
#include "core/base/plain_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>

namespace vybeg {
namespace {

// Takes `count` digits off the front of a text.
std::optional<int> digits(std::string_view& text, std::size_t count) {
    int number = 0;
    const std::string_view front = text.substr(0, count);
    const bool only = front.size() == count && std::ranges::all_of(front, is_digit);
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

// 14:05, and where `seconds` are allowed 14:05:30.5, as seconds.
std::optional<double> take_time(std::string_view& text, bool seconds) {
    const auto hour = digits(text, 2);
    if (!hour || *hour > 23 || !take(text, ':')) {
        return {};
    }
    const auto minute = digits(text, 2);
    if (!minute || *minute > 59) {
        return {};
    }
    const double minutes = 3600.0 * *hour + 60.0 * *minute;
    if (!seconds || !take(text, ':')) {
        return minutes;
    }
    const auto second = digits(text, 2);
    if (!second || *second > 60) {  // 60: a leap second
        return {};
    }
    double fraction = 0;
    if (take(text, '.') || take(text, ',')) {
        const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
        const auto decimals = parse_number("0." + std::string(text.substr(0, end)));
        if (end == 0 || !decimals) {
            return {};
        }
        fraction = *decimals;
        text.remove_prefix(end);
    }
    return minutes + *second + fraction;
}

// As seconds since 1970-01-01.
std::optional<double> take_date(std::string_view& text) {
    const auto year = digits(text, 4);
    if (!year || !take(text, '-')) {
        return {};
    }
    const auto month = digits(text, 2);
    if (!month || !take(text, '-')) {
        return {};
    }
    const auto day = digits(text, 2);
    if (!day) {
        return {};
    }
    const std::chrono::year_month_day date(std::chrono::year(*year),
                                           std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day)));
    if (!date.ok()) {
        return {};
    }
    return 86400.0 * static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
}

// A name without capitals, with "-" between its words.
std::string plain_name(const std::string& name) {
    std::string plain = lower_text(name);
    std::ranges::replace_if(
        plain, [](char c) { return c == '_' || c == ' '; }, '-');
    return plain;
}

// Signs that table programs put into numbers: a minus of its own, blanks that no line breaks at.
std::string plain_number(std::string text) {
    for (const auto& [sign, plain] : {std::pair<std::string_view, std::string_view>{"\u2212", "-"},
                                      {"\u00A0", ""},
                                      {"\u202F", ""},
                                      {"\u2009", ""}}) {
        for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at)) {
            text.replace(at, sign.size(), plain);
        }
    }
    return text;
}

// A usual name, and the others with blanks between them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 26> other_names{{
    {"temperature-c", "temperature температура"},
    {"bias-v", "bias bias-voltage напряжение-смещения"},
    {"gyro", "gyroscope гироскоп прибор"},
    {"file", "recording файл запись"},
    {"least", "min minimum мин минимум не-менее"},
    {"greatest", "max maximum макс максимум не-более"},
    {"gyro-type", "gyrotype тип тип-гироскопа"},
    {"set", "набор"},
    {"date", "дата"},
    {"exchanged", "перестановка перестановка-усилителей"},
    {"operator", "оператор"},
    {"comment", "комментарий примечание"},
    {"channels", "каналы"},
    {"from", "от"},
    {"to", "до"},
    {"band", "полоса"},
    {"filter", "фильтр"},
    {"rate", "частота-дискретизации"},
    {"window", "окно"},
    {"periods", "периоды"},
    {"model", "модель"},
    {"kappa", "каппа"},
    {"offset", "смещения-каналов"},
    {"delay", "задержка"},
    {"tolerance", "допуски"},
    {"parameter", "параметр"},
}};

}  // namespace

std::string usual_column(const std::string& name) {
    std::string plain = plain_name(name);
    for (const std::string unit : {"-°c", "-°с", "-в", "-c", "-с"}) {
        const bool russian = plain.starts_with('\xD0') || plain.starts_with('\xD1');
        if ((russian || unit.size() > 3) && plain.ends_with(unit)) {  // температура_c
            plain.resize(plain.size() - unit.size());
            break;
        }
    }
    if (const std::size_t unit = plain.find_first_of(",(["); unit != std::string::npos) {
        plain.resize(unit);
    }
    while (plain.ends_with('-')) {
        plain.pop_back();
    }
    const auto found = std::ranges::find_if(other_names, [&plain](const auto& names) {
        return (' ' + std::string(names.second) + ' ').find(' ' + plain + ' ') != std::string::npos;
    });
    return found == other_names.end() ? plain : std::string(found->first);
}

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
    std::string text = plain_number(field);
    for (const std::string_view separator : {", ", "; "}) {
        for (std::size_t at = text.find(separator); several && at != std::string::npos;
             at = text.find(separator)) {
            text.erase(at + 1, 1);
        }
    }
    if (several && field.find(';') == std::string::npos) {
        return text;
    }
    std::ranges::replace(text, ',', '.');
    std::ranges::replace(text, ';', ',');
    return several || parse_number(text) ? text : field;
}

std::string usual_date(const std::string& field) {
    constexpr std::size_t day_size = 10;  // of 2026-10-16, too
    std::string date = field.substr(0, day_size);
    std::string time = field.substr(std::min(day_size, field.size()));
    if (time.size() > 2 && (time[0] == ' ' || time[0] == 'T')) {
        // 9:05 of table programs
        time = std::string("T") + (time[2] == ':' ? "0" : "") + time.substr(1);
    }
    std::string_view left = date;
    const bool is_day_first =
        digits(left, 2) && take(left, '.') && digits(left, 2) && take(left, '.') && digits(left, 4);
    if (is_day_first) {
        date = date.substr(6, 4) + "-" + date.substr(3, 2) + "-" + date.substr(0, 2);
    }
    return is_iso_date(date + time) ? date + time : field;
}

std::optional<bool> yes_or_no(const std::string& field) {
    const std::string answer = lower_text(field);
    constexpr std::array<std::string_view, 5> yes{"yes", "да", "true", "истина", "1"};
    constexpr std::array<std::string_view, 5> no{"no", "нет", "false", "ложь", "0"};
    const auto is_one_of = [&answer](const auto& words) {
        return std::ranges::find(words, answer) != words.end();
    };
    return is_one_of(yes)  ? std::optional(true)
           : is_one_of(no) ? std::optional(false)
                           : std::nullopt;
}

bool is_formula(const std::string& field) {
    return field.size() > 1 && std::string_view("=+-@").find(field[0]) != std::string_view::npos &&
           !parse_number(usual_option(field, false)) && !parse_number(field.substr(1));
}

double iso_seconds(const std::string& text) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::string_view left = text;
    const auto date = take_date(left);
    if (!date || left.empty()) {
        return date.value_or(none);
    }
    if (!take(left, 'T') && !take(left, ' ')) {
        return none;
    }
    const auto time = take_time(left, true);
    if (!time) {
        return none;
    }
    if (take(left, 'Z') || left.empty()) {
        return left.empty() ? *date + *time : none;
    }
    const bool west = left.starts_with('-');
    if (!take(left, '+') && !take(left, '-')) {
        return none;
    }
    const auto zone = take_time(left, false);
    return zone && left.empty() ? *date + *time + (west ? *zone : -*zone) : none;
}

bool is_iso_date(const std::string& text) {
    return !std::isnan(iso_seconds(text));
}

}  // namespace vybeg
