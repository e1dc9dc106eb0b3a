#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/open/recording_preview.h"
#include "core/recording/samples/open_options.h"

#include <filesystem>

namespace vybeg {

// Reads the beginning of a text or raw file alone, whatever its size; other files are opened. The
// samples are those that open_recording() gives, but for uneven times, which are left as they are.
// Errors: those of a file that cannot be read whatever the options; setting_invalid, interrupted.
Result<RecordingPreview> preview_recording(const std::filesystem::path& path,
                                           const OpenOptions& options, const JobControl& job);

}  // namespace vybeg
