#include "core/recording/text_format.h"

#include "core/recording/text_fields.h"
#include "core/recording/text_header.h"

#include <algorithm>
#include <array>
#include <cmath>
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
    const bool numbers = std::all_of(fields.begin(), fields.end(), [&](std::string_view field) {
        return parse_field(field, dialect.decimal_comma).has_value();
    });
    const bool blank =
        std::all_of(fields.begin(), fields.end(), [](std::string_view f) { return f.empty(); });
    return numbers && !blank ? static_cast<int>(fields.size()) : 0;
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

// The numbers of one column, also from rows that are wrong elsewhere; but not from a last line that
// was cut off.
std::vector<double> column_values(std::span<const std::string> rows, const TextFormat& format,
                                  int column) {
    std::vector<double> values;
    std::vector<std::string_view> fields;
    const auto at = static_cast<std::size_t>(column);
    for (const std::string& row : rows) {
        if (is_comment(row, format.delimiter)) {
            continue;
        }
        split_fields(row, format.delimiter, fields);
        const bool whole = static_cast<int>(fields.size()) == format.columns;
        if (fields.size() <= at || (!whole && &row == &rows.back())) {
            continue;
        }
        if (const auto value = parse_field(fields[at], format.decimal_comma)) {
            values.push_back(*value);
        }
    }
    return values;
}

std::vector<double> steps_of(const std::vector<double>& values) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < values.size(); ++i) {
        steps.push_back(values[i] - values[i - 1]);
    }
    return steps;
}

// Rises by steps of which nine in ten, or all but one, lie within a half of the median step: a
// clock with jitter, gaps and perhaps an error that the reader will report, but no vibration.
bool rises_evenly(const std::vector<double>& values) {
    const std::vector<double> steps = steps_of(values);
    if (steps.size() < 2) {
        return false;
    }
    std::vector<double> sorted = steps;
    std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
    const double median = sorted[sorted.size() / 2];
    const auto odd = std::count_if(steps.begin(), steps.end(), [median](double step) {
        return !(step >= 0.5 * median && step <= 1.5 * median);
    });
    const auto count = static_cast<std::ptrdiff_t>(steps.size());
    return median > 0 && odd <= std::max<std::ptrdiff_t>(count / 10, count >= 4 ? 1 : 0);
}

bool is_whole(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(),
                       [](double value) { return value == std::floor(value); });
}

void find_time(std::span<const std::string> rows, const std::vector<Channel>& columns,
               const TextChoice& choice, TextFormat& format) {
    const bool said = choice.time_column.has_value();
    const bool unit_said = choice.time_unit_s.has_value();
    int candidate = said ? *choice.time_column - 1 : -1;
    for (int i = 0; !said && i < format.columns && candidate < 0; ++i) {
        candidate = is_time_name(columns[static_cast<std::size_t>(i)].name) ? i : -1;
    }
    if (candidate != 0 && format.columns >= 3) {
        const std::vector<double> first = column_values(rows, format, 0);
        if (rises_evenly(first)) {
            const bool counts =
                is_whole(first) && time_unit(columns[0]).empty() && (said || !unit_said);
            if (counts && is_counter_name(columns[0].name)) {
                format.counter_column = 0;
            } else if (!counts && candidate < 0 && !said) {
                candidate = 0;
            }
        }
    }
    if (candidate < 0 || candidate >= format.columns) {
        return;
    }
    const std::string unit = time_unit(columns[static_cast<std::size_t>(candidate)]);
    if (!said && !unit_said && unit.empty() && is_whole(column_values(rows, format, candidate))) {
        format.counter_column = candidate;
        return;
    }
    format.time_column = candidate;
    format.time_unit_s = choice.time_unit_s.value_or(seconds_per(unit).value_or(1));
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
    const auto first = std::find_if(body.begin(), body.end(), [&](const std::string& line) {
        return columns_of(line, dialect, fields) == best.columns;
    });
    // Lines that were said to be skipped are, and no more: a wrong first row is then an error.
    const auto skipped =
        choice.lines_to_skip ? said : static_cast<std::size_t>(first - body.begin());
    format.lines_to_skip = static_cast<std::int64_t>(skipped);
    // Numbers that are skipped name no columns.
    const auto above = lines.first(skipped);
    const auto numbers = std::find_if(above.rbegin(), above.rend(), [&](const std::string& line) {
        return columns_of(line, dialect, fields) > 0;
    });
    const auto words = above.last(static_cast<std::size_t>(numbers - above.rbegin()));
    const TextHeader header = read_header(words, format.delimiter, format.columns);
    format.header_lines_used = header.lines_used;
    find_time(lines.subspan(skipped), header.columns, choice, format);
    for (const Channel& column : header.columns) {
        format.names.push_back(column.name);
        format.units.push_back(column.unit);
    }
    return format;
}

std::vector<int> channel_columns(const TextFormat& format) {
    std::vector<int> columns;
    for (int column = 0; column < format.columns; ++column) {
        if (column != format.time_column && column != format.counter_column) {
            columns.push_back(column);
        }
    }
    return columns;
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

std::string format_text(const TextFormat& format) {
    const char* delimiter = format.delimiter == '\t'  ? "tab"
                            : format.delimiter == ';' ? "semicolon"
                            : format.delimiter == ',' ? "comma"
                            : format.delimiter == '|' ? "bar"
                                                      : "blanks";
    return "text, " + std::to_string(format.columns) + " columns, " + delimiter +
           (format.decimal_comma ? ", decimal comma" : "");
}

}  // namespace vybeg
