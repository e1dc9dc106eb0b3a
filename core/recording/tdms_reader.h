#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/file_bytes.h"
#include "core/recording/open_recording.h"

#include <memory>
#include <string_view>

namespace vybeg {

// True where the first bytes of a file are those of a TDMS file of National Instruments, or of the
// index that lies beside one (.tdms_index).
bool is_tdms(std::string_view head);

// The channels of a TDMS file that hold numbers and are not named as times, in the order of their
// first appearance; read on demand through a table of segments. The rate is 1 / wf_increment of C
// (else of its group or the file), unit_string the unit, wf_start_time the start; one linear scale
// of data that are not yet scaled is applied. A file that ends early, or whose last segment was
// never closed, opens with the diagnostic file_ends_early and what is there. Errors:
// format_damaged; format_unsupported for DAQmx raw data, other scales, an index alone and channels
// of different rates; too_few_channels, channel_out_of_range, too_few_frames, rate_unknown,
// interrupted.
Result<Recording> open_tdms(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job);

}  // namespace vybeg
