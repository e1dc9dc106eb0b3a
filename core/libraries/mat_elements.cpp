#include "core/libraries/mat_elements.h"

#include "core/recording/byte_order.h"
#include "core/recording/mat_header.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>

namespace vybeg {
namespace {

constexpr std::int64_t level5_header_bytes = 128;
constexpr std::int64_t tag_bytes = 8;

// The bytes at `at`, fewer at the end of the file.
template <std::size_t n>
std::string_view bytes_at(std::ifstream& file, std::int64_t at, std::array<char, n>& buffer) {
    file.clear();
    file.seekg(at);
    file.read(buffer.data(), n);
    return {buffer.data(), static_cast<std::size_t>(file.gcount())};
}

bool is_level5(std::string_view head) {
    return head.starts_with("MATLAB 5.0");
}

// Where the element at `at` ends; nothing where there is no element.
std::optional<std::int64_t> level5_end(std::ifstream& file, std::int64_t at, bool big_endian) {
    std::array<char, tag_bytes> buffer{};
    const std::string_view tag = bytes_at(file, at, buffer);
    if (tag.size() < tag_bytes) {
        return {};
    }
    return at + tag_bytes + load<std::uint32_t>(tag.data() + 4, big_endian);
}

std::optional<std::int64_t> level4_end(std::ifstream& file, std::int64_t at) {
    std::array<char, mat4_header_bytes> buffer{};
    const auto header = mat4_header(bytes_at(file, at, buffer));
    return header ? std::optional(at + mat4_header_bytes + header->name_bytes + header->data_bytes)
                  : std::nullopt;
}

}  // namespace

std::string mat_damage(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const std::int64_t size = file.tellg();
    std::array<char, level5_header_bytes> buffer{};
    const std::string_view head = bytes_at(file, 0, buffer);
    const bool level5 = is_level5(head);
    if (level5 && static_cast<std::int64_t>(head.size()) < level5_header_bytes) {
        return "it ends in its header";
    }
    const bool big_endian = level5 && head[126] == 'M';
    for (std::int64_t at = level5 ? level5_header_bytes : 0; at < size;) {
        const auto end = level5 ? level5_end(file, at, big_endian) : level4_end(file, at);
        if (!end) {
            return "there is no variable at byte " + std::to_string(at);
        }
        if (*end > size) {
            return "it ends at byte " + std::to_string(size) + ", inside of a variable";
        }
        at = *end;
    }
    return {};
}

}  // namespace vybeg
