#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <memory>

namespace vybeg {

// The NumPy arrays in a ZIP archive (NPZ), read on demand: stored ones in place, deflated ones
// inflated on the way. Which of them is what: open_variables(). Errors: those of zip_members(),
// zip_content(), read_npy_header() and open_variables(); format_unsupported, where there are no
// arrays in it.
Result<Recording> open_npz(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& job);

}  // namespace vybeg
