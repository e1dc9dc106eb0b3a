#pragma once

#include "core/recording/bytes/file_bytes.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace vybeg {

// A deflated part of a file: position, size and properties of its content.
struct DeflatedPart {
    std::int64_t offset = 0;
    std::int64_t packed_size = 0;
    std::int64_t size = 0;               // unpacked
    std::optional<std::uint32_t> crc32;  // of the unpacked bytes, if known
    std::string format;                  // name of the part, for messages
    std::string name;
};

// The unpacked bytes, inflated on demand and not stored. Reading forwards continues after the last
// read; reading backwards begins at one of at most 72 stored states (3 MB together), at most a 64th
// of the size plus 2 MiB away. Precondition: the file has the packed bytes. Errors of its reads:
// format_damaged, also at the end of bytes whose checksum is wrong.
std::shared_ptr<const ByteSource> inflated_part(std::shared_ptr<const FileBytes> file,
                                                DeflatedPart part);

}  // namespace vybeg
