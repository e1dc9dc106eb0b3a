#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <filesystem>

namespace vybeg {

// Opens a recording by its content, never by its name. Texts from the file are converted by
// plain_text(). Text files are read completely (progress and cancellation through `job`); samples
// are read on demand. Errors: every ErrorCode of the input group, setting_invalid, interrupted.
Result<Recording> open_recording(const std::filesystem::path& path, const OpenOptions& options,
                                 const JobControl& job);

}  // namespace vybeg
