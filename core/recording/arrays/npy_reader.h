#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <memory>

namespace vybeg {

// A NumPy array (NPY, is_npy()) of shape (n, channels) or (channels, n), read on demand; the rate
// is the option's. A file shorter than its header states opens with the diagnostic file_ends_early.
// Errors: format_damaged, format_unsupported, too_few_channels, channel_out_of_range,
// too_few_frames, rate_unknown.
Result<Recording> open_npy(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& job);

}  // namespace vybeg
