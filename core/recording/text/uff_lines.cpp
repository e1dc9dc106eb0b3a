#include "core/recording/text/uff_lines.h"

#include "core/recording/text/text_lines.h"

#include <algorithm>
#include <span>

namespace vybeg {
namespace {

constexpr std::size_t uff_chunk_bytes = std::size_t{1} << 16;

}  // namespace

Result<std::optional<std::string_view>> UffLines::next() {
    std::size_t looked = 0;  // without a line end so far
    for (;;) {
        const std::size_t end = rest().find_first_of("\r\n", looked);
        // A CR at the end of the chunk may be half of a CRLF.
        if (end != std::string_view::npos && (rest()[end] == '\n' || end + 1 < rest().size())) {
            const std::string_view line = rest().substr(0, end);
            begin_ += end + (rest().substr(end, 2) == "\r\n" ? 2 : 1);
            ++number_;
            ended_ = true;
            return std::optional(line);
        }
        looked = std::min(end, rest().size());
        if (looked > longest_line) {
            return line_too_long(*file_, "UFF", number_ + 1);
        }
        const auto more = TRY(fill());
        if (!more) {
            break;
        }
    }
    if (rest().empty()) {
        return std::optional<std::string_view>();
    }
    ended_ = rest().back() == '\r';
    const std::string_view line = rest().substr(0, rest().size() - (ended_ ? 1 : 0));
    begin_ = buffer_.size();
    ++number_;
    return std::optional(line);
}

void UffLines::skip(std::int64_t bytes) {
    const auto held = static_cast<std::int64_t>(rest().size());
    begin_ += static_cast<std::size_t>(std::min(bytes, held));
    offset_ += std::min(std::max<std::int64_t>(bytes - held, 0), file_->size() - offset_);
}

// False at the end of the file.
Result<bool> UffLines::fill() {
    buffer_.erase(0, begin_);
    begin_ = 0;
    const std::size_t held = buffer_.size();
    buffer_.resize(held + uff_chunk_bytes);
    const auto got = file_->read(offset_, std::span(buffer_).subspan(held));
    if (!got) {
        return got.error();
    }
    buffer_.resize(held + static_cast<std::size_t>(*got));
    offset_ += *got;
    return *got > 0;
}

}  // namespace vybeg
