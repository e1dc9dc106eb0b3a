#pragma once

#include "core/base/error.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_columns.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// The lines that begin in one block of a text file, as UTF-8 bytes.
struct TextBlock {
    std::string bytes;        // with bytes before and after those lines
    std::int64_t offset = 0;  // of them in the file
    std::size_t begin = 0;    // of the first line
    std::size_t end = 0;      // lines that begin from here on belong to later blocks

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
    // Replaces the content of `block`. A line of more than longest_line bytes is cut after that
    // many. Errors: file_read_failed.
    Status read(std::int64_t index, TextBlock& block) const;
    // Where in the file the byte `at` of what has been read lies.
    std::int64_t place(const TextBlock& block, std::size_t at) const;

private:
    Status append(std::int64_t from, std::int64_t to, std::string& bytes) const;

    std::shared_ptr<const FileBytes> file_;
    TextEncoding encoding_;
    std::int64_t begin_;
    std::int64_t end_;
};

// The lines of a text file one after the other, as UTF-8 bytes without line ends (LF, CRLF, CR) and
// without the byte order mark. Holds one block of the file in memory.
class TextLines {
public:
    // `format` names the file in errors.
    explicit TextLines(std::shared_ptr<const FileBytes> file, const char* format = "text");

    // The next line, valid until the next call; nothing after the last one. Errors:
    // file_read_failed; format_limit where a line is longer than 1 MiB.
    Result<std::optional<std::string_view>> next();

    // Passes over bytes that are no lines. Precondition: they are not negative, and the text is not
    // UTF-16.
    void skip(std::int64_t bytes);

    std::int64_t number() const { return number_; }  // of the line last returned, from 1
    bool ended() const { return ended_; }            // whether that line had a line end
    // Of the next line in the file, in bytes.
    std::int64_t position() const { return blocks_ ? blocks_->place(block_, at_) : 0; }

private:
    std::shared_ptr<const FileBytes> file_;
    const char* format_;
    std::optional<TextBlocks> blocks_;  // of the lines; nothing before the first one is read
    std::int64_t read_ = 0;             // of the blocks, up to the present one
    TextBlock block_;
    std::size_t at_ = 0;  // of the next line in it
    std::int64_t number_ = 0;
    bool ended_ = true;
};

// Which columns of a table are read, from 0; -1 for the time where there is none or it is not
// wanted.
struct TextColumns {
    int time = -1;
    int c = 0;
    int d = 1;
    double d_factor = 1;  // of D's numbers, for them to be in the unit of C
};

// Why a line is no row of the table: text_not_a_number, text_time_backwards; text_segments where it
// begins as one above the table does; format_limit where it is too long.
struct TextFault {
    ErrorCode code{};
    std::int64_t line = 0;           // from 1, counted from the start of the block
    std::vector<MessageArg> args{};  // after the number of the line
};

// The fault of a time that follows one that is not before it, both in the column's unit.
TextFault time_fault(std::int64_t line, double time, double before);

// The error of a fault that has so many lines of the file above its block.
Error fault_error(const FileBytes& file, std::int64_t lines_above, const TextFault& fault);

// Use of the samples of a row. Checking is faster: every number has the value 0.
enum class SampleUse { read, check };

// The rows of a table one after the other, from the lines of a block. An empty field is a missing
// sample, NaN; a last line of the file that is cut off, within a row or
// its last number, is left out.
class TextRows {
public:
    // `format` and `block` must outlive the object.
    TextRows(const TextFormat& format, const TextColumns& columns, const TextBlock& block,
             SampleUse use);

    // Goes to the next row; false after the last one and at a fault.
    bool next();

    double time() const { return time_; }  // in the column's unit
    NumberDigits time_digits() const { return clock_ ? *clock_ : digits_of(time_text_); }
    double c() const { return c_; }
    double d() const { return columns_.d == columns_.c ? c_ : d_ * columns_.d_factor; }
    // Whether the sample is missing because it lies beyond the range.
    bool c_over_range() const { return over_c_; }
    bool d_over_range() const { return over_d_; }

    const std::optional<TextFault>& fault() const { return fault_; }
    std::int64_t lines() const { return lines_; }      // begun so far: the row's own, from 1
    std::int64_t ignored() const { return ignored_; }  // comments among them
    bool ends_within_row() const { return cut_; }      // the file, in the line last begun

private:
    const char* plain_row(const char* at, const char* end);
    const char* plain_number(const char* at, const char* end, int column);
    bool any_row(std::string_view line, bool ended);
    std::string_view field(int column) const;
    bool number(int column, double& value);
    bool sample(int column, double& value, bool& over_range);
    bool time_field();
    bool fail(int column);

    const TextFormat& format_;
    TextColumns columns_;
    const TextBlock& block_;
    SampleUse use_;
    bool plain_;  // whether plain_row() understands the format
    std::size_t at_;
    double time_ = 0;
    double c_ = 0;
    double d_ = 0;
    bool over_c_ = false;
    bool over_d_ = false;
    std::string_view time_text_;
    std::string usual_time_;             // time_text_ where others write it
    std::optional<NumberDigits> clock_;  // of a time of day
    std::optional<TextFault> fault_;
    std::int64_t lines_ = 0;
    std::int64_t ignored_ = 0;
    bool ended_ = true;  // the line of any_row()
    bool cut_ = false;
    std::vector<std::string_view> fields_;
};

// A table of numbers in a text file: its lines, their format and the columns that are read.
struct TextTable {
    TextBlocks blocks;
    TextFormat format;
    TextColumns columns;
    std::int64_t header_lines = 0;  // of those above the table, the ones that are not blank
    std::int64_t footer_lines = 0;  // of those below it
    bool may_repeat = false;        // the time of the row before, as in logs
};

// Finds the first line below those that `format` skips, and the last one before those
// below the table (is_behind_table()). Errors: file_read_failed, format_limit.
Result<TextTable> find_table(std::shared_ptr<const FileBytes> file, const TextFormat& format,
                             const TextColumns& columns);

}  // namespace vybeg
