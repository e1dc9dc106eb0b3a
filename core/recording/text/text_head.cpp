#include "core/recording/text/text_head.h"

#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/open_table.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_columns.h"
#include "core/recording/text/text_lines.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <utility>

namespace vybeg {
namespace {

constexpr std::size_t head_bytes = std::size_t{1} << 18;  // kept on each side of the first row
constexpr std::int64_t lines_between_looks = 4096;        // at the stop token

// Lines, the oldest of which make room for the next.
class LastLines {
public:
    void add(std::string_view line) {
        lines_.emplace_back(line);
        bytes_ += line.size() + 1;
        while (bytes_ > head_bytes && lines_.size() > 1) {
            bytes_ -= lines_.front().size() + 1;
            lines_.pop_front();
            ++dropped_;
        }
    }

    TextHead take() {
        return {dropped_,
                {std::make_move_iterator(lines_.begin()), std::make_move_iterator(lines_.end())}};
    }

private:
    std::deque<std::string> lines_;
    std::size_t bytes_ = 0;
    std::int64_t dropped_ = 0;
};

// Why there is no table; the head has at least the lines that are skipped.
Error no_table(const FileBytes& file, const TextHead& head, const TextChoice& choice) {
    const std::string said = options_text({.text = choice});
    if (said.empty()) {
        return file.error(ErrorCode::text_no_data);
    }
    const auto begin = head.lines.begin() +
                       static_cast<std::ptrdiff_t>(choice.lines_to_skip.value_or(0) - head.dropped);
    auto line = std::find_if(begin, head.lines.end(),
                             [](const std::string& text) { return !trimmed(text).empty(); });
    line = line == head.lines.end() ? begin : line;
    const std::int64_t number = head.dropped + (line - head.lines.begin()) + 1;
    return file.error(ErrorCode::text_no_table, {said, count_arg(number), short_quote(*line)});
}

}  // namespace

Result<TextHead> read_text_head(std::shared_ptr<const FileBytes> file,
                                std::optional<std::int64_t> lines_to_skip, const JobControl& job) {
    TextLines lines(std::move(file));
    LastLines skipped;
    const std::int64_t skip = lines_to_skip.value_or(0);
    for (std::int64_t i = 0; i < skip; ++i) {
        if (i % lines_between_looks == 0 && job.cancelled()) {
            return Error{ErrorCode::interrupted, "", {}};
        }
        const auto line = TRY(lines.next());
        if (!line) {
            break;
        }
        skipped.add(*line);
    }
    TextHead head = skipped.take();
    for (std::size_t bytes = 0; bytes < head_bytes;) {
        const auto line = TRY(lines.next());
        if (!line) {
            break;
        }
        head.lines.emplace_back(*line);
        bytes += line->size() + 1;
    }
    return head;
}

Result<TextFormat> find_text_format(const FileBytes& file, const TextHead& head,
                                    const TextChoice& choice) {
    const std::int64_t count = head.dropped + std::ssize(head.lines);
    if (choice.lines_to_skip && *choice.lines_to_skip >= count) {
        return file.error(ErrorCode::text_lines_missing,
                          {count_arg(*choice.lines_to_skip), count_arg(count)});
    }
    TextChoice here = choice;
    if (here.lines_to_skip) {
        *here.lines_to_skip -= head.dropped;
    }
    auto format = guess_text_format(head.lines, here);
    if (!format) {
        return no_table(file, head, choice);
    }
    if (format->columns > most_columns) {
        return file.error(
            ErrorCode::format_unsupported,
            {"text", words(VYBEG_MESSAGE(
                               "Words", "rows of %1 numbers (a column is a channel, a row a time)"),
                           {count_arg(format->columns)})});
    }
    if (!choice.delimiter && has_decimal_commas(head.lines, *format)) {
        return file.error(
            ErrorCode::text_decimal_commas,
            {short_quote(head.lines[static_cast<std::size_t>(format->lines_to_skip)])});
    }
    format->lines_to_skip += head.dropped;
    if (choice.time_column && *choice.time_column > format->columns) {
        return file.error(ErrorCode::column_out_of_range,
                          {count_arg(*choice.time_column), count_arg(format->columns)});
    }
    return std::move(*format);
}

}  // namespace vybeg
