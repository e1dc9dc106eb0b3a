#include "core/recording/samples/column_words.h"

#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/samples/unit_ratio.h"

#include <algorithm>
#include <array>
#include <utility>

namespace vybeg {
namespace {

struct TimeUnit {
    std::string_view name;
    double seconds;
};
constexpr std::array<TimeUnit, 22> time_units = {{{"s", 1},
                                                  {"sec", 1},
                                                  {"secs", 1},
                                                  {"second", 1},
                                                  {"seconds", 1},
                                                  {"с", 1},
                                                  {"сек", 1},
                                                  {"секунд", 1},
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

constexpr std::array<std::string_view, 8> remark_names = {
    "comment", "comments", "event", "events", "marker", "notes", "kommentar", "комментарий"};

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
        if (delimiter == ' ' && !fields.empty() &&
            (part.starts_with('[') || part.starts_with('('))) {
            fields.back() += " " + std::string(part);
        } else {
            fields.emplace_back(part);
        }
    }
    return fields;
}

namespace {

// Names of LTspice and its kin are no names with a unit: V(c) is the voltage of node c.
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
    for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
        const auto at = whole.rfind(open);
        if (at != std::string_view::npos && at > 0 && whole.back() == close) {
            const std::string_view inside = whole.substr(at + 1, whole.size() - at - 2);
            if (is_number(inside)) {
                return {text, ""};
            }
            if (const auto node = node_quantity(whole.substr(0, at), inside)) {
                return *node;
            }
            return result(whole.substr(0, at), whole.substr(at + 1, whole.size() - at - 2));
        }
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
    return {text, ""};
}

bool is_time_name(std::string_view name) {
    if (name == "T" || name == "Т") {
        return false;  // a temperature, as likely as not
    }
    const std::string small = lower_text(name);
    const std::string_view stem = std::string_view(small).substr(0, small.rfind('_'));
    const auto known = [](std::string_view text) {
        return std::find(time_names.begin(), time_names.end(), text) != time_names.end();
    };
    return known(small) || (stem.size() + 1 < small.size() && known(stem) &&
                            seconds_per(small.substr(stem.size() + 1)));
}

bool is_counter_name(std::string_view name) {
    const std::string small = lower_text(name);
    return among(counter_names, small);
}

std::optional<double> seconds_per(std::string_view unit) {
    const std::string small = lower_text(unit);
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

bool begins_as_time_name(std::string_view name) {
    const std::string small = lower_text(name);
    return std::ranges::any_of(time_beginnings, [&](std::string_view beginning) {
        return small.starts_with(beginning) && small.size() > beginning.size() &&
               std::string_view(" -(_").find(small[beginning.size()]) != std::string_view::npos;
    });
}

bool is_remark_name(std::string_view name) {
    return among(remark_names, lower_text(name));
}

}  // namespace vybeg
