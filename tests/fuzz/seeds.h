#pragma once

#include <string>
#include <vector>

namespace vybeg::fuzz {

// Sound small files of a format, to be damaged: "wav", "audio", "text", "npy", "npz", "uff",
// "tdms", "zetlab", "raw", "mat", "mat73", "hdf5"; "any" of the formats that the content shows; and
// one of 3000 groups in each other, "bottomless". Those of NumPy, SciPy and h5py are written by
// Python.
std::vector<std::string> sound_files(const std::string& format);

}  // namespace vybeg::fuzz
