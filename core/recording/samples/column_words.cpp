#include "core/recording/samples/column_words.h"

#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/samples/unit_ratio.h"

#include <algorithm>
#include <array>
#include <utility>

namespace vybeg {
namespace {

struct TimeWord {
    std::string_view text;
    double seconds;
};
constexpr std::array<TimeWord, 13> second_words = {{{"s", 1},
                                                    {"sec", 1},
                                                    {"secs", 1},
                                                    {"second", 1},
                                                    {"seconds", 1},
                                                    {"sek", 1},
                                                    {"sekunde", 1},
                                                    {"sekunden", 1},
                                                    {"с", 1},
                                                    {"сек", 1},
                                                    {"секунд", 1},
                                                    {"секунда", 1},
                                                    {"секунды", 1}}};
constexpr std::array<TimeWord, 13> second_prefixes = {{{"milli", 1e-3},
                                                       {"micro", 1e-6},
                                                       {"nano", 1e-9},
                                                       {"милли", 1e-3},
                                                       {"микро", 1e-6},
                                                       {"m", 1e-3},
                                                       {"u", 1e-6},
                                                       {"µ", 1e-6},  // U+00B5, the micro sign
                                                       {"μ", 1e-6},  // U+03BC, the Greek letter
                                                       {"n", 1e-9},
                                                       {"p", 1e-12},
                                                       {"k", 1e3},
                                                       {"н", 1e-9}}};
constexpr std::array<TimeWord, 2> cyrillic_prefixes = {{{"мк", 1e-6}, {"м", 1e-3}}};
constexpr std::array<TimeWord, 22> longer_words = {
    {{"min", 60},    {"mins", 60},   {"minute", 60},  {"minutes", 60},   {"minuten", 60},
     {"мин", 60},    {"минут", 60},  {"минуты", 60},  {"h", 3600},       {"hr", 3600},
     {"hrs", 3600},  {"hour", 3600}, {"hours", 3600}, {"stunden", 3600}, {"ч", 3600},
     {"час", 3600},  {"часы", 3600}, {"day", 86400},  {"days", 86400},   {"tage", 86400},
     {"дни", 86400}, {"сут", 86400}}};

template <std::size_t count>
std::optional<double> seconds_of(const std::array<TimeWord, count>& words, std::string_view text) {
    const auto found = std::ranges::find(words, text, &TimeWord::text);
    return found == words.end() ? std::nullopt : std::optional(found->seconds);
}

constexpr std::array<std::string_view, 21> time_names = {
    "t",         "time",      "times",    "timestamp",    "elapsed",
    "sec",       "secs",      "second",   "seconds",      "x-axis",
    "x_value",   "т",         "время",    "сек",          "секунды",
    "zeit",      "date/time", "datetime", "elapsed time", "relative time",
    "time stamp"};

constexpr std::array<std::string_view, 3> time_beginnings = {"time", "zeit", "время"};

constexpr std::array<std::string_view, 19> counter_names = {
    "",      "#",        "n",       "i",     "k",   "no",    "no.",   "№",
    "index", "sample",   "samples", "frame", "row", "count", "номер", "sample number",
    "nr",    "sequence", "point"};

constexpr std::array<std::string_view, 9> remark_names = {"comment",   "comments",    "event",
                                                          "events",    "marker",      "notes",
                                                          "kommentar", "комментарий", "flag"};

template <std::size_t count>
bool among(const std::array<std::string_view, count>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::string lower_text(std::string_view text) {
    std::string result(text);
    for (std::size_t i = 0; i < result.size(); ++i) {
        char& c = result[i];
        if (c >= 'A' && c <= 'Z') {
            c = static_cast<char>(c - 'A' + 'a');
        } else if (c == '\xD0' && i + 1 < result.size()) {
            // А..П are D0 90..9F with а..п at D0 B0..BF; Р..Я are D0 A0..AF with р..я at D1 80..8F.
            const auto next = static_cast<unsigned char>(result[i + 1]);
            if (next >= 0x90 && next <= 0x9F) {
                result[i + 1] = static_cast<char>(next + 0x20);
            } else if (next >= 0xA0 && next <= 0xAF) {
                c = '\xD1';
                result[i + 1] = static_cast<char>(next - 0x20);
            }
        }
    }
    return result;
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

namespace {

// Names of SPICE programs are no names with a unit: V(c) is the voltage of node c.
std::optional<Channel> node_quantity(std::string_view name, std::string_view inside) {
    if (name != "V" && name != "I") {
        return std::nullopt;
    }
    const char* const unit = name == "V" ? "V" : "A";
    if (unit_ratio(inside, unit)) {
        return std::nullopt;
    }
    return Channel{std::string(name) + "(" + std::string(inside) + ")", unit};
}

bool is_number(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool is_any_unit(std::string_view text) {
    return is_known_unit(text) || seconds_per(text).has_value();
}

}  // namespace

Channel name_and_unit(std::string_view field) {
    const std::string text = to_utf8(trimmed(field));
    const std::string_view whole = text;
    const auto result = [](std::string_view name, std::string_view unit) {
        return Channel{std::string(trimmed(name)), std::string(trimmed(unit))};
    };
    for (const auto& [open, close] :
         {std::pair{'[', ']'}, std::pair{'(', ')'}, std::pair{'{', '}'}}) {
        const auto at = whole.rfind(open);
        const auto end = whole.rfind(close);
        if (at == std::string_view::npos || at == 0 || end == std::string_view::npos || end < at) {
            continue;
        }
        std::string_view inside = whole.substr(at + 1, end - at - 1);
        inside.remove_prefix(inside.starts_with("in ") ? 3 : 0);
        if (end + 1 < whole.size()) {
            // "Time [ms] abs", "C (V) DC"
            if (is_any_unit(inside)) {
                return result(
                    std::string(trimmed(whole.substr(0, at))) + std::string(whole.substr(end + 1)),
                    inside);
            }
            continue;
        }
        if (is_number(inside)) {
            return {text, ""};
        }
        if (const auto node = node_quantity(whole.substr(0, at), inside)) {
            return *node;
        }
        return result(whole.substr(0, at), inside);
    }
    const auto comma = whole.rfind(", ");
    if (comma != std::string_view::npos && comma > 0) {
        return result(whole.substr(0, comma), whole.substr(comma + 2));
    }
    if (whole.starts_with("in ") && is_any_unit(whole.substr(3))) {
        return result("", whole.substr(3));
    }
    for (const std::string_view separator : {" in ", "/"}) {
        const auto at = whole.rfind(separator);
        if (at != std::string_view::npos && at > 0 &&
            is_any_unit(whole.substr(at + separator.size()))) {
            return result(whole.substr(0, at), whole.substr(at + separator.size()));
        }
    }
    // "CH1 mVolt", "C_V", and "mV" alone
    const auto cut = whole.find_last_of(" _");
    const std::string_view last = cut == std::string_view::npos ? whole : whole.substr(cut + 1);
    return {text, is_unit_by_itself(last) ? std::string(last) : ""};
}

bool is_counter_name(std::string_view name) {
    const std::string small = lower_text(name);
    return among(counter_names, small);
}

std::optional<double> seconds_per(std::string_view unit) {
    std::string small = lower_text(unit);
    while (small.ends_with('.')) {
        small.pop_back();
    }
    if (const auto longer = seconds_of(longer_words, small)) {
        return longer;
    }
    if (const auto whole = seconds_of(second_words, small)) {
        return whole;
    }
    const auto behind = [&](const TimeWord& prefix) -> std::optional<double> {
        if (!small.starts_with(prefix.text)) {
            return std::nullopt;
        }
        const auto word =
            seconds_of(second_words, std::string_view(small).substr(prefix.text.size()));
        return word ? std::optional(prefix.seconds * *word) : std::nullopt;
    };
    for (const TimeWord& prefix : cyrillic_prefixes) {
        if (const auto found = behind(prefix)) {
            return found;
        }
    }
    for (const TimeWord& prefix : second_prefixes) {
        if (const auto found = behind(prefix)) {
            return found;
        }
    }
    return std::nullopt;
}

namespace {

// Start of the last word of a name: after a blank, '_' or '-', or as in "TimeMs".
std::size_t last_word(std::string_view name) {
    const auto cut = name.find_last_of(" _-");
    if (cut != std::string_view::npos) {
        return cut + 1;
    }
    const std::string small = lower_text(name);
    for (const std::string_view beginning : time_beginnings) {
        // "times" is a plural.
        if (small.starts_with(beginning) && small.size() > beginning.size() + 1) {
            return beginning.size();
        }
    }
    return 0;
}

}  // namespace

bool is_time_name(std::string_view name) {
    if (name == "T" || name == "Т") {
        return false;  // probably a temperature
    }
    const std::string small = lower_text(name);
    if (among(time_names, small)) {
        return true;
    }
    const std::size_t word = last_word(small);
    const std::string_view stem = std::string_view(small).substr(0, word);
    return word > 0 && seconds_per(std::string_view(small).substr(word)) &&
           among(time_names, stem.substr(0, stem.find_last_not_of(" _-") + 1));
}

std::string time_unit(const Channel& column) {
    if (seconds_per(column.unit)) {
        return column.unit;
    }
    // The unit is the end of the name, or all of it: "t_ms", "sec".
    const std::string_view name = column.name;
    const std::string_view ending = name.substr(last_word(name));
    return seconds_per(ending) ? std::string(ending) : "";
}

bool begins_as_time_name(std::string_view name) {
    const std::string small = lower_text(name);
    return std::ranges::any_of(time_beginnings, [&](std::string_view beginning) {
        return small.starts_with(beginning) && small.size() > beginning.size() &&
               std::string_view(" -(_").find(small[beginning.size()]) != std::string_view::npos;
    });
}

char channel_letter(std::string_view name) {
    constexpr std::array<std::string_view, 4> before{"", "s", "ch", "channel"};
    std::string letters = lower_text(name);
    std::erase_if(letters, [](char c) { return c == '_' || c == ' ' || c == '-'; });
    if (letters.empty() || (letters.back() != 'c' && letters.back() != 'd') ||
        !among(before, std::string_view(letters).substr(0, letters.size() - 1))) {
        return 0;
    }
    return letters.back();
}

bool is_remark_name(std::string_view name) {
    return among(remark_names, lower_text(name));
}

}  // namespace vybeg
