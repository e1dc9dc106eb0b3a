#pragma once

#include "core/base/result.h"
#include "core/recording/variables/reader_protocol.h"

#include <cstdint>
#include <span>

namespace vybeg {

// A file that a library reads, inside vybeg-reader only: a damaged file may crash the library, make
// it hang or take memory up to the process's limit.
//
// Errors of all of it: format_damaged, format_unsupported, format_limit, without a place.
class HelperFile {
public:
    HelperFile() = default;
    HelperFile(const HelperFile&) = delete;
    HelperFile& operator=(const HelperFile&) = delete;
    virtual ~HelperFile() = default;

    virtual const Catalogue& catalogue() const = 0;

    // Bytes of memory that reading takes, beyond those of a file without large packed pieces.
    virtual std::int64_t memory_bytes() const { return 0; }

    // Precondition: fits(request, catalogue()), and `out` has request.count places.
    virtual Status read(const SampleRequest& request, std::span<double> out) = 0;
};

}  // namespace vybeg
