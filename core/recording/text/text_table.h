#pragma once

#include "core/base/error.h"
#include "core/base/result.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_columns.h"
#include "core/recording/text/text_lines.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// Which columns of a table are read, from 0; -1 for the time where there is none or it is not
// wanted.
struct TextColumns {
    int time = -1;
    int c = 0;
    int d = 1;
    double d_factor = 1;  // of D's numbers, for them to be in the unit of C
};

// A line that is no row of the table.
struct TextFault {
    ErrorCode code{};  // text_not_a_number; format_limit where the line is too long
    int column = 0;    // from 0
    std::string text;  // what stands there instead of a number
};

// The error of a fault that stands in this line of the file, from 1.
Error fault_error(const FileBytes& file, std::int64_t line, const TextFault& fault);

// What is done with the samples of a row. To check is faster: whatever is a number has the value 0.
enum class SampleUse { read, check };

// The rows of a table one after the other, from the lines of a block. An empty field is a missing
// sample, NaN; a last line of the file that is cut off is left out.
class TextRows {
public:
    // `format` and `block` must outlive the object.
    TextRows(const TextFormat& format, const TextColumns& columns, const TextBlock& block,
             SampleUse use);

    // Goes to the next row; false behind the last one and at a fault.
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
    std::vector<std::string_view> fields_;
};

// A table of numbers in a text file: where its lines stand, and what is read of them.
struct TextTable {
    TextBlocks blocks;
    TextFormat format;
    TextColumns columns;
    std::int64_t header_lines = 0;  // of those above the table, the ones that are not blank
    std::int64_t footer_lines = 0;  // of those behind it
    bool may_repeat = false;        // the time of the row before, as in logs
};

// Finds the first line below those that `format` skips, and the last one before those that stand
// behind the table (is_behind_table()). Errors: file_read_failed, format_limit.
Result<TextTable> find_table(std::shared_ptr<const FileBytes> file, const TextFormat& format,
                             const TextColumns& columns);

}  // namespace vybeg
