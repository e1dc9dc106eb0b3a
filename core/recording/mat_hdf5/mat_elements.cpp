#include "core/recording/mat_hdf5/mat_elements.h"

#include "core/recording/bytes/byte_order.h"
#include "core/recording/mat_hdf5/mat_tag.h"
#include "core/recording/variables/mat_header.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>

namespace vybeg {

using namespace mat5;

namespace {

constexpr int most_depth = 8;  // of structs in structs; what lies deeper is not looked at

// Bytes of a number by the code of its type; 0: no number.
constexpr std::array<std::int64_t, 14> bytes_by_type{0, 1, 1, 2, 2, 4, 4, 4, 0, 8, 0, 0, 8, 8};

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

class Level5 {
public:
    Level5(std::ifstream& file, bool big_endian) : file_(file), big_endian_(big_endian) {}

    // Nothing where the file has no tag there.
    std::optional<Element> element(std::int64_t at) const {
        std::array<char, tag_bytes> buffer{};
        const std::string_view tag = bytes_at(file_, at, buffer);
        return tag.size() < tag_bytes ? std::nullopt
                                      : std::optional(element_of(tag, at, big_endian_));
    }

    // Whether the numbers of an array, or of the arrays in it, are as many as its size says.
    bool numbers_fit(const Element& array, int depth) const {
        if (array.type != matrix_type || array.size == 0 || depth > most_depth) {
            return true;  // compressed: there zlib notices
        }
        const auto flags = element(array.data);
        const auto size = flags ? element(flags->next) : std::nullopt;
        const auto name = size ? element(size->next) : std::nullopt;
        if (!name) {
            return false;
        }
        const auto kind = number<std::uint32_t>(flags->data) & 0xFF;
        const std::int64_t end = array.data + array.size;
        if (kind == cell_class || kind == struct_class) {
            // A struct has the length of its fields' names, then the names, before the fields.
            const auto length = kind == struct_class ? element(name->next) : name;
            const auto names = kind == struct_class && length ? element(length->next) : length;
            return names && all_fit(names->next, end, depth);
        }
        if (kind < first_number || kind > last_number || size->size != 2 * sizeof(std::int32_t)) {
            return true;
        }
        const auto data = element(name->next);
        if (!data || data->type >= bytes_by_type.size() || data->data + data->size > end) {
            return false;
        }
        const std::int64_t rows = number<std::int32_t>(size->data);
        const std::int64_t columns = number<std::int32_t>(size->data + sizeof(std::int32_t));
        return rows >= 0 && columns >= 0 && rows < (std::int64_t{1} << 60) / (8 * columns + 1) &&
               rows * columns * bytes_by_type[data->type] == data->size;
    }

private:
    bool all_fit(std::int64_t at, std::int64_t end, int depth) const {
        while (at < end) {
            const auto inner = element(at);
            if (!inner || inner->next > end || !numbers_fit(*inner, depth + 1)) {
                return false;
            }
            at = inner->next;
        }
        return true;
    }

    template <class Number>
    Number number(std::int64_t at) const {
        std::array<char, sizeof(Number)> buffer{};
        bytes_at(file_, at, buffer);
        return load<Number>(buffer.data(), big_endian_);
    }

    std::ifstream& file_;
    bool big_endian_;
};

std::optional<std::int64_t> level4_end(std::ifstream& file, std::int64_t at) {
    std::array<char, mat4_header_bytes> buffer{};
    const auto header = mat4_header(bytes_at(file, at, buffer));
    return header ? std::optional(at + mat4_header_bytes + header->name_bytes + header->data_bytes)
                  : std::nullopt;
}

std::string level5_damage(std::ifstream& file, std::int64_t size, bool big_endian) {
    const Level5 level5(file, big_endian);
    for (std::int64_t at = header_bytes; at < size;) {
        const auto element = level5.element(at);
        // The last one need not be padded.
        if (!element || element->data + element->size > size) {
            return "it ends at byte " + std::to_string(size) + ", inside of a variable";
        }
        if (!level5.numbers_fit(*element, 0)) {
            return "the size of the variable at byte " + std::to_string(at) +
                   " does not fit its numbers";
        }
        at = element->next;
    }
    return {};
}

std::string level4_damage(std::ifstream& file, std::int64_t size) {
    for (std::int64_t at = 0; at < size;) {
        const auto end = level4_end(file, at);
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

}  // namespace

std::string mat_damage(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const std::int64_t size = file.tellg();
    std::array<char, header_bytes> buffer{};
    const std::string_view head = bytes_at(file, 0, buffer);
    if (!is_level5(head)) {
        return level4_damage(file, size);
    }
    if (size < header_bytes) {
        return "it ends in its header";
    }
    return level5_damage(file, size, head[header_bytes - 2] == 'M');
}

}  // namespace vybeg
