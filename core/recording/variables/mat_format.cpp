#include "core/recording/variables/mat_format.h"

#include "core/base/plain_text.h"
#include "core/recording/samples/text_fields.h"

#include <algorithm>
#include <array>

namespace vybeg {
namespace {

constexpr std::int64_t most_name_bytes = 256;
constexpr std::array<NumberType, 6> types_by_precision{NumberType::f64, NumberType::f32,
                                                       NumberType::i32, NumberType::i16,
                                                       NumberType::u16, NumberType::u8};

bool is_name(std::string_view name) {
    return !name.empty() && is_letter(name.front()) &&
           std::all_of(name.begin(), name.end(),
                       [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
}

}  // namespace

std::optional<Mat4Header> mat4_header(std::string_view bytes) {
    if (bytes.size() < mat4_header_bytes) {
        return {};
    }
    // The type is MOPT in decimal: byte order, zero, precision, kind of matrix.
    const bool big_endian = load<std::int32_t>(bytes.data(), false) > 9999 ||
                            load<std::int32_t>(bytes.data(), false) < 0;
    std::array<std::int32_t, 5> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        numbers[i] = load<std::int32_t>(bytes.data() + 4 * i, big_endian);
    }
    const auto [type, rows, columns, complex, name_bytes] = numbers;
    if (type < 0 || type / 1000 != (big_endian ? 1 : 0) || type / 100 % 10 != 0 ||
        type / 10 % 10 >= static_cast<std::int32_t>(types_by_precision.size()) || type % 10 > 2) {
        return {};
    }
    if (rows < 0 || columns < 0 || complex < 0 || complex > 1 || name_bytes < 2 ||
        name_bytes > most_name_bytes) {
        return {};
    }
    const NumberType number = types_by_precision[static_cast<std::size_t>(type / 10 % 10)];
    // 2^31 rows, 2^31 columns and 16 bytes do not fit into 63 bits.
    if (columns > 0 && rows > (std::int64_t{1} << 50) / columns) {
        return {};
    }
    return Mat4Header{rows,         columns,
                      name_bytes,   std::int64_t{rows} * columns * bytes_of(number) * (1 + complex),
                      number,       big_endian,
                      complex == 1, type % 10 == 0};
}

bool is_mat4(std::string_view head, std::int64_t size) {
    const auto header = mat4_header(head);
    if (!header || header->rows == 0 || header->columns == 0) {
        return false;
    }
    const std::string_view name = head.substr(
        mat4_header_bytes,
        std::min(static_cast<std::size_t>(header->name_bytes), head.size() - mat4_header_bytes));
    return name.size() == static_cast<std::size_t>(header->name_bytes) && name.back() == '\0' &&
           is_name(name.substr(0, name.size() - 1)) &&
           size > mat4_header_bytes + header->name_bytes;
}

bool is_mat5(std::string_view head) {
    return head.starts_with("MATLAB 5.0 MAT-file");
}

namespace mat5 {

Element element_of(std::string_view tag, std::int64_t at, bool big_endian) {
    const auto type = load<std::uint32_t>(tag.data(), big_endian);
    if (type >> 16 != 0) {
        return {type & 0xFFFF, at + 4, type >> 16, at + tag_bytes};
    }
    const std::int64_t size = load<std::uint32_t>(tag.data() + 4, big_endian);
    const std::int64_t padding = type == compressed ? 0 : (8 - size % 8) % 8;
    return {type, at + tag_bytes, size, at + tag_bytes + size + padding};
}

std::optional<NumberType> number_type(std::uint32_t element_type) {
    switch (element_type) {
        case int8: return NumberType::i8;
        case 2: return NumberType::u8;
        case 3: return NumberType::i16;
        case uint16: return NumberType::u16;
        case int32: return NumberType::i32;
        case uint32: return NumberType::u32;
        case 7: return NumberType::f32;
        case float64: return NumberType::f64;
        case 12: return NumberType::i64;
        case 13: return NumberType::u64;
        default: return std::nullopt;
    }
}

std::optional<NumberType> class_type(std::uint32_t array_class) {
    constexpr std::array<NumberType, 10> types{
        NumberType::f64, NumberType::f32, NumberType::i8,  NumberType::u8,  NumberType::i16,
        NumberType::u16, NumberType::i32, NumberType::u32, NumberType::i64, NumberType::u64};
    const std::uint32_t place = array_class - double_class;  // of smaller ones a large number
    return place < types.size() ? std::optional(types[place]) : std::nullopt;
}

}  // namespace mat5

}  // namespace vybeg
