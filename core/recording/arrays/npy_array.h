#pragma once

#include "core/recording/bytes/byte_source.h"
#include "core/recording/bytes/number_type.h"
#include "core/recording/samples/column_source.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vybeg {

// Whether the first bytes of a file are those of a NumPy array (NPY).
bool is_npy(std::string_view head);

// Header of a NumPy array (format 1.0, 2.0 and 3.0). A scalar has no shape, a vector one number, a
// matrix two. The shorter axis of a matrix counts the channels; for a square or an empty one it is
// the second.
struct NpyArray {
    NumberType type = NumberType::f64;
    bool big_endian = false;
    bool fortran_order = false;
    std::vector<std::int64_t> shape;
    std::int64_t data_offset = 0;  // bytes from the start of the array's file

    std::int64_t frames() const;
    std::int64_t channels() const;
};

// Reads the header. `name`: name of the array in messages, e.g. "NPY". Errors about `file`:
// format_damaged; format_unsupported for other data types than numbers of NumberType and for more
// than two dimensions or 4096 channels.
Result<NpyArray> read_npy_header(const FileBytes& file, const ByteSource& bytes,
                                 const std::string& name);

// Positions of the samples of a channel (from 0) within the bytes, possibly fewer than the header
// states.
SampleColumn npy_column(const NpyArray& array, std::shared_ptr<const ByteSource> bytes,
                        std::int64_t channel);

}  // namespace vybeg
