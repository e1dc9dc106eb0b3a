#include "core/recording/text/text_header.h"

#include "core/base/plain_text.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/samples/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

constexpr std::size_t longest_line_with_rate = 4096;  // bytes; a longer line is no header
constexpr double agreement = 1e-6;                    // relative, besides what the digits explain

struct Key {
    Meaning meaning = Meaning::other;  // or rate, or step
    std::string unit;                  // in brackets or after a comma
};

Key key_of(std::string_view text) {
    text = trimmed(text);
    while (!text.empty() && (text.back() == ':' || text.back() == '=')) {
        text = trimmed(text.substr(0, text.size() - 1));
    }
    const Channel named = name_and_unit(text);
    for (const Channel& key : {Channel{std::string(text), ""}, named}) {
        const Meaning meaning = meaning_of(key.name, NamedIn::text);
        if (meaning == Meaning::rate || meaning == Meaning::step) {
            return {meaning, key.unit};
        }
    }
    return {};
}

// "33,333" where a point is the decimal sign: thousands, or 33.333.
bool may_hold_thousands(std::string_view number, char group) {
    const auto digits = [](std::string_view text) {
        return std::min(text.find_first_not_of("0123456789"), text.size());
    };
    const std::size_t at = std::min(number.find(group), number.size());
    return at >= 1 && at <= 3 && at < number.size() && number[0] != '0' && digits(number) == at &&
           digits(number.substr(at + 1)) == 3;
}

// "20,000 kHz" is 20 kHz with a decimal comma: who writes thousands of hertz has no thousands left.
bool counts_thousands(const std::string& unit) {
    return hertz_per(unit).value_or(0) > 1;
}

// The number at the start of a text, without the text before a colon ("Analog:2E-06").
struct NumberText {
    std::string number;
    double value = 0;
    std::string unit;  // directly after it
};

// `group`: the sign that may separate thousands, 0 where there is none; such a number is none.
std::optional<NumberText> number_at_start(std::string_view text, char group) {
    text = trimmed(text);
    const auto is_number = [](char c) {
        return is_digit(c) || c == '.' || c == ',' || c == '+' || c == '-';
    };
    if (const auto colon = text.find(':'); colon != std::string_view::npos) {
        if (!text.empty() && !is_number(text.front())) {
            text = trimmed(text.substr(colon + 1));
        }
    }
    std::size_t end = 0;
    while (end < text.size() && (is_number(text[end]) ||
                                 ((text[end] == 'e' || text[end] == 'E' || text[end] == 'D') &&
                                  end > 0 && end + 1 < text.size() && is_number(text[end + 1])))) {
        ++end;
    }
    NumberText found;
    found.number = usual_number(text.substr(0, end), false);
    while (!found.number.empty() && (found.number.back() == '.' || found.number.back() == ',')) {
        found.number.pop_back();
    }
    std::string_view unit = trimmed(text.substr(end));
    if (unit.starts_with('(') || unit.starts_with('[')) {
        unit.remove_prefix(1);
    }
    found.unit = unit.substr(0, unit.find_first_of(" \t,;|()[]\""));
    while (found.unit.ends_with('.')) {
        found.unit.pop_back();
    }
    if (found.number.empty() ||
        (!counts_thousands(found.unit) && may_hold_thousands(found.number, group))) {
        return std::nullopt;
    }
    std::ranges::replace(found.number, ',', '.');
    const auto value = parse_field(found.number, false);
    if (!value || !std::isfinite(*value) || !(*value > 0)) {
        return std::nullopt;
    }
    found.value = *value;
    return found;
}

// Relative standard deviation of a number by its digits alone. Whole numbers are exact. A short
// number may have lost its zeros and counts for six digits, unless its places are fixed: 0.000030,
// or a step between samples of no whole rate: 0.000104 s.
double written_relative_sd(std::string_view number, double value, Meaning meaning, double hz) {
    const bool exponent = number.find_first_of("eE") != std::string_view::npos;
    if (!exponent && number.find('.') == std::string_view::npos) {
        return 0;
    }
    const NumberDigits digits = digits_of(number);
    const bool cut = meaning == Meaning::step && digits.significant >= 3 &&
                     std::abs(hz - std::round(hz)) > 1e-9 * hz;
    const bool fixed = cut || (!exponent && (number.back() == '0' || std::abs(value) < 1e-4));
    const double last = std::pow(10.0, -digits.decimals);
    const double sixth = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5);
    return (fixed ? last : std::min(last, sixth)) / std::sqrt(12.0) / std::abs(value);
}

// "Sample rate 33333 Hz", "fs=33.333 kHz": a key and, after a blank or an equals sign, its number
// with its unit.
struct RateLine {
    Key key;
    std::string_view value;
};

std::optional<RateLine> rate_line(std::string_view text) {
    const std::size_t digit = text.find_first_of("0123456789");
    if (digit == 0 || digit == std::string_view::npos ||
        (text[digit - 1] != ' ' && text[digit - 1] != '=')) {
        return std::nullopt;
    }
    RateLine found{key_of(text.substr(0, digit)), text.substr(digit)};
    const auto number = number_at_start(found.value, '\0');
    const std::size_t blank = found.value.find(' ');
    const std::string_view behind =
        blank == std::string_view::npos ? "" : trimmed(found.value.substr(blank));
    const bool is_alone = behind.empty() || (number && behind == number->unit);
    return found.key.meaning != Meaning::other && is_alone ? std::optional(found) : std::nullopt;
}

// The unit of the times by a line that says so ("HUnit,ms", "Time markers scale: ms"); empty where
// no line names one of time.
std::string axis_unit(std::span<const std::string> lines, char delimiter) {
    for (const std::string& line : lines) {
        std::vector<std::string> fields = header_fields(line, delimiter);
        if (const auto colon = line.find(':'); fields.size() != 2 && colon != std::string::npos) {
            fields = {line.substr(0, colon), line.substr(colon + 1)};
        }
        if (fields.size() < 2) {
            continue;
        }
        const std::string unit = to_utf8(trimmed(fields[1]));
        if (meaning_of(fields[0]) == Meaning::axis_unit && seconds_per(unit)) {
            return unit;
        }
    }
    return {};
}

// The rate of each column of the table by the fields and lines above it that name a rate or a step
// ("Sample Interval,2E-06", "# Samplerate: 10 kHz", "Delta_X", "Start,Increment" over their
// values, "dt=0.001"). Empty where there is none, or where two of them disagree by more than their
// digits.
class RateSearch {
public:
    RateSearch(std::span<const std::string> lines, const TextFormat& format)
        : lines_(lines),
          delimiter_(format.delimiter),
          columns_(static_cast<std::size_t>(format.columns)),
          group_(format.decimal_comma ? '.' : ','),
          axis_unit_(axis_unit(lines, format.delimiter)) {}

    std::vector<SampleRate> run() {
        for (std::size_t i = 0; i < lines_.size() && agree_; ++i) {
            if (lines_[i].size() <= longest_line_with_rate) {
                in_fields(i);
                in_words(i);
            }
        }
        // The samples follow each other more slowly than an input from which some are left out.
        return agree_ && !(of_input_ && decimated_) ? found_ : std::vector<SampleRate>{};
    }

private:
    // Keys that are whole fields, with their values in the fields after them or in the line below.
    void in_fields(std::size_t line) {
        const std::vector<std::string> fields = header_fields(lines_[line], delimiter_);
        for (std::size_t i = 0; i < fields.size(); ++i) {
            const Key key = key_of(fields[i]);
            if (key.meaning == Meaning::other) {
                continue;
            }
            std::vector<SampleRate> rates(columns_);
            bool any = false;
            for (std::size_t j = i + 1; j < fields.size(); ++j) {
                if (!fields[j].empty() && !number_at_start(fields[j], group(key))) {
                    break;
                }
                const bool has_unit =
                    j + 1 < fields.size() && rate_in_hz(key.meaning, 1, fields[j + 1]);
                if (const auto rate = rate_of(key, fields[j], has_unit ? fields[j + 1] : "")) {
                    rates[std::min(j, columns_ - 1)] = *rate;
                    any = true;
                }
            }
            if (any) {
                add(std::move(rates));
            } else if (line + 1 < lines_.size()) {
                const std::vector<std::string> below = header_fields(lines_[line + 1], delimiter_);
                add_value(key, i < below.size() ? below[i] : "");
            }
        }
    }

    // "key: value" and "key = value" within a line.
    void in_words(std::size_t line) {
        const std::string text = to_utf8(without_comment_mark(lines_[line]));
        if (const auto rate = rate_line(text)) {
            add_value(rate->key, rate->value);
        }
        for (std::size_t at = text.find_first_of(":="); at != std::string::npos;
             at = text.find_first_of(":=", at + 1)) {
            const std::string_view before = std::string_view(text).substr(0, at);
            Key key = key_of(behind_last(before, {"\t", ";", "|", "  ", "\""}));
            if (key.meaning == Meaning::other) {
                key = key_of(behind_last(before, {"\t", ";", "|", "  ", "\"", ",", ". "}));
            }
            std::string_view value = std::string_view(text).substr(at + 1);
            decimated_ =
                decimated_ || (normal_name(before) == "decimation" && trimmed(value) != "1");
            of_input_ = of_input_ || normal_name(before).starts_with("inputrate");
            if (key.meaning == Meaning::other) {
                continue;
            }
            value.remove_prefix(std::min(value.find_first_not_of(" \t,;|\""), value.size()));
            add_value(key, value);
        }
    }

    // The rate given by a text after its key, or below it.
    std::optional<SampleRate> rate_of(const Key& key, std::string_view text,
                                      const std::string& unit_behind) const {
        const auto number = number_at_start(text, group(key));
        if (!number) {
            return std::nullopt;
        }
        std::string unit;
        for (const std::string& each :
             {number->unit, key.unit, unit_behind,
              key.meaning == Meaning::step ? axis_unit_ : std::string()}) {
            unit = unit.empty() ? each : unit;
        }
        const auto hz = rate_in_hz(key.meaning, number->value, unit);
        return hz ? std::optional(SampleRate{
                        *hz, RateOrigin::file,
                        written_relative_sd(number->number, number->value, key.meaning, *hz)})
                  : std::nullopt;
    }

    void add_value(const Key& key, std::string_view value) {
        if (const auto rate = rate_of(key, value, "")) {
            add(std::vector<SampleRate>(columns_, *rate));
        }
    }

    // Steps are small: "1.333 ms" holds no thousands.
    char group(const Key& key) const {
        return key.meaning == Meaning::rate && !counts_thousands(key.unit) ? group_ : '\0';
    }

    static std::string_view behind_last(std::string_view text,
                                        std::initializer_list<std::string_view> separators) {
        std::size_t begin = 0;
        for (const std::string_view separator : separators) {
            const std::size_t at = text.rfind(separator);
            begin = at == std::string_view::npos ? begin : std::max(begin, at + separator.size());
        }
        return text.substr(begin);
    }

    // Takes what a line says of the columns; the rest of them have the rate of the first that has
    // one.
    void add(std::vector<SampleRate> rates) {
        const auto first = std::ranges::find_if(rates, [](const auto& r) { return r.hz > 0; });
        const SampleRate rest = *first;
        for (SampleRate& rate : rates) {
            rate = rate.hz > 0 ? rate : rest;
        }
        if (found_.empty()) {
            found_ = std::move(rates);
            return;
        }
        for (std::size_t i = 0; i < columns_; ++i) {
            SampleRate& known = found_[i];
            const double allowed = agreement + 2 * (known.relative_sd + rates[i].relative_sd);
            agree_ = agree_ && std::abs(known.hz / rates[i].hz - 1) <= allowed;
            known = rates[i].relative_sd < known.relative_sd ? rates[i] : known;
        }
    }

    std::span<const std::string> lines_;
    char delimiter_;
    std::size_t columns_;
    char group_;
    std::string axis_unit_;
    std::vector<SampleRate> found_;
    bool agree_ = true;
    bool of_input_ = false;
    bool decimated_ = false;
};

// Whether a line says a rate or a step and nothing else: "Sample rate 33333 Hz".
bool is_rate_line(std::string_view line) {
    return rate_line(to_utf8(without_comment_mark(line))).has_value();
}

// Whether a text is the name of a rate or of a step: "Sample Rate (kHz)", "XInc:", "dt".
bool is_rate_key(std::string_view text) {
    return key_of(text).meaning != Meaning::other;
}

bool is_unit(std::string_view raw) {
    const std::string field = to_utf8(raw);
    const std::string_view bare = without_brackets(field);
    return bare.size() < field.size() || field.empty() || is_unit_below_name(bare);
}

bool is_unit_line(std::span<const std::string> fields) {
    return std::all_of(fields.begin(), fields.end(), is_unit) &&
           std::any_of(fields.begin(), fields.end(), [](const auto& f) { return !f.empty(); });
}

// "Sequence,Volt,Volt" and "Time,Volt,Volt": units but for the first column.
bool is_unit_line_behind_axis(std::span<const std::string> fields) {
    return fields.size() > 1 && !fields[0].empty() &&
           (is_time_name(lower_text(fields[0])) || meaning_of(fields[0]) == Meaning::counter) &&
           is_unit_line(fields.subspan(1)) &&
           std::ranges::none_of(fields.subspan(1), [](const auto& f) { return f.empty(); });
}

// "CH1:V": the text after the channel's name. A name keeps it.
std::string_view behind_colon(std::string_view field) {
    const auto colon = field.rfind(':');
    return trimmed(colon == std::string_view::npos ? field : field.substr(colon + 1));
}

// A line that is drawn between the names and the numbers.
bool is_rule(std::string_view line) {
    return line.find_first_not_of("-=_*+|~ \t") == std::string_view::npos;
}

// A field that can be nothing else than a name with its unit, or that of the time.
bool is_clear_name(const std::string& field) {
    const Channel named = name_and_unit(field);
    return is_time_name(named.name) || (!named.name.empty() && is_any_unit(named.unit));
}

// "C(MV)" among capitals alone is in millivolts.
Channel column_named(const std::string& field, std::string_view line) {
    Channel column = name_and_unit(field);
    const bool capitals = std::ranges::none_of(line, [](char c) { return c >= 'a' && c <= 'z'; });
    column.unit = capitals && column.unit == "MV" ? "mV" : column.unit;
    return column;
}

bool has_equals_sign(const std::string& field) {
    return field.find('=') != std::string::npos;
}

// The lines above a table, and the names and units of columns in them.
class HeaderLines {
public:
    HeaderLines(const LinesAbove& above, TextFormat& format) : above_(above), format_(format) {
        format.headings.resize(above.longest);
    }

    void run() {
        find_last_lines();
        for (std::size_t i = 0; i < above_.lines.size(); ++i) {
            take_labelled(i);
        }
        const auto fill = [](std::string& text, std::size_t i, const auto& from) {
            text = text.empty() && i < from.size() ? to_utf8(from[i]) : text;
        };
        for (std::size_t i = 0; i < format_.headings.size(); ++i) {
            fill(format_.headings[i].name, i, names_);
            fill(format_.headings[i].unit, i, units_);
            fill(format_.headings[i].unit, i, labelled_);
        }
    }

private:
    // The fields of a line that has one for each column; nothing where it has not. A field
    // after the last column is a remark, or no name, or the name of a column without numbers.
    std::optional<std::vector<std::string>> row_of_names(const std::string& line,
                                                         char delimiter) const {
        std::vector<std::string> fields = name_fields(line, delimiter);
        const std::size_t columns = format_.headings.size();
        const bool may_lack_first =
            above_.first_unnamed && (delimiter != ',' || trimmed(line).starts_with('"'));
        const auto is_time = [this](const std::string& field) {
            return above_.first_is_time && is_time_name(name_and_unit(field).name);
        };
        if (may_lack_first && fields.size() + 1 == above_.named &&
            std::ranges::none_of(fields, is_number) && std::ranges::none_of(fields, is_time)) {
            fields.insert(fields.begin(), "");
        }
        const auto is_extra = [](const std::string& field) {
            const Meaning meaning = meaning_of(field);
            return field.empty() || meaning == Meaning::remark || meaning == Meaning::start ||
                   is_rate_key(field) || has_equals_sign(field) ||
                   parse_field(field, false).has_value();
        };
        const auto behind =
            fields.begin() + static_cast<std::ptrdiff_t>(std::min(columns, fields.size()));
        if (fields.size() < above_.named ||
            (!std::all_of(behind, fields.end(), is_extra) &&
             std::count_if(fields.begin(), behind, is_clear_name) < 2)) {
            return std::nullopt;
        }
        fields.resize(std::min(fields.size(), above_.used));
        return fields;
    }

    // Whether a line says one thing of something, or of each channel, and names no columns.
    bool is_setting(const std::string& line) const {
        const std::vector<std::string> fields = name_fields(line, format_.delimiter);
        if (is_rate_line(line) || fields.empty() || fields[0].ends_with(':') ||
            is_rate_key(fields[0]) || is_label(fields) ||
            std::all_of(fields.begin(), fields.end(), has_equals_sign)) {
            return true;
        }
        if (fields[0].empty() || is_time_name(fields[0]) ||
            meaning_of(fields[0]) == Meaning::counter) {
            return fields.size() > 1 && std::all_of(fields.begin() + 1, fields.end(), is_clock);
        }
        const auto is_value = [](const std::string& field) {
            return is_clock(field) || is_number(field);
        };
        return is_pairs(fields) || std::all_of(fields.begin() + 1, fields.end(), is_value);
    }

    // "Source,CH1,Source,CH2": a name and a value for each channel, over its two columns.
    static bool is_pairs(const std::vector<std::string>& fields) {
        return fields.size() >= 4 && !fields[0].empty() && fields[0] == fields[2] &&
               !is_clear_name(fields[0]);
    }

    // The fields of a line, but names and their numbers between blanks as one: "Ch  1     Ch  2".
    static std::vector<std::string> name_fields(const std::string& line, char delimiter) {
        std::vector<std::string> fields = header_fields(line, delimiter);
        if (delimiter != ' ' || fields.size() < 4 || fields.size() % 2 != 0) {
            return fields;
        }
        std::vector<std::string> joined;
        for (std::size_t i = 0; i < fields.size(); i += 2) {
            const bool counted = fields[i + 1].find_first_not_of("0123456789") == std::string::npos;
            if (!counted || fields[i] != fields[0] || is_number(fields[i])) {
                return fields;
            }
            joined.push_back(fields[i] + ' ' + fields[i + 1]);
        }
        return joined;
    }

    static bool is_number(const std::string& field) {
        return parse_field(field, false).has_value();
    }

    static bool is_clock(const std::string& field) { return parse_clock(field).has_value(); }

    static bool is_label(const std::vector<std::string>& fields) {
        const Meaning meaning = meaning_of(fields[0]);
        return fields.size() > 2 && (meaning == Meaning::names || meaning == Meaning::units ||
                                     meaning == Meaning::axis_unit);
    }

    void find_last_lines() {
        for (std::size_t i = above_.lines.size(); i-- > above_.names_from;) {
            const std::string& line = above_.lines[i];
            if (is_rule(line)) {
                continue;
            }
            const auto fields = names_in(line);
            if (fields && units_.empty() &&
                (is_unit_line(*fields) || (is_unit_line_behind_axis(*fields) && named_above(i)))) {
                ++format_.header_lines_used;
                for (const std::string& unit : *fields) {
                    units_.emplace_back(without_brackets(unit));
                }
                continue;
            }
            if (fields && row_of_names(line, format_.delimiter) && is_setting(line)) {
                continue;
            }
            if (fields) {
                ++format_.header_lines_used;
                format_.has_remarks = ends_with_remark(line);
                for (std::size_t j = 0; j < fields->size(); ++j) {
                    format_.headings[j] = column_named((*fields)[j], line);
                }
            }
            return;
        }
    }

    // The same where the names have a separator of their own, and a unit each.
    std::optional<std::vector<std::string>> names_in(const std::string& line) const {
        auto fields = row_of_names(line, format_.delimiter);
        for (const char delimiter : {';', ',', '\t'}) {
            if (!fields && delimiter != format_.delimiter) {
                auto other = row_of_names(line, delimiter);
                if (other && other->size() == above_.used &&
                    std::ranges::all_of(*other, is_clear_name)) {
                    fields = std::move(other);
                }
            }
        }
        return fields;
    }

    bool ends_with_remark(const std::string& line) const {
        const std::vector<std::string> fields = header_fields(line, format_.delimiter);
        return std::ssize(fields) > format_.columns && meaning_of(fields.back()) == Meaning::remark;
    }

    bool named_above(std::size_t line) const {
        while (line > 0 && trimmed(above_.lines[line - 1]).empty()) {
            --line;
        }
        return line > 0 && row_of_names(above_.lines[line - 1], format_.delimiter);
    }

    void take_labelled(std::size_t line) {
        const std::vector<std::string> fields =
            header_fields(above_.lines[line], format_.delimiter);
        if (fields.empty()) {
            return;
        }
        const Meaning meaning = meaning_of(fields[0]);
        if (const auto colon = above_.lines[line].find(':'); colon != std::string::npos) {
            const std::string unit = to_utf8(trimmed(above_.lines[line].substr(colon + 1)));
            if (meaning_of(above_.lines[line].substr(0, colon)) == Meaning::units &&
                is_known_unit(unit)) {
                labelled_.assign(static_cast<std::size_t>(format_.columns), unit);
                labelled_[0] = above_.first_unnamed ? "" : unit;
                return;
            }
        }
        std::vector<std::string>* values = meaning == Meaning::names   ? &names_
                                           : meaning == Meaning::units ? &labelled_
                                                                       : nullptr;
        if (!values || !values->empty()) {
            return;
        }
        std::vector<std::string> found;
        if (fields.size() == 1 && line + 1 < above_.lines.size()) {
            found = row_of_names(above_.lines[line + 1], format_.delimiter).value_or(found);
            format_.header_lines_used += found.empty() ? 0 : 1;
        } else if (is_pairs(fields)) {
            for (std::size_t i = 0; i + 1 < fields.size(); i += 2) {
                found.insert(found.end(), {fields[i + 1], std::string()});
            }
        } else if (fields.size() > 2) {
            found = fields;
            found[0].clear();
        }
        if (found.empty()) {
            return;
        }
        ++format_.header_lines_used;
        for (std::string& value : found) {
            value = to_utf8(values == &labelled_ ? behind_colon(value) : trimmed(value));
        }
        *values = std::move(found);
    }

    const LinesAbove& above_;
    TextFormat& format_;
    std::vector<std::string> units_;
    std::vector<std::string> names_;     // of lines that say so
    std::vector<std::string> labelled_;  // units, likewise
};

}  // namespace

void read_header(const LinesAbove& above, TextFormat& format) {
    HeaderLines(above, format).run();
    Channel& first = format.headings[0];
    if (above.first_unnamed && first.name.empty() && first.unit.empty()) {
        first.unit = axis_unit(above.lines, format.delimiter);
    }
    format.rates = RateSearch(above.lines, format).run();
}

}  // namespace vybeg
