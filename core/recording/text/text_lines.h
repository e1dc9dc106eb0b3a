#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/text_encoding.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace vybeg {

constexpr bool ends_line(char c) {
    return c == '\n' || c == '\r';
}

// The place of the first line end (LF, CRLF, CR) from `from` on; the end of the text where there is
// none.
std::size_t line_end(std::string_view text, std::size_t from);

// The place behind the line end at `end`.
std::size_t behind_line_end(std::string_view text, std::size_t end);

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

// What lines without any number or word consist of: delimiters, quotes and blanks.
inline constexpr std::string_view no_content = " \t\v\f\x1A,;|\"";

// The lines that begin in one block of a text file, as UTF-8 bytes.
struct TextBlock {
    std::string bytes;      // also what stands around those lines
    std::size_t begin = 0;  // of the first line
    std::size_t end = 0;    // lines that begin from here on belong to later blocks

    std::string_view text() const { return bytes; }
};

// A text file cut into blocks of equally many bytes, each with the lines that begin in it: any of
// them can be read at any time, from several threads at once.
class TextBlocks {
public:
    // The text from `begin`, which is the first byte of a line, to `end`.
    TextBlocks(std::shared_ptr<const FileBytes> file, TextEncoding encoding, std::int64_t begin,
               std::int64_t end);

    const FileBytes& file() const { return *file_; }
    std::int64_t count() const;  // blocks
    // Replaces what `block` holds. A line of more than longest_line bytes is cut behind that many.
    // Errors: file_read_failed.
    Status read(std::int64_t index, TextBlock& block) const;

private:
    Status append(std::int64_t from, std::int64_t to, std::string& bytes) const;

    std::shared_ptr<const FileBytes> file_;
    TextEncoding encoding_;
    std::int64_t begin_;
    std::int64_t end_;
};

// The end of the table in a text that ends at `end`: before the last lines for which `is_behind` is
// true, of which few are looked at. Errors: file_read_failed.
Result<std::int64_t> end_of_table(const FileBytes& file, TextEncoding encoding, std::int64_t begin,
                                  std::int64_t end,
                                  const std::function<bool(std::string_view line)>& is_behind);

// The end of the last line that has content; spreadsheets write rows of delimiters behind it.
// Errors: file_read_failed.
Result<std::int64_t> end_of_content(const FileBytes& file, TextEncoding encoding,
                                    std::int64_t begin);

}  // namespace vybeg
