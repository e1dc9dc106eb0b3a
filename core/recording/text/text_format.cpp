#include "core/recording/text/text_format.h"

#include "core/base/error.h"
#include "core/base/message_arg.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_header.h"
#include "core/recording/text/text_lines.h"

#include <algorithm>
#include <array>
#include <deque>
#include <iterator>
#include <map>
#include <utility>

namespace vybeg {
namespace {

struct Dialect {
    char delimiter;
    bool decimal_comma;
};

// The columns of a table, from 0, that hold words. A row may end before those at the end, and words
// may follow its last column.
using WordColumns = std::vector<int>;

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

bool is_number(std::string_view field, bool decimal_comma) {
    return parse_field(field, decimal_comma) || parse_clock(field);
}

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

// The columns that hold words in at least as many lines as numbers, among the lines of so many
// fields of which two or more are numbers.
WordColumns find_words(std::span<const std::string> lines, const Dialect& dialect, int columns) {
    struct Count {
        int numbers = 0;
        int words = 0;
    };
    std::vector<Count> counts(static_cast<std::size_t>(columns));
    std::vector<std::string_view> fields;
    std::vector<bool> numbers;
    for (const std::string& line : lines) {
        split_fields(line, dialect.delimiter, fields);
        if (fields.size() != counts.size() || is_comment(line, dialect.delimiter)) {
            continue;
        }
        numbers.clear();
        for (const std::string_view field : fields) {
            numbers.push_back(!field.empty() && is_number(field, dialect.decimal_comma));
        }
        if (std::ranges::count(numbers, true) < 2) {
            continue;
        }
        for (std::size_t i = 0; i < counts.size(); ++i) {
            counts[i].numbers += numbers[i] ? 1 : 0;
            counts[i].words += !numbers[i] && !fields[i].empty() ? 1 : 0;
        }
    }
    WordColumns words;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i].words > 0 && counts[i].words >= counts[i].numbers) {
            words.push_back(static_cast<int>(i));
        }
    }
    return words;
}

// A table of the rows of which a line is one or is none.
struct Rows {
    Dialect dialect{};
    int columns = 0;
    WordColumns words{};
    int count = 0;  // of the lines, those that are rows

    // Columns that hold some.
    int numbers() const { return columns - static_cast<int>(words.size()); }

    bool holds_words(std::size_t column) const {
        return std::ranges::binary_search(words, static_cast<int>(column));
    }

    // Leaves the fields of the line in `fields`.
    bool contain(std::string_view line, std::vector<std::string_view>& fields) const {
        const int found = columns_of(line, dialect, fields);
        if (found > 0 || fields.empty() || trimmed(line).empty() ||
            is_comment(line, dialect.delimiter)) {
            return found == columns || (found > 0 && found < columns && ends_in_words(found)) ||
                   (found == columns - 1 && ends_empty(line));
        }
        const auto wanted = static_cast<std::size_t>(columns);
        if (fields.size() < wanted && !ends_in_words(std::ssize(fields))) {
            return false;
        }
        bool any = false;
        // Words may contain blanks.
        if (fields.size() > wanted && dialect.delimiter == ' ' && !holds_words(wanted - 1)) {
            return false;
        }
        for (std::size_t i = 0; i < fields.size(); ++i) {
            const bool number = is_number(fields[i], dialect.decimal_comma);
            const bool may_be_word = i >= wanted ? !number || fields[i].empty() : holds_words(i);
            if (!number && !may_be_word) {
                return false;
            }
            any = any || (number && !fields[i].empty() && !may_be_word);
        }
        return any;
    }

private:
    // Whether the last field is missing, as split_fields() leaves it out.
    bool ends_empty(std::string_view line) const {
        const auto end = line.find_last_not_of(" \r\n");
        return dialect.delimiter != ' ' && end != std::string_view::npos &&
               line[end] == dialect.delimiter;
    }

    bool ends_in_words(std::ptrdiff_t from) const {
        return from >= 2 && std::ssize(words) >= columns - from &&
               words[words.size() - static_cast<std::size_t>(columns - from)] == from;
    }
};

// The rows of the length that most lines have, among those of two or more columns; and those of
// one.
std::pair<Rows, Rows> rows_of_numbers(std::span<const std::string> lines, const Dialect& dialect) {
    std::map<int, int> rows;
    std::vector<std::string_view> fields;
    for (const std::string& line : lines) {
        ++rows[columns_of(line, dialect, fields)];
    }
    Rows best{dialect};
    for (const auto& [columns, count] : rows) {
        if (columns >= 2 && count >= best.count) {
            best = {dialect, columns, {}, count};
        }
    }
    return {best, {dialect, 1, {}, rows[1]}};
}

// Replaces `best` where words beside the numbers make a better table: the rows that have most
// lines, then those of most numbers.
void take_rows_with_words(std::span<const std::string> lines, const Dialect& dialect, Rows& best) {
    std::map<int, int> lengths;
    std::vector<std::string_view> fields;
    for (const std::string& line : lines) {
        split_fields(line, dialect.delimiter, fields);
        ++lengths[static_cast<int>(fields.size())];
    }
    for (const auto& [columns, count] : lengths) {
        if (columns < 3 || columns > most_columns || count < best.count) {
            continue;
        }
        Rows rows{dialect, columns, find_words(lines, dialect, columns)};
        rows.count = static_cast<int>(std::ranges::count_if(
            lines, [&](const auto& line) { return rows.contain(line, fields); }));
        if (rows.count > 0 && rows.numbers() >= 2 &&
            std::pair(rows.count, rows.numbers()) > std::pair(best.count, best.numbers())) {
            best = std::move(rows);
        }
    }
}

// The first row of the table. Values below a line like "dt:" are none, nor are numbers beside words
// above a line of names.
std::size_t first_row(std::span<const std::string> lines, const Rows& table) {
    constexpr std::size_t values_of_a_title = 3;  // lines, at most
    std::vector<std::string_view> fields;
    std::size_t row = 0;
    for (std::size_t i = 0, rows = 0; i < lines.size(); ++i) {
        if (table.contain(lines[i], fields)) {
            row = rows == 0 ? i : row;
            if (++rows > values_of_a_title) {
                break;
            }
            continue;
        }
        const bool names = !table.words.empty() && !trimmed(lines[i]).empty() &&
                           !is_comment(lines[i], table.dialect.delimiter) && fields.size() > 1 &&
                           std::ranges::none_of(fields, [&](std::string_view field) {
                               return is_number(field, table.dialect.decimal_comma);
                           });
        if (rows > 0 && (names || trimmed(lines[i]).ends_with(':'))) {
            rows = 0;
        }
    }
    return row;
}

// Measures the rows of a table.
void measure(std::span<const std::string> rows, const Rows& table, LinesAbove& above) {
    const auto columns = static_cast<std::size_t>(table.columns);
    std::vector<std::string_view> fields;
    above.longest = columns;
    for (const std::string& row : rows) {
        if (!table.contain(row, fields)) {
            continue;
        }
        above.longest = std::max(above.longest, fields.size());
        for (std::size_t i = above.named; i < fields.size(); ++i) {
            if (!fields[i].empty()) {
                above.used = std::max(above.used, i + 1);
                above.named = i >= columns || table.holds_words(i) ? above.named : i + 1;
            }
        }
    }
}

// The table that most lines are rows of. Words count only where numbers alone explain few of them.
std::optional<Rows> find_rows(std::span<const std::string> lines, const TextChoice& choice) {
    constexpr int much_more = 3;
    constexpr int least_single_rows = 5;
    const auto is_allowed = [&](const Dialect& dialect) {
        return choice.delimiter.value_or(dialect.delimiter) == dialect.delimiter &&
               choice.decimal_comma.value_or(dialect.decimal_comma) == dialect.decimal_comma;
    };
    Rows numbers_alone;
    Rows single;  // one number each, in most lines
    single.count = std::max(least_single_rows, static_cast<int>(lines.size() / 2)) - 1;
    for (const Dialect& dialect : dialects) {
        if (is_allowed(dialect)) {
            auto [several, one] = rows_of_numbers(lines, dialect);
            numbers_alone = several.count > numbers_alone.count ? several : numbers_alone;
            single = one.count > single.count ? one : single;
        }
    }
    const auto filled = static_cast<int>(std::ranges::count_if(
        lines, [](const std::string& line) { return !trimmed(line).empty(); }));
    Rows with_words;
    with_words.count = std::max(much_more * numbers_alone.count, filled / 2);
    const bool possible = filled > with_words.count;
    for (const Dialect& dialect : dialects) {
        if (possible && is_allowed(dialect)) {
            take_rows_with_words(lines, dialect, with_words);
        }
    }
    // A separator that was said is one between columns.
    const Rows& alone = numbers_alone.columns > 0 || choice.delimiter ? numbers_alone : single;
    const Rows& table = with_words.columns > 0 ? with_words : alone;
    return table.columns > 0 ? std::optional(table) : std::nullopt;
}

// The first row of a table of numbers, of which some rows may hold words as well.
std::size_t add_words(std::span<const std::string> lines, std::size_t row, Rows& table) {
    if (table.columns <= most_columns) {
        table.words = find_words(lines.subspan(row), table.dialect, table.columns);
    }
    std::vector<std::string_view> fields;
    // Only the first row may have a word, after its numbers. Before them it is the key of a
    // line above the table.
    if (row > 0 && table.words.empty() && table.columns <= most_columns) {
        split_fields(lines[row], table.dialect.delimiter, fields);
        int last = 0;
        for (std::size_t i = 0; i < fields.size(); ++i) {
            last = fields[i].empty() ? last : static_cast<int>(i);
        }
        table.words = find_words(lines.subspan(row - 1), table.dialect, table.columns);
        std::erase_if(table.words, [last](int column) { return column <= last; });
    }
    while (row > 0 && table.contain(lines[row - 1], fields)) {
        --row;
    }
    return row;
}

}  // namespace

std::optional<TextFormat> guess_text_format(std::span<const std::string> lines,
                                            const TextChoice& choice) {
    const auto said = static_cast<std::size_t>(choice.lines_to_skip.value_or(0));
    const auto body = lines.subspan(std::min(said, lines.size()));
    auto table = find_rows(body, choice);
    if (!table) {
        return std::nullopt;
    }
    TextFormat format;
    format.delimiter = table->dialect.delimiter;
    format.decimal_comma = table->dialect.decimal_comma;
    format.columns = table->columns;
    std::vector<std::string_view> fields;
    // Lines that were said to be skipped are, and no more: a wrong first row is then an error.
    std::size_t skipped = first_row(body, *table);
    if (table->words.empty()) {
        skipped = add_words(body, skipped, *table);
    }
    skipped = choice.lines_to_skip ? said : skipped;
    format.lines_to_skip = static_cast<std::int64_t>(skipped);
    // Numbers that are skipped name no columns.
    LinesAbove above{lines.first(skipped)};
    for (std::size_t i = 0; i < skipped; ++i) {
        if (columns_of(lines[i], table->dialect, fields) > 0) {
            above.names_from = i + 1;
        } else if (const auto named = header_fields(lines[i], format.delimiter); !named.empty()) {
            format.above.push_back(named.front());
        }
    }
    auto rows = lines.subspan(skipped);
    if (table->holds_words(0)) {
        format.no_channels.push_back(0);
    }
    while (!rows.empty() && is_behind_table(rows.back(), format)) {
        rows = rows.first(rows.size() - 1);
    }
    format.no_channels.clear();
    measure(rows, *table, above);
    const FirstColumn first = first_column(rows, format.delimiter, format.decimal_comma);
    above.first_unnamed = table->holds_words(0) || first != FirstColumn::other;
    above.first_is_time = first == FirstColumn::time;
    read_header(above, format);
    if (format.columns <= most_columns) {
        find_columns(rows, choice, table->words, format);
    }
    const auto columns = static_cast<std::size_t>(format.columns);
    for (std::size_t i = columns; i < above.used; ++i) {
        const std::string& name = format.headings[i].name;
        format.words.push_back(name.empty() ? std::to_string(i + 1) : name);
    }
    format.headings.resize(columns);
    return format;
}

std::vector<Channel> channels_of(const TextFormat& format) {
    std::vector<Channel> channels;
    for (const int column : channel_columns(format)) {
        Channel channel = format.heading(column);
        if (channel.name.empty()) {
            channel.name = std::to_string(channels.size() + 1);
        }
        channels.push_back(std::move(channel));
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

namespace {

constexpr std::size_t head_bytes = std::size_t{1} << 18;  // kept on each side of the first row
constexpr std::size_t comment_share = 32;                 // of the bytes of comments count
constexpr std::int64_t lines_between_looks = 4096;        // at the stop token

// Whether commas separate both columns and decimals: "0,000030,1,234500,0,678900". Integers have no
// leading zeros, decimals between delimiters have.
bool has_decimal_commas(std::span<const std::string> lines, const TextFormat& format) {
    constexpr int least_columns = 4;
    if (format.delimiter != ',' || format.decimal_comma || format.columns < least_columns ||
        format.columns % 2 != 0) {
        return false;
    }
    std::vector<std::string_view> fields;
    bool leading_zero = false;
    for (const std::string& line : lines.subspan(static_cast<std::size_t>(format.lines_to_skip))) {
        if (columns_of(line, {',', false}, fields) != format.columns) {
            continue;
        }
        for (std::size_t k = 0; k < fields.size(); k += 2) {
            const std::string_view whole = trimmed(fields[k]);
            const std::string_view decimals = trimmed(fields[k + 1]);
            if (!are_digits(whole.substr(whole.starts_with('-') ? 1 : 0)) ||
                !are_digits(decimals)) {
                return false;
            }
            leading_zero = leading_zero || (decimals.size() > 1 && decimals.front() == '0');
        }
    }
    return leading_zero;
}

// "7,298.797" between semicolons or tabs.
bool has_thousands(std::string_view field) {
    const std::size_t comma = field.find(',');
    const std::size_t point = field.find('.');
    const std::size_t sign = field.starts_with('-') ? 1 : 0;
    return comma != std::string_view::npos && point != std::string_view::npos && comma > sign &&
           comma <= sign + 3 && field[sign] != '0' &&
           are_digits(field.substr(sign, comma - sign)) && point >= comma + 4 &&
           (point - comma) % 4 == 0 && are_digits(field.substr(comma + 1, 3)) &&
           are_digits(field.substr(point + 1));
}

// A line with separators of thousands; nothing where few lines have them.
std::optional<std::string> line_with_thousands(std::span<const std::string> lines) {
    std::vector<std::string_view> fields;
    std::vector<const std::string*> found;
    for (const std::string& line : lines) {
        for (const char delimiter : {';', '\t'}) {
            split_fields(line, delimiter, fields);
            if (fields.size() > 1 && std::ranges::any_of(fields, has_thousands)) {
                found.push_back(&line);
            }
        }
    }
    return found.size() > lines.size() / 4 ? std::optional(*found.front()) : std::nullopt;
}

// Why there is no table; the head has at least the lines that are skipped.
Error no_table(const FileBytes& file, const TextHead& head, const TextChoice& choice) {
    const std::string said = options_text({.text = choice});
    if (said.empty()) {
        return file.error(ErrorCode::text_no_data);
    }
    const auto begin = head.lines.begin() +
                       static_cast<std::ptrdiff_t>(choice.lines_to_skip.value_or(0) - head.dropped);
    auto line = std::find_if(begin, head.lines.end(),
                             [](const std::string& text) { return !trimmed(text).empty(); });
    line = line == head.lines.end() ? begin : line;
    const std::int64_t number = head.dropped + (line - head.lines.begin()) + 1;
    return file.error(ErrorCode::text_no_table, {said, count_arg(number), short_quote(*line)});
}

}  // namespace

Result<TextHead> read_text_head(std::shared_ptr<const FileBytes> file,
                                std::optional<std::int64_t> lines_to_skip, const JobControl& job) {
    TextLines lines(std::move(file));
    TextHead head;
    std::deque<std::string> skipped;  // the last ones
    std::size_t held = 0;             // bytes
    const std::int64_t skip = lines_to_skip.value_or(0);
    for (std::int64_t i = 0; i < skip; ++i) {
        if (i % lines_between_looks == 0) {
            TRY(job.go_on());
        }
        const auto line = TRY(lines.next());
        if (!line) {
            break;
        }
        skipped.emplace_back(*line);
        held += line->size() + 1;
        while (held > head_bytes && skipped.size() > 1) {
            held -= skipped.front().size() + 1;
            skipped.pop_front();
            ++head.dropped;
        }
    }
    head.lines.assign(std::make_move_iterator(skipped.begin()),
                      std::make_move_iterator(skipped.end()));
    for (std::size_t bytes = 0; bytes < head_bytes;) {
        const auto line = TRY(lines.next());
        if (!line) {
            break;
        }
        // However long a comment is, the rows below it count.
        const bool is_remark = is_comment(*line, ',');
        bytes += (is_remark ? line->size() / comment_share : line->size()) + 1;
        head.lines.emplace_back(*line);
    }
    return head;
}

Result<TextFormat> find_text_format(const FileBytes& file, const TextHead& head,
                                    const TextChoice& choice) {
    const std::int64_t count = head.dropped + std::ssize(head.lines);
    if (choice.lines_to_skip && *choice.lines_to_skip >= count) {
        return file.error(ErrorCode::text_lines_missing,
                          {count_arg(*choice.lines_to_skip), count_arg(count)});
    }
    TextChoice here = choice;
    if (here.lines_to_skip) {
        *here.lines_to_skip -= head.dropped;
    }
    if (!choice.delimiter) {
        if (const auto line = line_with_thousands(head.lines)) {
            return file.error(ErrorCode::text_thousands, {short_quote(*line)});
        }
    }
    auto format = guess_text_format(head.lines, here);
    if (!format) {
        return no_table(file, head, choice);
    }
    if (format->columns > most_columns) {
        return file.unsupported(
            "text",
            VYBEG_MESSAGE("Words", "rows of %1 numbers (a column is a channel, a row a time)"),
            {count_arg(format->columns)});
    }
    if (!choice.delimiter && has_decimal_commas(head.lines, *format)) {
        return file.error(
            ErrorCode::text_decimal_commas,
            {short_quote(head.lines[static_cast<std::size_t>(format->lines_to_skip)])});
    }
    format->lines_to_skip += head.dropped;
    if (choice.time_column && *choice.time_column > format->columns) {
        return file.error(ErrorCode::column_out_of_range,
                          {count_arg(*choice.time_column), count_arg(format->columns)});
    }
    return std::move(*format);
}

}  // namespace vybeg
