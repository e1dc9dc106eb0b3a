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

// True where the first bytes of a file are those of a NumPy array (NPY).
bool is_npy(std::string_view head);

// What the header of a NumPy array says (format 1.0, 2.0 and 3.0). A scalar has no shape, a vector
// one number, a matrix two; of a matrix the shorter axis counts the channels, and of a square one
// or an empty one the second.
struct NpyArray {
    NumberType type = NumberType::f64;
    bool big_endian = false;
    bool fortran_order = false;
    std::vector<std::int64_t> shape;
    std::int64_t data_offset = 0;  // bytes from the start of the array's file

    std::int64_t frames() const;
    std::int64_t channels() const;
    std::string text() const;  // e.g. "64 bit float, little endian, C order"
};

// Reads the header. `name` says what the array is in messages, e.g. "NPY". Errors about `file`:
// format_damaged; format_unsupported for other data types than numbers of NumberType and for more
// than two dimensions or 4096 channels.
Result<NpyArray> read_npy_header(const FileBytes& file, const ByteSource& bytes,
                                 const std::string& name);

// Where the samples of a channel (from 0) stand: those that lie inside of the bytes, which may be
// fewer than the header promises.
SampleColumn npy_column(const NpyArray& array, std::shared_ptr<const ByteSource> bytes,
                        std::int64_t channel);

}  // namespace vybeg
