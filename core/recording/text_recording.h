#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/file_bytes.h"
#include "core/recording/open_recording.h"

#include <memory>

namespace vybeg {

// A text file as a recording: guesses the format, reads the table, brings it onto a uniform grid.
// Errors: text_no_data, too_few_channels, channel_out_of_range, too_few_frames, rate_unknown and
// those of read_text_table().
Result<Recording> open_text(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job);

}  // namespace vybeg
