#pragma once

#include "core/base/result.h"
#include "core/recording/variables/reader_protocol.h"

#include <memory>

namespace vybeg {

enum class Naming { hdf5, matlab };  // "/run/C" or "run.C"

// The HDF5 file at a descriptor, through libhdf5: datasets of one or two dimensions in any group,
// and the fields of tables of records. One that is still being written (SWMR), or was never closed,
// is read as far as it is there. External links, soft links and samples in other files are not
// followed; no plug-in is loaded.
Result<std::unique_ptr<HelperFile>> open_hdf5_file(int descriptor, Naming naming);

}  // namespace vybeg
