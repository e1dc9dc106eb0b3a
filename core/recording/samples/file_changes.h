#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/recording.h"

#include <string>

namespace vybeg {

// SHA-256 of the open file of a recording, independent of its path; of several files, of their
// bytes one after the other, as `cat C D | sha256sum`. Errors: those of files_sha256();
// file_changed.
Result<std::string> recording_sha256(const Recording& recording, const JobControl& job);

// Checks that sizes and modification times are those at the time of opening. Call it after reading
// the samples. Errors: file_changed, file_read_failed.
Status unchanged(const Recording& recording);

}  // namespace vybeg
