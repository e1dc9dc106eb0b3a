#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/column_source.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "core/recording/variables/reader_protocol.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vybeg {

// An array of numbers in a file of several, which can be read in place or on the way of unpacking.
// Of an unsupported one only `variable` counts. Precondition: the content has all of its numbers.
struct StoredArray {
    FileVariable variable;
    NumberArray array;  // the places of its numbers in the content
    // With a decoder of its own, where it is packed.
    std::function<Result<std::shared_ptr<const ByteSource>>()> content;
};

// The recording that open_variables() finds among a file's arrays; `format` names it. Errors: those
// of open_variables() and of the contents.
Result<Recording> open_arrays(const FileBytes& file, const std::string& format,
                              std::vector<StoredArray> arrays, const OpenOptions& options,
                              const JobControl& job);

// The NumPy arrays in a ZIP archive (NPZ), read on demand: stored ones in place, deflated ones
// inflated on the way. Which of them is what: open_variables(). Errors: those of zip_members(),
// zip_content(), read_npy_header() and open_variables(); format_unsupported, where there are no
// arrays in it.
Result<Recording> open_npz(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& job);

}  // namespace vybeg
