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
        while (end < buffer_.size() && buffer_[end] != '\n' && buffer_[end] != '\r') {
            ++end;
        }
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
    const bool crlf = std::string_view(buffer_).substr(end).starts_with("\r\n");
    begin_ = end + (crlf ? 2 : ended_ ? 1 : 0);
    ++number_;
    return std::optional(line);
}

}  // namespace vybeg
