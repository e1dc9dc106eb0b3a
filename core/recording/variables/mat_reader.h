#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <memory>

namespace vybeg {

// The arrays of real numbers in a MAT file of level 4 or 5 and, by "name.field", in its single
// structs, read on demand: plain ones in place, compressed ones inflated on the way. Which of them
// is what: open_variables(). Errors: format_damaged, also where a size does not fit the numbers
// that are there; those of open_variables(); interrupted.
Result<Recording> open_mat(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& job);

}  // namespace vybeg
