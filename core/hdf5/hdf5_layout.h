#pragma once

#include <cstdint>
#include <string>
#include <vector>

// Where the arrays of an HDF5 file lie, and everything in the file that is not theirs. The function
// is in a library of its own, the only part of the programs that is linked with libhdf5: what needs
// it loads it. Both are of one build.
namespace vybeg {

struct Hdf5Array {
    std::string name;
    std::int64_t rows = 0;
    std::int64_t bytes = 0;       // of all rows
    std::int64_t text_bytes = 0;  // of each row's text, in UTF-8; 0: float64
    std::string unit{};           // attribute of the dataset; empty: none
};

struct Hdf5Layout {
    std::string bytes;                 // of the file from its start, without those of the arrays
    std::vector<std::int64_t> places;  // of each array; no meaning for one without rows
    std::int64_t size = 0;             // of the whole file
};

// The layout of a file whose root group has the attribute `program` and these arrays, one after
// the other in their order. False where libhdf5 fails. Not for two threads at once.
using Hdf5LayoutFunction = bool (*)(const std::string& program,
                                    const std::vector<Hdf5Array>& arrays, Hdf5Layout& layout);

inline constexpr const char* hdf5_layout_library = "vybeg-hdf5.so";
inline constexpr const char* hdf5_layout_function = "vybeg_hdf5_layout";

}  // namespace vybeg
