#include "core/recording/number_type.h"

#include "core/recording/byte_order.h"

#include <cmath>
#include <limits>
#include <type_traits>

namespace vybeg {
namespace {

template <class Number>
double sample(const char* bytes, bool big_endian) {
    const auto value = static_cast<double>(load<Number>(bytes, big_endian));
    if constexpr (std::is_floating_point_v<Number>) {
        return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
    }
    return value;
}

// The byte order is a constant inside of each loop, and so is the usual distance of two channels
// side by side: the loops are then as fast as memory.
template <class Number, bool big_endian>
void decode_as(const char* bytes, std::int64_t stride, std::span<double> out) {
    constexpr std::int64_t pair = 2 * sizeof(Number);
    const auto count = static_cast<std::int64_t>(out.size());
    if (stride == pair) {
        for (std::int64_t i = 0; i < count; ++i) {
            out[static_cast<std::size_t>(i)] = sample<Number>(bytes + i * pair, big_endian);
        }
        return;
    }
    for (std::int64_t i = 0; i < count; ++i) {
        out[static_cast<std::size_t>(i)] = sample<Number>(bytes + i * stride, big_endian);
    }
}

template <class Number>
void decode_as(bool big_endian, const char* bytes, std::int64_t stride, std::span<double> out) {
    if (big_endian) {
        decode_as<Number, true>(bytes, stride, out);
    } else {
        decode_as<Number, false>(bytes, stride, out);
    }
}

}  // namespace

int bytes_of(NumberType type) {
    switch (type) {
        case NumberType::i8:
        case NumberType::u8: return 1;
        case NumberType::i16:
        case NumberType::u16: return 2;
        case NumberType::i32:
        case NumberType::u32:
        case NumberType::f32: return 4;
        case NumberType::i64:
        case NumberType::u64:
        case NumberType::f64: return 8;
    }
    return 0;
}

std::string name_of(NumberType type) {
    const std::string bits = std::to_string(8 * bytes_of(type)) + " bit ";
    switch (type) {
        case NumberType::u8:
        case NumberType::u16:
        case NumberType::u32:
        case NumberType::u64: return bits + "unsigned integer";
        case NumberType::f32:
        case NumberType::f64: return bits + "float";
        default: return bits + "integer";
    }
}

void decode(NumberType type, bool big_endian, const char* bytes, std::int64_t stride,
            std::span<double> out) {
    switch (type) {
        case NumberType::i8: return decode_as<std::int8_t>(big_endian, bytes, stride, out);
        case NumberType::u8: return decode_as<std::uint8_t>(big_endian, bytes, stride, out);
        case NumberType::i16: return decode_as<std::int16_t>(big_endian, bytes, stride, out);
        case NumberType::u16: return decode_as<std::uint16_t>(big_endian, bytes, stride, out);
        case NumberType::i32: return decode_as<std::int32_t>(big_endian, bytes, stride, out);
        case NumberType::u32: return decode_as<std::uint32_t>(big_endian, bytes, stride, out);
        case NumberType::i64: return decode_as<std::int64_t>(big_endian, bytes, stride, out);
        case NumberType::u64: return decode_as<std::uint64_t>(big_endian, bytes, stride, out);
        case NumberType::f32: return decode_as<float>(big_endian, bytes, stride, out);
        case NumberType::f64: return decode_as<double>(big_endian, bytes, stride, out);
    }
}

}  // namespace vybeg
