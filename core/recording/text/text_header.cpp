#include "core/recording/text/text_header.h"

#include "core/base/plain_text.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/samples/vocabulary.h"
#include "core/recording/text/text_rate.h"

#include <algorithm>
#include <utility>

namespace vybeg {
namespace {

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

// "CH1:V": what stands behind the channel's name. A name keeps it.
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

// The lines above a table, with what they tell of its columns.
class HeaderLines {
public:
    HeaderLines(const LinesAbove& above, TextFormat& format) : above_(above), format_(format) {
        format.headings.resize(above.rows.longest);
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
    // The fields of a line that has one for each column; nothing where it has not. What stands
    // behind the last column is a remark, or no name, or the name of a column without numbers.
    std::optional<std::vector<std::string>> row_of_names(const std::string& line,
                                                         char delimiter) const {
        std::vector<std::string> fields = name_fields(line, delimiter);
        const std::size_t columns = format_.headings.size();
        const bool may_lack_first =
            above_.first_unnamed && (delimiter != ',' || trimmed(line).starts_with('"'));
        const auto is_time = [this](const std::string& field) {
            return above_.first_is_time && is_time_name(name_and_unit(field).name);
        };
        if (may_lack_first && fields.size() + 1 == above_.rows.named &&
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
        if (fields.size() < above_.rows.named ||
            (!std::all_of(behind, fields.end(), is_extra) &&
             std::count_if(fields.begin(), behind, is_clear_name) < 2)) {
            return std::nullopt;
        }
        fields.resize(std::min(fields.size(), above_.rows.used));
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
                if (other && other->size() == above_.rows.used &&
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
}

}  // namespace vybeg
