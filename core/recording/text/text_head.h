#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/text_choice.h"
#include "core/recording/text/text_format.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vybeg {

// The first lines of a text file, what its format is found from: 256 KiB behind the lines that are
// skipped, and of those the last ones.
struct TextHead {
    std::int64_t dropped = 0;  // lines of the file above these
    std::vector<std::string> lines;
};

// Errors: file_read_failed; format_limit where a line is longer than 1 MiB; interrupted.
Result<TextHead> read_text_head(std::shared_ptr<const FileBytes> file,
                                std::optional<std::int64_t> lines_to_skip, const JobControl& job);

// The format of a file with this head: what `choice` says and, for the rest, guess_text_format().
// Errors: text_no_data; text_no_table, text_lines_missing, column_out_of_range where the choice
// does not fit the file.
Result<TextFormat> find_text_format(const FileBytes& file, const TextHead& head,
                                    const TextChoice& choice);

}  // namespace vybeg
