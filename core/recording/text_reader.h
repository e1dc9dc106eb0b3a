#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/file_bytes.h"
#include "core/recording/text_format.h"
#include "core/recording/time_grid.h"

#include <cstdint>
#include <memory>

namespace vybeg {

// The columns of a text file that are wanted, row by row.
struct TextTable {
    TimedSamples rows;                   // no times where the format has no time column
    std::int64_t lines_ignored = 0;      // header and comment lines that told nothing
    std::int64_t missing_samples = 0;    // empty, NaN and infinite ones, of both channels
    std::int64_t rows_with_missing = 0;  // rows that have one or two of them
    std::int64_t first_missing_row = -1;
};

// Reads the table by `format`, the columns column_c and column_d (from 0) as C and D. An empty
// field is a missing sample; a last line that is cut off is left out. Errors: text_not_a_number,
// text_time_backwards, file_read_failed, format_damaged, interrupted.
Result<TextTable> read_text_table(std::shared_ptr<const FileBytes> file, const TextFormat& format,
                                  int column_c, int column_d, const JobControl& job);

}  // namespace vybeg
