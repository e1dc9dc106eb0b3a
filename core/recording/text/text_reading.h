#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/sample_source.h"
#include "core/recording/text/text_lines.h"
#include "core/recording/times/time_grid.h"
#include "core/recording/times/uniform_times.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace vybeg {

// What the rows of a table, or of a part of it, leave out.
struct LeftOut {
    std::int64_t lines_ignored = 0;      // comment lines
    std::int64_t missing_samples = 0;    // empty, NaN and infinite ones, of both channels
    std::int64_t rows_with_missing = 0;  // rows that have one or two of them
    std::int64_t first_missing_row = -1;
    std::array<std::int64_t, 2> over_range{};  // of the missing samples, those of C and of D
    bool ends_within_row = false;              // the file, which leaves that row out
};

// Findings of one pass over a table, without its numbers.
struct TextScan {
    std::vector<std::int64_t> first_rows{0};  // of each block, then the number of rows
    LeftOut left_out;
    double first_time = 0;          // in the time column's unit
    TimeResolution resolution;      // of the time column
    std::optional<EvenTimes> even;  // nothing where there is no time column, or an uneven one

    std::int64_t rows() const { return first_rows.back(); }
};

// Reads every wanted number once, the blocks spread over threads. The first fault of the file is
// the error: text_not_a_number, text_segments, text_time_backwards, format_limit, file_read_failed;
// interrupted.
Result<TextScan> scan_text(const TextTable& table, const JobControl& job);

// The samples of a table on demand: only the places of its rows are kept in memory. Large reads are
// spread over threads. Where the times have gaps, their frames are NaN. Precondition: the table has
// no time column, or scan.even.
std::shared_ptr<const SampleSource> text_source(const TextTable& table, const TextScan& scan);

// Appends rows of a block until `samples` has `most`; false at a fault.
bool append_rows(const TextTable& table, const TextBlock& block, std::size_t most,
                 TimedSamples& samples);

// The whole table in memory, with its times. Errors: file_read_failed, interrupted.
Result<TimedSamples> read_timed_rows(const TextTable& table, const TextScan& scan,
                                     const JobControl& job);

}  // namespace vybeg
