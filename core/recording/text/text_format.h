#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "core/recording/text/text_columns.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vybeg {

// Guesses the format from the first lines of a file: the separator and decimal sign under which
// most of them are rows of numbers of the same length, at least two. Nothing where there is no such
// row. Time and other columns without samples are those of find_columns(). `choice` takes
// precedence over guesses; its time column counts where the table has it.
std::optional<TextFormat> guess_text_format(std::span<const std::string> lines,
                                            const TextChoice& choice = {});

// The channels of the file by name, numbers from 1 where it has none, and unit.
std::vector<Channel> channels_of(const TextFormat& format);

// E.g. "text, 3 columns, semicolon, decimal comma".
RecordingFormat format_of(const TextFormat& format);

// The first lines of a text file, from which its format is found: 256 KiB after the lines that are
// skipped, and the last ones of those.
struct TextHead {
    std::int64_t dropped = 0;  // lines of the file above these
    std::vector<std::string> lines;
};

// Errors: file_read_failed; format_limit where a line is longer than 1 MiB; interrupted.
Result<TextHead> read_text_head(std::shared_ptr<const FileBytes> file,
                                std::optional<std::int64_t> lines_to_skip, const JobControl& job);

// The format of a file with this head: what `choice` says and, for the rest, guess_text_format().
// Errors: text_thousands, text_decimal_commas, format_unsupported (too many columns), text_no_data;
// text_no_table, text_lines_missing, column_out_of_range where the choice
// does not fit the file.
Result<TextFormat> find_text_format(const FileBytes& file, const TextHead& head,
                                    const TextChoice& choice);

}  // namespace vybeg
