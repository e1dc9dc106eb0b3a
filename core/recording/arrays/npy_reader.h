#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/column_source.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// Whether the first bytes of a file are those of a NumPy array (NPY).
bool is_npy(std::string_view head);

// Places a matrix of numbers, which lie row after row or column after column. Its shorter axis
// counts the channels; of a square or an empty one it is the second.
void set_matrix(std::int64_t rows, std::int64_t columns, bool by_columns, NumberArray& array);

// Header of a NumPy array (format 1.0, 2.0 and 3.0) of two dimensions at most.
struct NpyArray : NumberArray {
    bool fortran_order = false;
};

// Reads the header. `name`: name of the array in messages, e.g. "NPY". Errors about `file`:
// format_damaged; format_unsupported for other data types than numbers of NumberType and for more
// than two dimensions or 4096 channels.
Result<NpyArray> read_npy_header(const FileBytes& file, const ByteSource& bytes,
                                 const std::string& name);

// A column of a table of numbers.
struct NamedColumn {
    Channel heading;  // without a name where the file has none
    SampleColumn column;
};

// All columns of a NumPy array. Moku's converter writes no names: those of its phasemeter, a time
// and five columns for each input, follow from their number and from the length of its header,
// which is none of NumPy's. Errors: those of read_npy_header().
Result<std::vector<NamedColumn>> npy_columns(const std::shared_ptr<const FileBytes>& file);

// A NumPy array (NPY, is_npy()) of shape (n, channels) or (channels, n), read on demand; the rate
// is the option's. A file shorter than its header states opens with the diagnostic file_ends_early.
// Errors: format_damaged, format_unsupported, too_few_channels, channel_out_of_range,
// too_few_frames, rate_unknown; holds_log where the columns are those of a phasemeter.
Result<Recording> open_npy(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& job);

}  // namespace vybeg
