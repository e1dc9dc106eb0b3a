#include "core/recording/text_header.h"

#include "core/recording/text_encoding.h"
#include "core/recording/text_fields.h"

#include <algorithm>
#include <array>
#include <utility>

namespace vybeg {
namespace {

struct TimeUnit {
    std::string_view name;
    double seconds;
};
constexpr std::array<TimeUnit, 21> time_units = {{{"s", 1},
                                                  {"sec", 1},
                                                  {"secs", 1},
                                                  {"second", 1},
                                                  {"seconds", 1},
                                                  {"с", 1},
                                                  {"сек", 1},
                                                  {"секунды", 1},
                                                  {"ms", 1e-3},
                                                  {"msec", 1e-3},
                                                  {"millisecond", 1e-3},
                                                  {"milliseconds", 1e-3},
                                                  {"мс", 1e-3},
                                                  {"us", 1e-6},
                                                  {"usec", 1e-6},
                                                  {"µs", 1e-6},  // U+00B5, the micro sign
                                                  {"μs", 1e-6},  // U+03BC, the Greek letter
                                                  {"microseconds", 1e-6},
                                                  {"мкс", 1e-6},
                                                  {"ns", 1e-9},
                                                  {"нс", 1e-9}}};

constexpr std::array<std::string_view, 15> time_names = {
    "t",       "time",   "times",   "timestamp", "elapsed", "sec", "secs",   "second",
    "seconds", "x-axis", "x_value", "т",         "время",   "сек", "секунды"};

constexpr std::array<std::string_view, 15> counter_names = {
    "",      "#",      "n",       "i",     "k",   "no",    "no.",  "№",
    "index", "sample", "samples", "frame", "row", "count", "номер"};

constexpr std::array<std::string_view, 13> other_units = {
    "v", "mv", "uv", "в", "мв", "мкв", "volt", "volts", "a", "ma", "counts", "lsb", "g"};

// Lower case of ASCII and of the Cyrillic letters А to Я.
std::string lower(std::string_view text) {
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

// A field with the bracket of its unit is one field also where blanks separate: "S_C [V]".
std::vector<std::string> header_fields(std::string_view line, char delimiter) {
    std::vector<std::string_view> parts;
    split_fields(is_comment(line, delimiter) ? without_comment_mark(line) : line, delimiter, parts);
    std::vector<std::string> fields;
    for (const std::string_view part : parts) {
        if (delimiter == ' ' && !fields.empty() &&
            (part.starts_with('[') || part.starts_with('('))) {
            fields.back() += " " + std::string(part);
        } else {
            fields.emplace_back(part);
        }
    }
    return fields;
}

std::string_view without_brackets(std::string_view text) {
    const bool bracketed = text.size() >= 2 && ((text.front() == '[' && text.back() == ']') ||
                                                (text.front() == '(' && text.back() == ')'));
    return bracketed ? trimmed(text.substr(1, text.size() - 2)) : text;
}

bool is_unit(std::string_view field) {
    const std::string_view bare = without_brackets(field);
    const std::string name = lower(bare);
    return bare.size() < field.size() || field.empty() || seconds_per(bare) ||
           std::find(other_units.begin(), other_units.end(), name) != other_units.end();
}

bool is_unit_line(const std::vector<std::string>& fields) {
    return std::all_of(fields.begin(), fields.end(), is_unit) &&
           std::any_of(fields.begin(), fields.end(), [](const auto& f) { return !f.empty(); });
}

}  // namespace

Channel name_and_unit(std::string_view field) {
    const std::string text = to_utf8(trimmed(field));
    const std::string_view whole = text;
    const auto result = [](std::string_view name, std::string_view unit) {
        return Channel{std::string(trimmed(name)), std::string(trimmed(unit))};
    };
    for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
        const auto at = whole.rfind(open);
        if (at != std::string_view::npos && at > 0 && whole.back() == close) {
            return result(whole.substr(0, at), whole.substr(at + 1, whole.size() - at - 2));
        }
    }
    const auto comma = whole.rfind(", ");
    if (comma != std::string_view::npos && comma > 0) {
        return result(whole.substr(0, comma), whole.substr(comma + 2));
    }
    return {text, ""};
}

bool is_time_name(std::string_view name) {
    if (name == "T" || name == "Т") {
        return false;  // a temperature, as likely as not
    }
    const std::string small = lower(name);
    const std::string_view stem = std::string_view(small).substr(0, small.rfind('_'));
    const auto known = [](std::string_view text) {
        return std::find(time_names.begin(), time_names.end(), text) != time_names.end();
    };
    return known(small) || (stem.size() + 1 < small.size() && known(stem) &&
                            seconds_per(small.substr(stem.size() + 1)));
}

bool is_counter_name(std::string_view name) {
    const std::string small = lower(name);
    return std::find(counter_names.begin(), counter_names.end(), small) != counter_names.end();
}

std::optional<double> seconds_per(std::string_view unit) {
    const std::string small = lower(unit);
    const auto found = std::find_if(time_units.begin(), time_units.end(),
                                    [&](const TimeUnit& known) { return known.name == small; });
    return found == time_units.end() ? std::nullopt : std::optional(found->seconds);
}

std::string time_unit(const Channel& column) {
    if (seconds_per(column.unit)) {
        return column.unit;
    }
    // The unit is the end of the name, or all of it: "t_ms", "sec".
    const std::string_view name = column.name;
    const auto cut = name.rfind('_');
    const std::string_view ending = cut == std::string_view::npos ? name : name.substr(cut + 1);
    return seconds_per(ending) ? std::string(ending) : "";
}

TextHeader read_header(std::span<const std::string> lines, char delimiter, int columns) {
    TextHeader header;
    header.columns.resize(static_cast<std::size_t>(columns));
    std::vector<std::string> units;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        if (trimmed(*line).empty()) {
            continue;
        }
        const std::vector<std::string> fields = header_fields(*line, delimiter);
        if (static_cast<int>(fields.size()) != columns) {
            break;
        }
        ++header.lines_used;
        if (units.empty() && is_unit_line(fields)) {
            units = fields;
            continue;
        }
        for (std::size_t i = 0; i < fields.size(); ++i) {
            header.columns[i] = name_and_unit(fields[i]);
        }
        break;
    }
    for (std::size_t i = 0; i < units.size(); ++i) {
        Channel& column = header.columns[i];
        if (column.unit.empty()) {
            column.unit = to_utf8(without_brackets(units[i]));
        }
    }
    return header;
}

}  // namespace vybeg
