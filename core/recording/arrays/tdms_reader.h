#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <memory>
#include <string_view>

namespace vybeg {

// Whether the first bytes of a file are those of a TDMS file of National Instruments, or of its
// index file (.tdms_index).
bool is_tdms(std::string_view head);

// The numeric channels of a TDMS file without time names, in the order of their first appearance;
// read on demand through a table of segments, also raw data of DAQmx. The rate is 1 / wf_increment
// of C (otherwise of its group or the file), unit_string the unit, wf_start_time the start; the
// scales of tdms_scaling() are applied. Channels of different lengths get the diagnostic
// channels_unequal; a file that ends early file_ends_early; one with an unclosed last segment, or
// truncated within the head of a segment, file_not_closed. Errors: format_damaged;
// format_unsupported for scales other than linear and polynomial ones, an index alone and channels
// of different rates; too_few_channels, channel_out_of_range, too_few_frames, rate_unknown,
// interrupted.
Result<Recording> open_tdms(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job);

}  // namespace vybeg
