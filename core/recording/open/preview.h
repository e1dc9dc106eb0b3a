#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/open/recording_preview.h"
#include "core/recording/samples/open_options.h"

#include <filesystem>

namespace vybeg {

// Reads only the beginning of a text or raw file; opens other files. The samples equal those of
// open_recording(), except that uneven times are not resampled. Errors: those of a file that no
// options can open; setting_invalid, interrupted.
Result<RecordingPreview> preview_recording(const std::filesystem::path& path,
                                           const OpenOptions& options, const JobControl& job);

}  // namespace vybeg
