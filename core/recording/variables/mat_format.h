#pragma once

#include "core/recording/bytes/byte_order.h"
#include "core/recording/bytes/number_type.h"

#include <cstdint>
#include <optional>
#include <string_view>

// MAT files of level 4 and 5, as MathWorks, "MAT-File Format", describes them.
namespace vybeg {

// The header that stands before every variable of a MAT file of level 4.
struct Mat4Header {
    std::int64_t rows = 0;
    std::int64_t columns = 0;
    std::int64_t name_bytes = 0;  // with the zero at its end
    std::int64_t data_bytes = 0;
    NumberType type = NumberType::f64;  // as the numbers are stored
    bool big_endian = false;
    bool is_complex = false;
    bool is_full = false;  // an array of numbers; else a text or a sparse matrix
};

inline constexpr int mat4_header_bytes = 20;

// Nothing where the bytes are fewer or cannot be such a header: level 4 has no signature, and most
// combinations of its five numbers are impossible.
std::optional<Mat4Header> mat4_header(std::string_view bytes);

// Whether a file of `size` bytes that begins with `head` is one of level 4: a possible header, a
// name that is one, and an array that the file has room for, at least a part of it.
bool is_mat4(std::string_view head, std::int64_t size);

bool is_mat5(std::string_view head);

namespace mat5 {

inline constexpr std::int64_t header_bytes = 128;
inline constexpr std::int64_t tag_bytes = 8;

// Types of elements (table 1-1) besides those of number_type().
enum ElementType : std::uint32_t {
    int8 = 1,
    uint16 = 4,
    int32 = 5,
    uint32 = 6,
    float64 = 9,
    matrix = 14,
    compressed = 15,
    utf8 = 16,
    utf16 = 17
};

// Classes of arrays (table 1-3) besides those of class_type().
enum ArrayClass : std::uint32_t {
    cell_class = 1,
    struct_class = 2,
    char_class = 4,
    double_class = 6
};
inline constexpr std::uint32_t class_mask = 0xFF;
inline constexpr std::uint32_t logical_flag = 0x200;
inline constexpr std::uint32_t complex_flag = 0x800;

// A piece of a level 5 file: tag and bytes.
struct Element {
    std::uint32_t type = 0;
    std::int64_t data = 0;  // where its bytes begin
    std::int64_t size = 0;
    std::int64_t next = 0;  // where the element behind it begins

    std::int64_t end() const { return data + size; }
};

// The element whose tag, of tag_bytes, stands at `at`. Up to four bytes may stand in the tag
// itself; what is compressed is not padded.
Element element_of(std::string_view tag, std::int64_t at, bool big_endian);

// Of an element; nothing where it holds no numbers.
std::optional<NumberType> number_type(std::uint32_t element_type);

// That the numbers of a class have in MATLAB; a file may store them narrower. Nothing where it is
// no class of numbers.
std::optional<NumberType> class_type(std::uint32_t array_class);

}  // namespace mat5

}  // namespace vybeg
