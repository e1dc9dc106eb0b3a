#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "core/recording/variables/variable_reader.h"

#include <cstdint>
#include <memory>

namespace vybeg {

// A file of several variables (MAT, HDF5, NPZ), whatever reads them.
struct VariableFile {
    std::shared_ptr<const FileBytes> file;
    Catalogue catalogue;
    std::shared_ptr<const VariableReader> reader;
};

// The recording that choose_variables() finds in the file. Where the rate comes from times that are
// not even, it is read whole and brought onto a uniform grid, as a text is. A file that is still
// being written, or was never closed, gets the diagnostic file_not_closed. Errors: those of
// choose_variables() and the reader; channel_out_of_range, too_few_frames, rate_unknown,
// interrupted.
Result<Recording> open_variables(const VariableFile& from, const OpenOptions& options,
                                 const JobControl& job);

}  // namespace vybeg
