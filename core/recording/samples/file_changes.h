#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/recording.h"

#include <string>

namespace vybeg {

// SHA-256 of what a recording's samples come from, which its path need not name any more. Errors:
// those of file_sha256(); file_changed.
Result<std::string> recording_sha256(const Recording& recording, const JobControl& job);

// Whether the file still is what was opened, size and time of its last change: to be asked after
// its samples were read. Errors: file_changed, file_read_failed.
Status unchanged(const Recording& recording);

}  // namespace vybeg
