#include "core/recording/text/text_lines.h"

#include "core/base/plain_text.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

constexpr std::int64_t longest_mark = 4;  // bytes, of the encoding

// Bytes of the longest line that a table may have.
constexpr std::size_t longest_line = std::size_t{1} << 20;

constexpr bool ends_line(char c) {
    return c == '\n' || c == '\r';
}

// The place of the first line end (LF, CRLF, CR) from `from` on; the end of the text where there is
// none.
std::size_t line_end(std::string_view text, std::size_t from) {
    while (from < text.size() && !ends_line(text[from])) {
        ++from;
    }
    return from;
}

// The place after the line end at `end`.
std::size_t behind_line_end(std::string_view text, std::size_t end) {
    return std::min(end + (text.substr(end).starts_with("\r\n") ? 2 : 1), text.size());
}

Error line_too_long(const FileBytes& file, const char* format, std::int64_t line) {
    return file.error(ErrorCode::format_limit,
                      {format, Phrase::tr("line %1 is longer than 1 MiB", {count_arg(line)}),
                       Phrase::tr("Write a line for each time, with one number for each channel")});
}

// Some thousand rows: little to read for one of them, much for one entry of the index. Even, for
// UTF-16.
constexpr std::int64_t block_bytes = std::int64_t{1} << 17;
constexpr std::int64_t first_overhang = 4096;  // for the last line, which ends after the block

}  // namespace

TextBlocks::TextBlocks(std::shared_ptr<const FileBytes> file, TextEncoding encoding,
                       std::int64_t begin, std::int64_t end)
    : file_(std::move(file)), encoding_(encoding), begin_(begin), end_(end) {}

std::int64_t TextBlocks::count() const {
    return (std::max<std::int64_t>(end_ - begin_, 0) + block_bytes - 1) / block_bytes;
}

Status TextBlocks::append(std::int64_t from, std::int64_t to, std::string& bytes) const {
    const auto length = static_cast<std::size_t>(to - from);
    const auto part = file_part(file_, from, to - from);
    if (encoding_ == TextEncoding::bytes) {
        const std::size_t before = bytes.size();
        bytes.resize(before + length);
        return part->read(0, std::span(bytes).subspan(before));
    }
    std::vector<char> units(length);
    const Status status = part->read(0, units);
    append_utf16({units.data(), units.size()}, encoding_, bytes);
    return status;
}

Status TextBlocks::read(std::int64_t index, TextBlock& block) const {
    const std::int64_t from = begin_ + index * block_bytes;
    const std::int64_t to = std::min(from + block_bytes, end_);
    const std::int64_t unit = encoding_ == TextEncoding::bytes ? 1 : 2;
    block.offset = index > 0 ? from - unit : from;
    block.bytes.clear();
    block.bytes.reserve(static_cast<std::size_t>(block_bytes + first_overhang + unit));
    // With the character before the block: where it ends a line, a line begins with the block.
    TRY(append(block.offset, to, block.bytes));
    block.end = block.bytes.size();
    block.begin = index > 0 ? behind_line_end(block.text(), line_end(block.text(), 0)) : 0;
    if (block.begin >= block.end) {
        block.begin = block.end;
        return {};
    }
    std::size_t searched = block.end - 1;
    std::int64_t behind = to;
    for (std::int64_t more = first_overhang; behind < end_; more *= 4) {
        searched = line_end(block.text(), searched);
        // A CR that is the last byte may belong to a CRLF.
        if (searched + 1 < block.bytes.size() || searched > block.end + longest_line) {
            break;
        }
        const std::int64_t next = std::min(behind + more, end_);
        TRY(append(behind, next, block.bytes));
        behind = next;
    }
    return {};
}

std::int64_t TextBlocks::place(const TextBlock& block, std::size_t at) const {
    const std::string_view before = block.text().substr(0, at);
    if (encoding_ == TextEncoding::bytes) {
        return block.offset + std::ssize(before);
    }
    // Every two bytes of the file have become one character.
    return block.offset + 2 * std::ranges::count_if(before, [](char byte) {
                              return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
                          });
}

TextLines::TextLines(std::shared_ptr<const FileBytes> file, const char* format)
    : file_(std::move(file)), format_(format) {}

void TextLines::skip(std::int64_t bytes) {
    const auto at = static_cast<std::int64_t>(at_) + bytes;
    if (bytes == 0 || at < static_cast<std::int64_t>(block_.end)) {
        at_ = static_cast<std::size_t>(at);
        return;
    }
    const std::int64_t from = position() + std::min(bytes, file_->size() - position());
    blocks_.emplace(file_, TextEncoding::bytes, from, file_->size());
    read_ = 0;
    block_ = TextBlock();
    block_.offset = from;
    at_ = 0;
}

Result<std::optional<std::string_view>> TextLines::next() {
    if (!blocks_) {
        const auto head = TRY(file_->text(0, longest_mark));
        blocks_.emplace(file_, encoding_of(head), static_cast<std::int64_t>(mark_length(head)),
                        file_->size());
    }
    while (at_ >= block_.end) {
        if (read_ == blocks_->count()) {
            return std::optional<std::string_view>{};
        }
        TRY(blocks_->read(read_++, block_));
        at_ = block_.begin;
    }
    const std::size_t begin = at_;
    const std::size_t end = line_end(block_.text(), begin);
    if (end - begin > longest_line) {
        return line_too_long(*file_, format_, number_ + 1);
    }
    ended_ = end < block_.bytes.size();
    at_ = behind_line_end(block_.text(), end);
    ++number_;
    return std::optional(block_.text().substr(begin, end - begin));
}

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

// The place after a number like -12.5, which is finite without that it were computed; nothing where
// there is any other, as one with an exponent.
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

// Blanks around a field of a line cut at `delimiter`.
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

TextFault time_fault(std::int64_t line, double time, double before) {
    return {ErrorCode::text_time_backwards, line, {exact_arg(time), exact_arg(before)}};
}

Error fault_error(const FileBytes& file, std::int64_t lines_above, const TextFault& fault) {
    const std::int64_t line = lines_above + fault.line;
    if (fault.code == ErrorCode::format_limit) {
        return line_too_long(file, "text", line);
    }
    Error error = file.error(fault.code, {count_arg(line)});
    error.args.insert(error.args.end(), fault.args.begin(), fault.args.end());
    return error;
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

// Reads a row in which every field has its usual form, straight from its characters. Returns
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
        fault_ = TextFault{ErrorCode::format_limit, lines_};
        return false;
    }
    // A row of delimiters alone is a missing sample only where no time is missing as well, also
    // when the times have done their part.
    if (trimmed(line).empty() || (format_.time_column >= 0 &&
                                  line.find_first_not_of(no_content) == std::string_view::npos)) {
        return false;
    }
    if (is_comment(line, format_.delimiter)) {
        ++ignored_;
        return false;
    }
    split_fields(line, format_.delimiter, fields_);
    const auto columns = static_cast<std::size_t>(format_.columns);
    ended_ = ended;
    if (fields_.size() < columns && !ended) {
        cut_ = true;  // the recorder stopped, or the copy was cut, within this line
        return false;
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
    constexpr std::string_view within_a_number("0123456789+-.,eE");
    if (!ended_ && column + 1 == std::ssize(fields_) &&
        field(column).find_first_not_of(within_a_number) == std::string_view::npos) {
        cut_ = true;
        return false;
    }
    if (column == 0 && !field(0).empty() &&
        std::ranges::find(format_.above, field(0)) != format_.above.end()) {
        fault_ = TextFault{ErrorCode::text_segments, lines_};
        return false;
    }
    fault_ = TextFault{
        ErrorCode::text_not_a_number, lines_, {count_arg(column + 1), short_quote(field(column))}};
    return false;
}

namespace {

// The end of the last line that has content in a text from `begin` to `end`; spreadsheets write
// rows of delimiters after it. Errors: file_read_failed.
Result<std::int64_t> end_of_content(const std::shared_ptr<const FileBytes>& file,
                                    TextEncoding encoding, std::int64_t begin, std::int64_t end) {
    const TextBlocks blocks(file, encoding, begin, end);
    const std::string empty = std::string(no_content) + "\r\n";
    TextBlock block;
    for (std::int64_t index = blocks.count(); index-- > 0;) {
        TRY(blocks.read(index, block));
        const std::size_t last = block.text().find_last_not_of(empty);
        const bool found = last != std::string::npos;
        const std::size_t behind = line_end(block.text(), found ? last : 0);
        end = behind < block.bytes.size() ? blocks.place(block, behind + 1) : end;
        if (found) {
            return end;
        }
    }
    return begin;
}

// The end of the table in a text that ends at `end`: before the last lines below it, of
// which few are looked at and those with content counted. Errors: file_read_failed.
Result<std::int64_t> end_of_table(const std::shared_ptr<const FileBytes>& file,
                                  TextEncoding encoding, std::int64_t begin, std::int64_t end,
                                  const TextFormat& format, std::int64_t& footer_lines) {
    constexpr std::int64_t looked_at = 1 << 14;  // bytes, less than a block has
    const std::int64_t from = end - std::min(end - begin, looked_at);
    const TextBlocks blocks(file, encoding, from, end);
    TextBlock block;
    TRY(blocks.read(0, block));
    const std::string_view text = block.text();
    std::size_t to = text.size();
    while (to > 0) {
        std::size_t last = to;  // after the line's characters
        while (last > 0 && ends_line(text[last - 1])) {
            --last;
        }
        std::size_t first = last;
        while (first > 0 && !ends_line(text[first - 1])) {
            --first;
        }
        // Nothing is known of a line that begins before the bytes that were read.
        const std::string_view line = text.substr(first, last - first);
        if ((first == 0 && from > begin) || !is_behind_table(line, format)) {
            break;
        }
        footer_lines += trimmed(line).empty() ? 0 : 1;
        to = first;
    }
    return blocks.place(block, to);
}

}  // namespace

Result<TextTable> find_table(std::shared_ptr<const FileBytes> file, const TextFormat& format,
                             const TextColumns& columns) {
    const auto head = TRY(file->text(0, longest_mark));
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
    const TextEncoding encoding = encoding_of(head);
    const std::int64_t unit = encoding == TextEncoding::bytes ? 1 : 2;
    const std::int64_t size = begin + (file->size() - begin) / unit * unit;
    const auto content = TRY(end_of_content(file, encoding, begin, size));
    std::int64_t footer_lines = 0;
    const auto end = TRY(end_of_table(file, encoding, begin, content, format, footer_lines));
    return TextTable{TextBlocks(file, encoding, begin, end), format, columns, header_lines,
                     footer_lines};
}

}  // namespace vybeg
