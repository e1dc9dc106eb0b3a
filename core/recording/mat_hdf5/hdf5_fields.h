#pragma once

#include "core/base/result.h"
#include "core/recording/mat_hdf5/hdf5_handle.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vybeg {

// A field of the records that a table (PyTables, pandas) consists of: a number, or a vector of
// numbers.
struct Hdf5Field {
    std::string name;
    std::int64_t width = 1;  // numbers
    bool is_vector = false;
    int bits = 0;
    bool is_float = false;
};

// The fields of a compound type that hold real numbers; others are passed over.
std::vector<Hdf5Field> number_fields(hid_t type);

// Number `channel` of a field from the record `first` on. False where that fails.
bool read_field(hid_t dataset, const Hdf5Field& field, std::int64_t channel, std::int64_t first,
                std::span<double> out);

}  // namespace vybeg
