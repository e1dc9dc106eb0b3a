#include "core/recording/text/text_format.h"

#include "core/base/translatable.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_clock.h"
#include "core/recording/text/text_columns.h"
#include "core/recording/text/text_header.h"

#include <algorithm>
#include <array>
#include <map>

namespace vybeg {
namespace {

struct Dialect {
    char delimiter;
    bool decimal_comma;
};

// In the order of preference: where two explain equally many lines, the first is taken.
constexpr std::array<Dialect, 10> dialects = {{{'\t', false},
                                               {';', false},
                                               {',', false},
                                               {'|', false},
                                               {' ', false},
                                               {'\t', true},
                                               {';', true},
                                               {'|', true},
                                               {' ', true},
                                               {',', true}}};  // between quotes

// Columns of a row of numbers, 0 where the line is anything else.
int columns_of(std::string_view line, const Dialect& dialect,
               std::vector<std::string_view>& fields) {
    if (trimmed(line).empty() || is_comment(line, dialect.delimiter)) {
        return 0;
    }
    split_fields(line, dialect.delimiter, fields);
    std::size_t clocks = 0;
    const bool numbers = std::all_of(fields.begin(), fields.end(), [&](std::string_view field) {
        if (parse_field(field, dialect.decimal_comma)) {
            return true;
        }
        ++clocks;
        return parse_clock(field).has_value();
    });
    const bool blank =
        std::all_of(fields.begin(), fields.end(), [](std::string_view f) { return f.empty(); });
    return numbers && !blank && clocks < fields.size() ? static_cast<int>(fields.size()) : 0;
}

struct Score {
    int columns = 0;
    int rows = 0;
};

// The row length that most lines have, among those of two or more columns.
Score score(std::span<const std::string> lines, const Dialect& dialect) {
    std::map<int, int> rows;
    std::vector<std::string_view> fields;
    for (const std::string& line : lines) {
        ++rows[columns_of(line, dialect, fields)];
    }
    Score best;
    for (const auto& [columns, count] : rows) {
        if (columns >= 2 && count >= best.rows) {
            best = {columns, count};
        }
    }
    return best;
}

// The first row of the table. Values below a line like "dt:" are none.
std::size_t first_row(std::span<const std::string> lines, const Dialect& dialect, int columns) {
    constexpr std::size_t values_of_a_title = 3;  // lines, at most
    std::vector<std::string_view> fields;
    std::size_t row = 0;
    for (std::size_t i = 0, rows = 0; i < lines.size(); ++i) {
        if (columns_of(lines[i], dialect, fields) == columns) {
            row = rows == 0 ? i : row;
            if (++rows > values_of_a_title) {
                break;
            }
        } else if (rows > 0 && trimmed(lines[i]).ends_with(':')) {
            rows = 0;
        }
    }
    return row;
}

// Columns but for those at the end that are empty in all rows.
int used_columns(std::span<const std::string> rows, const Dialect& dialect, int columns) {
    std::vector<std::string_view> fields;
    std::size_t used = 0;
    for (const std::string& row : rows) {
        if (columns_of(row, dialect, fields) != columns) {
            continue;
        }
        while (used < fields.size() &&
               std::any_of(fields.begin() + static_cast<std::ptrdiff_t>(used), fields.end(),
                           [](std::string_view field) { return !field.empty(); })) {
            ++used;
        }
        if (used == fields.size()) {
            break;
        }
    }
    return static_cast<int>(used);
}

}  // namespace

std::optional<TextFormat> guess_text_format(std::span<const std::string> lines,
                                            const TextChoice& choice) {
    const auto said = static_cast<std::size_t>(choice.lines_to_skip.value_or(0));
    const auto body = lines.subspan(std::min(said, lines.size()));
    Score best;
    Dialect dialect{};
    for (const Dialect& candidate : dialects) {
        if (choice.delimiter.value_or(candidate.delimiter) != candidate.delimiter ||
            choice.decimal_comma.value_or(candidate.decimal_comma) != candidate.decimal_comma) {
            continue;
        }
        const Score found = score(body, candidate);
        if (found.rows > best.rows) {
            best = found;
            dialect = candidate;
        }
    }
    if (best.rows == 0) {
        return std::nullopt;
    }
    TextFormat format;
    format.delimiter = dialect.delimiter;
    format.decimal_comma = dialect.decimal_comma;
    format.columns = best.columns;
    std::vector<std::string_view> fields;
    // Lines that were said to be skipped are, and no more: a wrong first row is then an error.
    const auto skipped = choice.lines_to_skip ? said : first_row(body, dialect, best.columns);
    format.lines_to_skip = static_cast<std::int64_t>(skipped);
    // Numbers that are skipped name no columns.
    const auto above = lines.first(skipped);
    const auto numbers = std::find_if(above.rbegin(), above.rend(), [&](const std::string& line) {
        return columns_of(line, dialect, fields) > 0;
    });
    const auto names_from = above.size() - static_cast<std::size_t>(numbers - above.rbegin());
    const auto rows = lines.subspan(skipped);
    const TextHeader header = read_header({.lines = above,
                                           .names_from = names_from,
                                           .delimiter = format.delimiter,
                                           .columns = format.columns,
                                           .used = used_columns(rows, dialect, format.columns)});
    format.header_lines_used = header.lines_used;
    format.has_remarks = header.has_remarks;
    format.rates = header_rates(above, format.delimiter, format.columns, format.decimal_comma);
    if (format.columns <= most_columns) {
        find_columns(rows, header.columns, choice, format);
    }
    for (const Channel& column : header.columns) {
        format.names.push_back(column.name);
        format.units.push_back(column.unit);
    }
    return format;
}

bool has_decimal_commas(std::span<const std::string> lines, const TextFormat& format) {
    constexpr int least_columns = 4;
    if (format.delimiter != ',' || format.decimal_comma || format.columns < least_columns ||
        format.columns % 2 != 0) {
        return false;
    }
    const auto is_digits = [](std::string_view text) {
        return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
    };
    std::vector<std::string_view> fields;
    bool leading_zero = false;
    for (const std::string& line : lines.subspan(static_cast<std::size_t>(format.lines_to_skip))) {
        if (columns_of(line, {',', false}, fields) != format.columns) {
            continue;
        }
        for (std::size_t k = 0; k < fields.size(); k += 2) {
            const std::string_view whole = trimmed(fields[k]);
            const std::string_view decimals = trimmed(fields[k + 1]);
            if (!is_digits(whole.substr(whole.starts_with('-') ? 1 : 0)) || !is_digits(decimals)) {
                return false;
            }
            leading_zero = leading_zero || (decimals.size() > 1 && decimals.front() == '0');
        }
    }
    return leading_zero;
}

std::vector<Channel> channels_of(const TextFormat& format, double scale) {
    std::vector<Channel> channels;
    for (const int column : channel_columns(format)) {
        const auto i = static_cast<std::size_t>(column);
        const std::string number = std::to_string(channels.size() + 1);
        channels.push_back({format.names[i].empty() ? number : format.names[i],
                            scale == 1 ? format.units[i] : std::string{}});
    }
    return channels;
}

RecordingFormat format_of(const TextFormat& format) {
    const char* delimiter = format.delimiter == '\t'  ? VYBEG_MESSAGE("Format", "tab")
                            : format.delimiter == ';' ? VYBEG_MESSAGE("Format", "semicolon")
                            : format.delimiter == ',' ? VYBEG_MESSAGE("Format", "comma")
                            : format.delimiter == '|' ? VYBEG_MESSAGE("Format", "bar")
                                                      : VYBEG_MESSAGE("Format", "blanks");
    RecordingFormat parts{FormatPart::words(VYBEG_MESSAGE("Format", "text")),
                          FormatPart::columns(format.columns), FormatPart::words(delimiter)};
    if (format.decimal_comma) {
        parts.push_back(FormatPart::words(VYBEG_MESSAGE("Format", "decimal comma")));
    }
    return parts;
}

}  // namespace vybeg
