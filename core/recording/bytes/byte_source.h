#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"

#include <cstdint>
#include <memory>
#include <span>

namespace vybeg {

// Bytes with random access: part of a file, or unpacked from it. Immutable; may be read from
// several threads at once.
class ByteSource {
public:
    ByteSource() = default;
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;
    virtual ~ByteSource() = default;

    virtual std::int64_t size() const = 0;

    // Whether bytes can be read without reading those before them.
    virtual bool seeks() const { return true; }

    // Fills `out` with the bytes from `offset` on. Precondition: they lie in [0, size()). Errors:
    // file_read_failed, format_damaged.
    virtual Status read(std::int64_t offset, std::span<char> out) const = 0;
};

// The bytes [offset, offset + size) of a file. Precondition: the file has them.
std::shared_ptr<const ByteSource> file_part(std::shared_ptr<const FileBytes> file,
                                            std::int64_t offset, std::int64_t size);

}  // namespace vybeg
