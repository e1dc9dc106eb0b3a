#include "core/recording/text_reader.h"

#include "core/base/number_text.h"
#include "core/recording/text_encoding.h"
#include "core/recording/text_fields.h"
#include "core/recording/text_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

constexpr std::size_t longest_quote = 40;  // of a wrong field, in a message
constexpr std::int64_t rows_per_report = 1 << 14;

// A field as it may stand in a one-line message.
std::string quoted(std::string_view field) {
    std::string text = to_utf8(field.substr(0, longest_quote));
    if (field.size() > longest_quote) {
        text = to_utf8(field.substr(0, longest_quote)) + "...";
    }
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c >= 0 && c < ' '; }, ' ');
    return text;
}

// Reads the rows of one table, line by line.
class TableReader {
public:
    TableReader(const FileBytes& file, const TextFormat& format, int column_c, int column_d)
        : file_(file), format_(format), column_c_(column_c), column_d_(column_d) {}

    // `ended`: the line has a line end.
    Status take(std::string_view line, std::int64_t number, bool ended) {
        const bool header = number <= format_.lines_to_skip;
        if (trimmed(line).empty()) {
            return {};
        }
        if (header || is_comment(line, format_.delimiter)) {
            ++table_.lines_ignored;
            return {};
        }
        split_fields(line, format_.delimiter, fields_);
        const auto columns = static_cast<std::size_t>(format_.columns);
        if (fields_.size() < columns && !ended) {
            return {};  // the recorder stopped, or the copy was cut, within this line
        }
        if (fields_.size() > columns) {
            return not_a_number(number, format_.columns);
        }
        // Blanks cannot say which field is missing.
        if (fields_.size() < columns && format_.delimiter == ' ') {
            return not_a_number(number, static_cast<int>(fields_.size()));
        }
        if (format_.time_column >= 0) {
            if (const Status status = take_time(number); !status) {
                return status;
            }
        }
        return take_samples(number);
    }

    TextTable finish() {
        table_.lines_ignored =
            std::max<std::int64_t>(table_.lines_ignored - format_.header_lines_used, 0);
        const double last_decimal = std::pow(10.0, -decimals_) * format_.time_unit_s;
        table_.rows.resolution = {last_decimal, std::max(significant_, 1)};
        return std::move(table_);
    }

private:
    std::string_view field(int column) const {
        const auto i = static_cast<std::size_t>(column);
        return i < fields_.size() ? fields_[i] : std::string_view{};
    }

    Error not_a_number(std::int64_t line, int column) const {
        return file_.error(ErrorCode::text_not_a_number,
                           {integer_text(line), std::to_string(column + 1), quoted(field(column))});
    }

    Status take_time(std::int64_t line) {
        const std::string_view text = field(format_.time_column);
        const auto time = parse_field(text, format_.decimal_comma);
        if (!time || std::isnan(*time)) {
            return not_a_number(line, format_.time_column);
        }
        std::vector<double>& times = table_.rows.time_s;
        if (!times.empty() && !(*time > last_time_)) {
            return file_.error(
                ErrorCode::text_time_backwards,
                {integer_text(line), round_trip_text(*time), round_trip_text(last_time_)});
        }
        last_time_ = *time;
        times.push_back(*time * format_.time_unit_s);
        const NumberDigits digits = digits_of(text);
        decimals_ = times.size() == 1 ? digits.decimals : std::max(decimals_, digits.decimals);
        significant_ = std::max(significant_, digits.significant);
        return {};
    }

    Status take_samples(std::int64_t line) {
        const auto c = parse_field(field(column_c_), format_.decimal_comma);
        if (!c) {
            return not_a_number(line, column_c_);
        }
        const auto d = parse_field(field(column_d_), format_.decimal_comma);
        if (!d) {
            return not_a_number(line, column_d_);
        }
        const int missing = (std::isnan(*c) ? 1 : 0) + (std::isnan(*d) ? 1 : 0);
        if (missing > 0) {
            table_.missing_samples += missing;
            if (table_.rows_with_missing++ == 0) {
                table_.first_missing_row = static_cast<std::int64_t>(table_.rows.c.size());
            }
        }
        table_.rows.c.push_back(*c);
        table_.rows.d.push_back(*d);
        return {};
    }

    const FileBytes& file_;
    const TextFormat& format_;
    int column_c_;
    int column_d_;
    std::vector<std::string_view> fields_;
    double last_time_ = 0;
    int decimals_ = 0;
    int significant_ = 0;
    TextTable table_;
};

}  // namespace

Result<TextTable> read_text_table(std::shared_ptr<const FileBytes> file, const TextFormat& format,
                                  int column_c, int column_d, const JobControl& job) {
    TextLines lines(file);
    TableReader reader(*file, format, column_c, column_d);
    for (;;) {
        const auto line = lines.next();
        if (!line) {
            return line.error();
        }
        if (!*line) {
            return reader.finish();
        }
        if (const Status status = reader.take(**line, lines.number(), lines.ended()); !status) {
            return status.error();
        }
        if (lines.number() % rows_per_report == 0) {
            if (job.cancelled()) {
                return file->error(ErrorCode::interrupted);
            }
            job.report(lines.fraction());
        }
    }
}

}  // namespace vybeg
