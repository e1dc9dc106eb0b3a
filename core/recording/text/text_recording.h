#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "core/recording/text/text_lines.h"

#include <memory>

namespace vybeg {

// A text file as a recording: finds the format, by options.text and its content, and looks at every
// row once; the samples are then read on demand. Only uneven times are read into memory, to bring
// them onto a uniform grid. Channels with times of their own are a pair (pair_channels()), and a
// rate above the table that contradicts the times is refused (rates_differ), unless options.rate_hz
// says which of the two holds. Errors: those of find_text_format(), too_few_channels,
// channel_out_of_range, too_few_frames, rate_unknown and those of scan_text().
Result<Recording> open_text(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job);

// Whether a rate that a header states, perhaps rounded, is one known to that relative deviation.
bool same_written_rate(double stated_hz, double hz, double relative_sd);

// The table of the chosen channels, which exist, with C's time. Errors: format_unsupported where C
// and D have different rates; those of find_table().
Result<TextTable> table_for(const std::shared_ptr<const FileBytes>& file, TextFormat format,
                            const OpenOptions& options);

// The table that open_text() reads, before its rows are looked at.
Result<TextTable> choose_table(const std::shared_ptr<const FileBytes>& file,
                               const OpenOptions& options, const JobControl& job);

}  // namespace vybeg
