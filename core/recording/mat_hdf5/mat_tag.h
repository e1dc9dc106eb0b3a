#pragma once

#include "core/recording/bytes/byte_order.h"

#include <cstdint>
#include <string_view>

namespace vybeg::mat5 {

inline constexpr std::int64_t header_bytes = 128;
inline constexpr std::int64_t tag_bytes = 8;

// Codes of the format.
enum ElementType : std::uint32_t { matrix_type = 14, compressed_type = 15 };
enum ArrayClass : std::uint32_t {
    cell_class = 1,
    struct_class = 2,
    first_number = 6,
    last_number = 15
};

// A piece of a level 5 file: tag and bytes.
struct Element {
    std::uint32_t type = 0;
    std::int64_t data = 0;  // where its bytes begin
    std::int64_t size = 0;
    std::int64_t next = 0;  // where the element behind it begins
};

// The element whose tag, of tag_bytes, stands at `at`. Up to four bytes may stand in the tag
// itself; what is compressed is not padded.
inline Element element_of(std::string_view tag, std::int64_t at, bool big_endian) {
    const auto type = load<std::uint32_t>(tag.data(), big_endian);
    if (type >> 16 != 0) {
        return {type & 0xFFFF, at + 4, type >> 16, at + tag_bytes};
    }
    const std::int64_t size = load<std::uint32_t>(tag.data() + 4, big_endian);
    const std::int64_t padding = type == compressed_type ? 0 : (8 - size % 8) % 8;
    return {type, at + tag_bytes, size, at + tag_bytes + size + padding};
}

}  // namespace vybeg::mat5
