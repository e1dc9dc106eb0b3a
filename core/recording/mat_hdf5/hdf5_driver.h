#pragma once

#include "core/recording/mat_hdf5/hdf5_handle.h"

namespace vybeg {

// A driver of libhdf5 that reads the open file `descriptor`, whatever name H5Fopen() is given. The
// library's own drivers open their file by its name, which vybeg-reader may not do. Sets it as the
// driver of the file access property list; false where the library refuses.
bool read_descriptor(hid_t access, int descriptor);

}  // namespace vybeg
