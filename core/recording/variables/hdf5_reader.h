#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <memory>
#include <string_view>

namespace vybeg {

// Whether a file with these first bytes is of HDF5, as MATLAB's are from level 7.3 on. The
// signature may also stand at 512, 1024, 2048, ...
bool is_hdf5(std::string_view head, const FileBytes& file);

// A MAT 7.3 or HDF5 file, read on demand by vybeg-reader. Errors: those of open_variables() and
// ReaderProcess.
Result<Recording> open_hdf5(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job);

}  // namespace vybeg
