#include "core/recording/text/text_format.h"

#include "core/base/translatable.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_clock.h"
#include "core/recording/text/text_columns.h"
#include "core/recording/text/text_header.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>

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

// What the fields of a line are.
struct FieldCounts {
    int numbers = 0;  // with times of day
    int clocks = 0;
    int words = 0;
};

bool is_time_of_day(std::string_view field) {
    return parse_clock(field).has_value();
}

FieldCounts count_fields(const std::vector<std::string_view>& fields, const Dialect& dialect) {
    FieldCounts counts;
    for (const std::string_view field : fields) {
        if (parse_field(field, dialect.decimal_comma)) {
            counts.numbers += field.empty() ? 0 : 1;
        } else if (is_time_of_day(field)) {
            ++counts.numbers;
            ++counts.clocks;
        } else {
            ++counts.words;
        }
    }
    return counts;
}

// Columns of a table, and those of them in which no row has a number but some have words: a state,
// a comment.
struct Shape {
    int columns = 0;
    std::vector<bool> words;  // by column; empty: none

    bool has_words(std::size_t column) const { return column < words.size() && words[column]; }
};

bool takes_part(std::string_view line, const Dialect& dialect,
                std::vector<std::string_view>& fields) {
    if (trimmed(line).empty() || is_comment(line, dialect.delimiter)) {
        return false;
    }
    split_fields(line, dialect.delimiter, fields);
    return true;
}

// Columns of a row of numbers, 0 where the line is anything else.
int columns_of(std::string_view line, const Dialect& dialect,
               std::vector<std::string_view>& fields) {
    if (!takes_part(line, dialect, fields)) {
        return 0;
    }
    const FieldCounts counts = count_fields(fields, dialect);
    return counts.words == 0 && counts.numbers > counts.clocks ? static_cast<int>(fields.size())
                                                               : 0;
}

// Whether a line is a row of a table: numbers, but for its columns of words, and words behind the
// last column.
bool is_row(std::string_view line, const Dialect& dialect, const Shape& shape,
            std::vector<std::string_view>& fields) {
    const auto columns = static_cast<std::size_t>(shape.columns);
    if (!takes_part(line, dialect, fields) || fields.size() < columns) {
        return false;
    }
    bool any = false;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const bool number = parse_field(fields[k], dialect.decimal_comma).has_value();
        any = any || (number && !fields[k].empty());
        const bool fits = k < columns ? number || shape.has_words(k) || is_time_of_day(fields[k])
                                      : !number || fields[k].empty();
        if (!fits) {
            return false;
        }
    }
    return any;
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

enum class Words { anywhere, behind_numbers };

// The shape of the rows of so many columns. Words before numbers may also be the key of a line
// above a table whose first column is empty.
Shape shape_of(std::span<const std::string> lines, const Dialect& dialect, int columns,
               Words allowed) {
    Shape shape{columns, {}};
    const auto count = static_cast<std::size_t>(columns);
    std::vector<bool> words(count);
    std::vector<bool> numbers(count);
    std::vector<std::string_view> fields;
    for (const std::string& line : lines) {
        if (!takes_part(line, dialect, fields) || fields.size() != count ||
            count_fields(fields, dialect).numbers < 2) {
            continue;
        }
        for (std::size_t k = 0; k < count; ++k) {
            const bool number =
                parse_field(fields[k], dialect.decimal_comma) || is_time_of_day(fields[k]);
            numbers[k] = numbers[k] || (number && !fields[k].empty());
            words[k] = words[k] || !number;
        }
    }
    bool behind = true;
    for (std::size_t k = count; k-- > 0;) {
        behind = behind && !numbers[k];
        words[k] = words[k] && !numbers[k] && (behind || allowed == Words::anywhere);
    }
    if (std::ranges::count(numbers, true) >= 2 && std::ranges::count(words, true) > 0) {
        shape.words = std::move(words);
    }
    return shape;
}

// The shape in which most lines are rows that hold words, and how many numbers stand in them.
std::pair<Shape, std::ptrdiff_t> shape_with_words(std::span<const std::string> lines,
                                                  const Dialect& dialect) {
    std::map<int, int> counts;
    std::vector<std::string_view> fields;
    for (const std::string& line : lines) {
        if (takes_part(line, dialect, fields) && count_fields(fields, dialect).numbers >= 2) {
            ++counts[static_cast<int>(fields.size())];
        }
    }
    std::pair<Shape, std::ptrdiff_t> best;
    for (const auto& [columns, count] : counts) {
        const Shape shape = shape_of(lines, dialect, columns, Words::anywhere);
        const auto rows = std::ranges::count_if(
            lines, [&](const std::string& line) { return is_row(line, dialect, shape, fields); });
        const std::ptrdiff_t numbers = rows * std::ranges::count(shape.words, false);
        if (numbers > best.second) {
            best = {shape, numbers};
        }
    }
    return best;
}

// The first row of the table. Values below a line like "dt:" are none.
std::size_t first_row(std::span<const std::string> lines, const Dialect& dialect,
                      const Shape& shape) {
    constexpr std::size_t values_of_a_title = 3;  // lines, at most
    std::vector<std::string_view> fields;
    std::size_t row = 0;
    for (std::size_t i = 0, rows = 0; i < lines.size(); ++i) {
        if (is_row(lines[i], dialect, shape, fields)) {
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
int used_columns(std::span<const std::string> rows, const Dialect& dialect, const Shape& shape) {
    std::vector<std::string_view> fields;
    std::size_t used = 0;
    for (const std::string& row : rows) {
        if (!is_row(row, dialect, shape, fields)) {
            continue;
        }
        fields.resize(static_cast<std::size_t>(shape.columns));
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
    const auto is_possible = [&choice](const Dialect& candidate) {
        return choice.delimiter.value_or(candidate.delimiter) == candidate.delimiter &&
               choice.decimal_comma.value_or(candidate.decimal_comma) == candidate.decimal_comma;
    };
    Score best;
    Dialect dialect{};
    for (const Dialect& candidate : dialects) {
        const Score found = is_possible(candidate) ? score(body, candidate) : Score{};
        if (found.rows > best.rows) {
            best = found;
            dialect = candidate;
        }
    }
    Shape shape = shape_of(body, dialect, best.columns, Words::behind_numbers);
    std::ptrdiff_t most = 0;
    for (const Dialect& candidate : dialects) {
        if (best.rows == 0 && is_possible(candidate)) {
            auto [found, numbers] = shape_with_words(body, candidate);
            if (numbers > most) {
                most = numbers;
                shape = std::move(found);
                dialect = candidate;
            }
        }
    }
    if (best.rows == 0 && most == 0) {
        return std::nullopt;
    }
    TextFormat format;
    format.delimiter = dialect.delimiter;
    format.decimal_comma = dialect.decimal_comma;
    format.columns = shape.columns;
    std::vector<std::string_view> fields;
    // Lines that were said to be skipped are, and no more: a wrong first row is then an error.
    const auto skipped = choice.lines_to_skip ? said : first_row(body, dialect, shape);
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
                                           .used = used_columns(rows, dialect, shape)});
    format.header_lines_used = header.lines_used;
    format.has_remarks =
        header.has_remarks || std::ranges::any_of(rows, [&](const std::string& line) {
            return is_row(line, dialect, shape, fields) && std::ssize(fields) > format.columns &&
                   !fields.back().empty();
        });
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
