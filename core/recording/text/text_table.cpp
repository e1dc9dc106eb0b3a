#include "core/recording/text/text_table.h"

#include "core/base/plain_text.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_lines.h"

#include <fast_float/fast_float.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

namespace vybeg {
namespace {

bool begins_number(char c) {
    return is_digit(c) || c == '-' || c == '+' || c == '.';
}

const char* skip_digits(const char* at, const char* end) {
    // Eight at once: digits are 0x30 to 0x39, and only they keep their upper half when 6 is added.
    while (end - at >= 8) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, at, sizeof eight);
        constexpr std::uint64_t upper = 0xF0F0F0F0F0F0F0F0;
        constexpr std::uint64_t zeros = 0x3030303030303030;
        constexpr std::uint64_t sixes = 0x0606060606060606;
        if ((eight & upper) != zeros || ((eight + sixes) & upper) != zeros) {
            break;
        }
        at += sizeof eight;
    }
    while (at != end && is_digit(*at)) {
        ++at;
    }
    return at;
}

// Behind a number like -12.5, which is finite without that it were computed; nothing where there is
// any other, as one with an exponent.
const char* skip_number(const char* at, const char* end, char sign) {
    at += at != end && *at == '-' ? 1 : 0;
    const char* const begin = at;
    at = skip_digits(at, end);
    if (at == begin) {
        return nullptr;
    }
    if (at != end && *at == sign) {
        const char* const decimals = at + 1;
        at = skip_digits(decimals, end);
        if (at == decimals) {
            return nullptr;
        }
    }
    constexpr std::ptrdiff_t longest = 37;  // of all that are below least_mark
    return at != end && *at != 'e' && *at != 'E' && at - begin < longest ? at : nullptr;
}

// Blanks that may stand round a field of a line cut at `delimiter`.
const char* skip_blanks(const char* at, const char* end, char delimiter) {
    while (at != end && (*at == ' ' || *at == '\t') && *at != delimiter) {
        ++at;
    }
    return at;
}

}  // namespace

TextRows::TextRows(const TextFormat& format, const TextColumns& columns, const TextBlock& block,
                   SampleUse use)
    : format_(format),
      columns_(columns),
      block_(block),
      use_(use),
      plain_(std::string_view(",;\t| ").find(format.delimiter) != std::string_view::npos &&
             !(format.decimal_comma && format.delimiter == ',')),
      at_(block.begin) {}

Error fault_error(const FileBytes& file, std::int64_t line, const TextFault& fault) {
    if (fault.code == ErrorCode::format_limit) {
        return line_too_long(file, "text", line);
    }
    return file.error(fault.code, {count_arg(line), count_arg(fault.column + 1), fault.text});
}

bool TextRows::next() {
    const std::string_view text = block_.text();
    while (at_ < block_.end && !fault_) {
        ++lines_;
        const char* const end = text.data() + text.size();
        const char* const plain = plain_ ? plain_row(text.data() + at_, end) : nullptr;
        over_c_ = false;
        over_d_ = false;
        clock_.reset();
        if (plain) {
            at_ = behind_line_end(text, static_cast<std::size_t>(plain - text.data()));
            return true;
        }
        const std::size_t begin = at_;
        const std::size_t behind = line_end(text, begin);
        at_ = behind_line_end(text, behind);
        if (any_row(text.substr(begin, behind - begin), behind < text.size())) {
            return true;
        }
    }
    return false;
}

// Reads a row in which every field is what it usually is, straight from its characters. Returns
// where its line end begins; nothing where any_row() has to look, which then decides alone.
const char* TextRows::plain_row(const char* at, const char* end) {
    const char delimiter = format_.delimiter;
    at = skip_blanks(at, end, delimiter == ' ' ? '\0' : delimiter);
    if (at == end || !begins_number(*at)) {
        return nullptr;
    }
    for (int column = 0; column < format_.columns; ++column) {
        if (column > 0) {
            if (at == end || (*at != delimiter && !(delimiter == ' ' && *at == '\t'))) {
                return nullptr;
            }
            at = skip_blanks(at + 1, end, delimiter == ' ' ? '\0' : delimiter);
        }
        if (column == columns_.c || column == columns_.d || column == columns_.time) {
            at = plain_number(at, end, column);
            if (!at) {
                return nullptr;
            }
        } else {
            const char* const begin = at;
            const char* const number = skip_number(at, end, format_.decimal_comma ? ',' : '.');
            at = number ? number : at;
            while (at != end && *at != delimiter && !ends_line(*at)) {
                if (*at == '"' || (delimiter == ' ' && *at == '\t')) {
                    return nullptr;
                }
                ++at;
            }
            if (at == begin) {
                return nullptr;
            }
        }
        if (delimiter != ' ') {
            at = skip_blanks(at, end, delimiter);
        }
    }
    if (delimiter == ' ') {
        at = skip_blanks(at, end, '\0');
    }
    return at != end && ends_line(*at) ? at : nullptr;
}

// A finite number at the start of a field; returns what follows it.
const char* TextRows::plain_number(const char* at, const char* end, int column) {
    if (use_ == SampleUse::check && column != columns_.time) {
        const char* const behind = skip_number(at, end, format_.decimal_comma ? ',' : '.');
        if (behind) {
            (column == columns_.c ? c_ : d_) = 0;
            return behind;
        }
    }
    const char* const begin = at;
    if (at != end && *at == '+') {
        ++at;
        if (at == end || *at == '-') {
            return nullptr;
        }
    }
    double value = 0;
    const auto parsed = fast_float::from_chars_advanced(
        at, end, value,
        fast_float::parse_options(fast_float::chars_format::general,
                                  format_.decimal_comma ? ',' : '.'));
    if (parsed.ec != std::errc{} || !(std::abs(value) < least_mark) || parsed.ptr[-1] == ',') {
        return nullptr;
    }
    if (column == columns_.time) {
        time_ = value;
        time_text_ = {begin, static_cast<std::size_t>(parsed.ptr - begin)};
    } else {
        (column == columns_.c ? c_ : d_) = value;
    }
    return parsed.ptr;
}

// Any other line: true where it is a row, too. `ended`: it has a line end.
bool TextRows::any_row(std::string_view line, bool ended) {
    if (line.size() > longest_line) {
        fault_ = {ErrorCode::format_limit, 0, ""};
        return false;
    }
    // A row of delimiters alone is a missing sample only where no time is missing as well.
    if (trimmed(line).empty() ||
        (columns_.time >= 0 && line.find_first_not_of(no_content) == std::string_view::npos)) {
        return false;
    }
    if (is_comment(line, format_.delimiter)) {
        ++ignored_;
        return false;
    }
    split_fields(line, format_.delimiter, fields_);
    const auto columns = static_cast<std::size_t>(format_.columns);
    if (fields_.size() < columns && !ended) {
        return false;  // the recorder stopped, or the copy was cut, within this line
    }
    for (std::size_t i = columns; i < fields_.size() && !format_.has_remarks; ++i) {
        if (!fields_[i].empty() && parse_field(fields_[i], format_.decimal_comma)) {
            return fail(static_cast<int>(i));
        }
    }
    // Blanks cannot say which field is missing.
    if (fields_.size() < columns && format_.delimiter == ' ') {
        return fail(static_cast<int>(fields_.size()));
    }
    return (columns_.time < 0 || time_field()) && sample(columns_.c, c_, over_c_) &&
           sample(columns_.d, d_, over_d_);
}

bool TextRows::time_field() {
    const std::string_view text = field(columns_.time);
    if (format_.clock_from_s) {
        const auto clock = parse_clock(text);
        if (!clock || !clock->timed) {
            return fail(columns_.time);
        }
        time_ = seconds_after(*clock, *format_.clock_from_s);
        clock_ = NumberDigits{clock->decimals, std::numeric_limits<double>::max_digits10};
        return true;
    }
    if (!number(columns_.time, time_) || !std::isfinite(time_)) {
        return fail(columns_.time);
    }
    usual_time_ = usual_number(text, format_.decimal_comma);
    time_text_ = usual_time_;
    return true;
}

bool TextRows::sample(int column, double& value, bool& over_range) {
    if (!number(column, value)) {
        return false;
    }
    over_range = std::isinf(value);
    value = over_range ? std::numeric_limits<double>::quiet_NaN() : value;
    return true;
}

std::string_view TextRows::field(int column) const {
    const auto i = static_cast<std::size_t>(column);
    return i < fields_.size() ? fields_[i] : std::string_view{};
}

bool TextRows::number(int column, double& value) {
    const auto parsed = parse_field(field(column), format_.decimal_comma);
    if (!parsed) {
        return fail(column);
    }
    value = *parsed;
    return true;
}

bool TextRows::fail(int column) {
    fault_ = {ErrorCode::text_not_a_number, column, short_quote(field(column))};
    return false;
}

Result<TextTable> find_table(std::shared_ptr<const FileBytes> file, const TextFormat& format,
                             const TextColumns& columns) {
    const auto head = TRY(file->text(0, 4));
    auto begin = static_cast<std::int64_t>(mark_length(head));
    std::int64_t header_lines = 0;
    TextLines lines(file);
    while (lines.number() < format.lines_to_skip) {
        const auto line = TRY(lines.next());
        if (!line) {
            break;
        }
        header_lines += trimmed(*line).empty() ? 0 : 1;
        begin = lines.position();
    }
    const auto content = TRY(end_of_content(*file, encoding_of(head), begin));
    std::int64_t footer_lines = 0;
    const auto end =
        TRY(end_of_table(*file, encoding_of(head), begin, content, [&](std::string_view line) {
            const bool behind = is_behind_table(line, format);
            footer_lines += behind && !trimmed(line).empty() ? 1 : 0;
            return behind;
        }));
    return TextTable{TextBlocks(file, encoding_of(head), begin, end), format, columns, header_lines,
                     footer_lines};
}

}  // namespace vybeg
