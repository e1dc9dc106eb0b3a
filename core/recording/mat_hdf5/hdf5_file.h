#pragma once

#include "core/base/result.h"
#include "core/recording/variables/reader_protocol.h"

#include <memory>
#include <span>
#include <string>

namespace vybeg {

// A file that libhdf5 reads, inside vybeg-reader only: a damaged file may crash the library, make
// it hang or take memory up to the process's limit.
//
// Errors of all of it: format_damaged, format_unsupported, without a place.
class HelperFile {
public:
    HelperFile() = default;
    HelperFile(const HelperFile&) = delete;
    HelperFile& operator=(const HelperFile&) = delete;
    virtual ~HelperFile() = default;

    virtual const Catalogue& catalogue() const = 0;

    // Precondition: fits(request, catalogue()), and `out` has request.count places.
    virtual Status read(const SampleRequest& request, std::span<double> out) = 0;
};

enum class Naming { hdf5, matlab };  // "/run/C" or "run.C"

// An HDF5 file, through libhdf5: datasets of one or two dimensions in any group, and the fields of
// tables of records. One that is still being written (SWMR), or was never closed, is read as far as
// it is there. External links, soft links and samples in other files are not followed; no plug-in
// is loaded.
Result<std::unique_ptr<HelperFile>> open_hdf5_file(const std::string& path, Naming naming);

}  // namespace vybeg
