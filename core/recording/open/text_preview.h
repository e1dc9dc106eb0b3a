#pragma once

#include "core/base/job_control.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/open/recording_preview.h"

#include <memory>

namespace vybeg {

// Fills `preview` from the beginning of a text file under options.text. Errors: file_read_failed,
// interrupted; faults of the text are in preview.problem.
Status preview_text(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                    const JobControl& job, RecordingPreview& preview);

}  // namespace vybeg
