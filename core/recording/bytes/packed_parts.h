#pragma once

#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

inline constexpr std::int64_t best_ratio = 1032;  // that deflate can pack

// The unpacked bytes, inflated on demand and not stored. Reading forwards continues after the last
// read; reading backwards begins at one of at most 72 stored states (3 MB together), at most a 64th
// of the size plus 2 MiB away. Precondition: the file has the packed bytes. Errors of its reads:
// format_damaged, also at the end of bytes whose checksum is wrong.
std::shared_ptr<const ByteSource> inflated_part(std::shared_ptr<const FileBytes> file,
                                                DeflatedPart part);

// Whether the first bytes of a file are those of a ZIP archive.
bool is_zip(std::string_view head);

// A file in a ZIP archive, from the directory of the archive.
struct ZipMember {
    std::string name;
    int method = 0;  // of packing: 0 stored, 8 deflated
    bool encrypted = false;
    std::uint32_t crc32 = 0;
    std::int64_t packed_size = 0;
    std::int64_t size = 0;
    std::int64_t header_offset = 0;  // of its own header, in the archive
};

// The members in the directory's order (ZIP and ZIP64), without folders. Errors: file_read_failed;
// format_damaged without a directory (truncated archive) or with one outside the file;
// format_limit for more than 10000 members.
Result<std::vector<ZipMember>> zip_members(const FileBytes& file);

// Content of a member: stored members in place, deflated members inflated on demand. Errors:
// file_read_failed; format_damaged; format_unsupported for encrypted members and other methods.
Result<std::shared_ptr<const ByteSource>> zip_content(std::shared_ptr<const FileBytes> file,
                                                      const ZipMember& member);

// The same as a file without a name, whose path is that of the archive.
Result<std::shared_ptr<const FileBytes>> zip_file(std::shared_ptr<const FileBytes> file,
                                                  const ZipMember& member);

}  // namespace vybeg
