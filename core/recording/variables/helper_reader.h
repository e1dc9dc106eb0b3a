#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "core/recording/variables/variable_reader.h"

#include <memory>
#include <optional>
#include <string_view>

namespace vybeg {

// The format of a MAT (4, 5, 7.3) or HDF5 file whose first bytes are `head`; nothing where it is
// none. HDF5's signature may also stand at 512, 1024, 2048, ... Level 4 of MAT has no signature:
// other binary formats are to be asked for first.
std::optional<LibraryFormat> library_format(std::string_view head, const FileBytes& file);

// A MAT or HDF5 file, read on demand: level 4 and 5 of MAT in place, the others by vybeg-reader.
// Errors: those of open_mat(), open_variables() and ReaderProcess.
Result<Recording> open_with_library(std::shared_ptr<const FileBytes> file,
                                    const LibraryFormat& format, const OpenOptions& options,
                                    const JobControl& job);

}  // namespace vybeg
