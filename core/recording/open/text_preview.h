#pragma once

#include "core/base/job_control.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/open/recording_preview.h"

#include <memory>

namespace vybeg {

// Fills `preview` with what the beginning of a text file becomes under options.text. Errors:
// file_read_failed, interrupted; whatever is wrong with the text is preview.problem.
Status preview_text(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                    const JobControl& job, RecordingPreview& preview);

}  // namespace vybeg
