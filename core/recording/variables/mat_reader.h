#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/arrays/npy_reader.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <memory>
#include <vector>

namespace vybeg {

// The arrays of real numbers in a MAT file of level 4 or 5 and, by "name.field", in its single
// structs, read on demand: plain ones in place, compressed ones inflated on the way. Which of them
// is what: open_variables(). Errors: format_damaged, also where a size does not fit the numbers
// that are there; holds_log where Moku's converter wrote it of a phasemeter or a lock-in; those of
// open_variables(); interrupted.
Result<Recording> open_mat(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& job);

// The columns of the table in a file of Moku's converter, whose struct `moku` names them; none: it
// is another file. Errors: those of open_mat() about the file.
Result<std::vector<NamedColumn>> moku_columns(const std::shared_ptr<const FileBytes>& file,
                                              const JobControl& job);

}  // namespace vybeg
