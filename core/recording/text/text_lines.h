#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/text_encoding.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace vybeg {

// Bytes of the longest line that a table may have.
inline constexpr std::size_t longest_line = std::size_t{1} << 20;

// The error of a longer one.
Error line_too_long(const FileBytes& file, const char* format, std::int64_t line);

// The lines of a text file one after the other, as UTF-8 bytes without line ends (LF, CRLF, CR) and
// without the byte order mark. Holds one chunk of the file in memory.
class TextLines {
public:
    // `format` names the file in errors.
    explicit TextLines(std::shared_ptr<const FileBytes> file, const char* format = "text");

    // The next line, valid until the next call; nothing behind the last one. Errors:
    // file_read_failed; format_limit where a line is longer than 1 MiB.
    Result<std::optional<std::string_view>> next();

    // Passes over bytes that are no lines. Precondition: they are not negative, and the text is not
    // UTF-16.
    void skip(std::int64_t bytes);

    std::int64_t number() const { return number_; }  // of the line last returned, from 1
    bool ended() const { return ended_; }            // whether that line had a line end
    std::int64_t position() const;                   // of the next line in the file, in bytes

private:
    Status fill();

    std::shared_ptr<const FileBytes> file_;
    const char* format_;
    TextEncoding encoding_ = TextEncoding::bytes;
    std::string buffer_;  // decoded text that is not yet returned, from begin_ on
    std::size_t begin_ = 0;
    std::int64_t offset_ = 0;  // in the file
    std::int64_t number_ = 0;
    bool ended_ = true;
};

}  // namespace vybeg
