#include "core/recording/text/text_lines.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr std::size_t chunk_bytes = std::size_t{1} << 16;  // even, for UTF-16

}  // namespace

Error line_too_long(const FileBytes& file, const char* format, std::int64_t line) {
    return file.error(
        ErrorCode::format_limit,
        {format, words(VYBEG_MESSAGE("Words", "line %1 is longer than 1 MiB"), {count_arg(line)}),
         words(VYBEG_MESSAGE("Words",
                             "Write a line for each time, with one number for each "
                             "channel"))});
}

TextLines::TextLines(std::shared_ptr<const FileBytes> file, const char* format)
    : file_(std::move(file)), format_(format) {}

std::int64_t TextLines::position() const {
    const std::string_view left = std::string_view(buffer_).substr(begin_);
    if (encoding_ == TextEncoding::bytes) {
        return offset_ - static_cast<std::int64_t>(left.size());
    }
    // Every two bytes of the file have become one character.
    const auto characters = std::count_if(left.begin(), left.end(), [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
    });
    return offset_ / 2 * 2 - 2 * static_cast<std::int64_t>(characters);
}

void TextLines::skip(std::int64_t bytes) {
    const auto held = static_cast<std::int64_t>(buffer_.size() - begin_);
    begin_ += static_cast<std::size_t>(std::min(bytes, held));
    offset_ += std::min(std::max<std::int64_t>(bytes - held, 0), file_->size() - offset_);
}

Status TextLines::fill() {
    buffer_.erase(0, begin_);
    begin_ = 0;
    std::vector<char> bytes(chunk_bytes);
    const auto got = TRY(file_->read(offset_, bytes));
    std::string_view chunk(bytes.data(), static_cast<std::size_t>(got));
    if (offset_ == 0) {
        encoding_ = encoding_of(chunk);
        chunk.remove_prefix(mark_length(chunk));
    }
    offset_ += got;
    if (encoding_ == TextEncoding::bytes) {
        buffer_ += chunk;
    } else {
        append_utf16(chunk, encoding_, buffer_);
    }
    if (got == 0) {
        offset_ = std::max(offset_, file_->size());
    }
    return {};
}

Result<std::optional<std::string_view>> TextLines::next() {
    std::size_t end = begin_;
    for (;;) {
        end = line_end(buffer_, end);
        // A CR that is the last byte of the buffer may belong to a CRLF.
        const bool whole = end + 1 < buffer_.size();
        if (whole || offset_ >= file_->size()) {
            break;
        }
        if (end - begin_ > longest_line) {
            return line_too_long(*file_, format_, number_ + 1);
        }
        end -= begin_;
        TRY(fill());
    }
    if (begin_ >= buffer_.size()) {
        return std::optional<std::string_view>{};
    }
    const std::string_view line(buffer_.data() + begin_, end - begin_);
    ended_ = end < buffer_.size();
    begin_ = behind_line_end(buffer_, end);
    ++number_;
    return std::optional(line);
}

namespace {

// Some thousand rows: little to read for one of them, much for one entry of the index. Even, for
// UTF-16.
constexpr std::int64_t block_bytes = std::int64_t{1} << 17;
constexpr std::int64_t first_overhang = 4096;  // for the last line, which ends behind the block

// The ASCII character at `at`, in one byte or two; for any other one, one that no text looks for.
char ascii_at(std::string_view text, std::size_t at, TextEncoding encoding) {
    if (encoding == TextEncoding::bytes) {
        return text[at];
    }
    const std::size_t low = encoding == TextEncoding::utf16_big ? 1 : 0;
    return text[at + 1 - low] == '\0' ? text[at + low] : '\x80';
}

}  // namespace

std::size_t line_end(std::string_view text, std::size_t from) {
    while (from < text.size() && !ends_line(text[from])) {
        ++from;
    }
    return from;
}

std::size_t behind_line_end(std::string_view text, std::size_t end) {
    return std::min(end + (text.substr(end).starts_with("\r\n") ? 2 : 1), text.size());
}

TextBlocks::TextBlocks(std::shared_ptr<const FileBytes> file, TextEncoding encoding,
                       std::int64_t begin, std::int64_t end)
    : file_(std::move(file)), encoding_(encoding), begin_(begin), end_(end) {}

std::int64_t TextBlocks::count() const {
    return (std::max<std::int64_t>(end_ - begin_, 0) + block_bytes - 1) / block_bytes;
}

Status TextBlocks::append(std::int64_t from, std::int64_t to, std::string& bytes) const {
    const auto length = static_cast<std::size_t>(to - from);
    const auto fill = [&](std::span<char> out) -> Status {
        const auto got = TRY(file_->read(from, out));
        return got == to - from ? Status{}
                                : file_->error(ErrorCode::file_read_failed,
                                               {"the file became shorter while it was read"});
    };
    if (encoding_ == TextEncoding::bytes) {
        const std::size_t before = bytes.size();
        bytes.resize(before + length);
        return fill(std::span(bytes).subspan(before));
    }
    std::vector<char> units(length);
    const Status status = fill(units);
    append_utf16({units.data(), units.size()}, encoding_, bytes);
    return status;
}

Status TextBlocks::read(std::int64_t index, TextBlock& block) const {
    const std::int64_t from = begin_ + index * block_bytes;
    const std::int64_t to = std::min(from + block_bytes, end_);
    const std::int64_t unit = encoding_ == TextEncoding::bytes ? 1 : 2;
    block.bytes.clear();
    block.bytes.reserve(static_cast<std::size_t>(block_bytes + first_overhang + unit));
    // One character more: whether it is a line end tells whether a line begins with the block.
    TRY(append(index > 0 ? from - unit : from, to, block.bytes));
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
        if (searched < block.bytes.size() || searched > block.end + longest_line) {
            break;
        }
        const std::int64_t next = std::min(behind + more, end_);
        TRY(append(behind, next, block.bytes));
        behind = next;
    }
    return {};
}

Result<std::int64_t> end_of_table(const FileBytes& file, TextEncoding encoding, std::int64_t begin,
                                  std::int64_t end,
                                  const std::function<bool(std::string_view line)>& is_behind) {
    constexpr std::int64_t looked_at = 1 << 14;  // bytes
    const std::size_t unit = encoding == TextEncoding::bytes ? 1 : 2;
    const std::int64_t from = end - std::min(end - begin, looked_at) /
                                        static_cast<std::int64_t>(unit * unit) *
                                        static_cast<std::int64_t>(unit * unit);
    const auto bytes = TRY(file.text(from, end - from));
    const std::string_view text = bytes;
    const auto ends_at = [&](std::size_t at) { return ends_line(ascii_at(text, at, encoding)); };
    std::size_t to = text.size();
    while (to > 0) {
        std::size_t last = to;  // behind the line's characters
        while (last >= unit && ends_at(last - unit)) {
            last -= unit;
        }
        std::size_t first = last;
        while (first >= unit && !ends_at(first - unit)) {
            first -= unit;
        }
        if (first < unit && from > begin) {
            break;  // the line begins before what is looked at
        }
        std::string line;
        if (encoding == TextEncoding::bytes) {
            line = text.substr(first, last - first);
        } else {
            append_utf16(text.substr(first, last - first), encoding, line);
        }
        if (!is_behind(line)) {
            break;
        }
        to = first;
    }
    return from + static_cast<std::int64_t>(to);
}

Result<std::int64_t> end_of_content(const FileBytes& file, TextEncoding encoding,
                                    std::int64_t begin) {
    const std::int64_t unit = encoding == TextEncoding::bytes ? 1 : 2;
    const std::int64_t size = begin + (file.size() - begin) / unit * unit;
    std::int64_t line_ends = size;  // of the lines behind
    for (std::int64_t to = size; to > begin;) {
        const std::int64_t from = std::max(begin, to - first_overhang);
        const auto text = TRY(file.text(from, to - from));
        for (std::int64_t at = std::ssize(text) / unit * unit - unit; at >= 0; at -= unit) {
            const char character = ascii_at(text, static_cast<std::size_t>(at), encoding);
            if (ends_line(character)) {
                line_ends = from + at + unit;
            } else if (no_content.find(character) == std::string_view::npos) {
                return line_ends;
            }
        }
        to = from;
    }
    return begin;
}

}  // namespace vybeg
