#pragma once

#include "core/recording/mat_hdf5/hdf5_handle.h"

#include <optional>
#include <string>

namespace vybeg {

// What the attributes of a group or dataset tell about its samples.
struct Hdf5Attributes {
    std::optional<double> rate_hz;  // by rate_by_name()
    std::string unit;               // "unit" or "units"
    bool scaled = false;            // by "scale_factor" or "add_offset" of netCDF
    std::string matlab_class;       // "MATLAB_class": "double", "char", ...
    bool matlab_empty = false;      // "MATLAB_empty": the dataset holds a size, not samples
};

Hdf5Attributes read_attributes(hid_t object);

}  // namespace vybeg
