#include "core/recording/bytes/number_type.h"

#include "core/base/error.h"
#include "core/base/message_arg.h"

namespace vybeg {
namespace {

struct NumberKind {
    int bytes;
    const char* name;
};

// In the order of NumberType.
constexpr std::array<NumberKind, 12> number_kinds{{
    {1, VYBEG_MESSAGE("Format", "8 bit integer")},
    {1, VYBEG_MESSAGE("Format", "8 bit unsigned integer")},
    {2, VYBEG_MESSAGE("Format", "16 bit integer")},
    {2, VYBEG_MESSAGE("Format", "16 bit unsigned integer")},
    {3, VYBEG_MESSAGE("Format", "24 bit integer")},
    {4, VYBEG_MESSAGE("Format", "32 bit integer")},
    {4, VYBEG_MESSAGE("Format", "32 bit unsigned integer")},
    {8, VYBEG_MESSAGE("Format", "64 bit integer")},
    {8, VYBEG_MESSAGE("Format", "64 bit unsigned integer")},
    {2, VYBEG_MESSAGE("Format", "16 bit float")},
    {4, VYBEG_MESSAGE("Format", "32 bit float")},
    {8, VYBEG_MESSAGE("Format", "64 bit float")},
}};

// A number, and the scaled number. value - value is 0, or NaN where the value is NaN or infinite:
// no branch, twice the speed.
template <class Number, bool big_endian>
double plain_sample(const char* bytes) {
    const auto value = static_cast<double>(load<Number>(bytes, big_endian));
    return value - (value - value);
}

template <class Number, bool big_endian>
double scaled_sample(const char* bytes, const Scale& scale) {
    const double value =
        scale.gain * static_cast<double>(load<Number>(bytes, big_endian)) + scale.offset;
    return value - (value - value);
}

// 24 bits as in WAV files.
struct Int24 {
    std::array<unsigned char, 3> low_first;

    explicit operator double() const {
        const auto at_top = static_cast<std::uint32_t>(low_first[0]) << 8 |
                            static_cast<std::uint32_t>(low_first[1]) << 16 |
                            static_cast<std::uint32_t>(low_first[2]) << 24;
        return static_cast<std::int32_t>(at_top) / 256.0;
    }
};

// 16 bits of IEEE 754: a sign, five bits of exponent, ten of fraction. GCC 12 has no such type in
// C++.
struct Half {
    std::uint16_t bits;

    explicit operator double() const {
        const std::uint64_t sign = std::uint64_t{bits} >> 15 << 63;
        const std::uint64_t exponent = bits >> 10 & 0x1F;
        const std::uint64_t fraction = bits & 0x3FF;
        if (exponent == 0) {
            const double small = static_cast<double>(fraction) * 0x1p-24;
            return sign != 0 ? -small : small;
        }
        const std::uint64_t wide = exponent == 0x1F ? 0x7FF : exponent + 1023 - 15;
        return std::bit_cast<double>(sign | wide << 52 | fraction << 42);
    }
};

// Calls loop(sample, width): sample(place) is the scaled number there. Type, byte order and whether
// there is a scale are constant within the loop, which is then as fast as memory.
template <class Loop>
void with_sample(NumberType type, bool big_endian, const Scale& scale, Loop loop) {
    const auto with_order = [&]<class Number, bool order>() {
        constexpr std::integral_constant<std::size_t, sizeof(Number)> width;
        if (scale.is_one()) {
            loop([](const char* at) { return plain_sample<Number, order>(at); }, width);
        } else {
            loop([scale](const char* at) { return scaled_sample<Number, order>(at, scale); },
                 width);
        }
    };
    const auto with = [&]<class Number>(Number) {
        if (big_endian) {
            with_order.template operator()<Number, true>();
        } else {
            with_order.template operator()<Number, false>();
        }
    };
    switch (type) {
        case NumberType::i8: return with(std::int8_t());
        case NumberType::u8: return with(std::uint8_t());
        case NumberType::i16: return with(std::int16_t());
        case NumberType::u16: return with(std::uint16_t());
        case NumberType::i24: return with(Int24());
        case NumberType::i32: return with(std::int32_t());
        case NumberType::u32: return with(std::uint32_t());
        case NumberType::i64: return with(std::int64_t());
        case NumberType::u64: return with(std::uint64_t());
        case NumberType::f16: return with(Half());
        case NumberType::f32: return with(float());
        case NumberType::f64: return with(double());
    }
}

}  // namespace

int bytes_of(NumberType type) {
    return number_kinds.at(static_cast<std::size_t>(type)).bytes;
}

std::string name_of(NumberType type) {
    return number_kinds.at(static_cast<std::size_t>(type)).name;
}

void decode(NumberType type, bool big_endian, const char* bytes, std::int64_t stride,
            const Scale& scale, std::span<double> out) {
    with_sample(type, big_endian, scale, [&](auto sample, auto) {
        for (std::size_t i = 0; i < out.size(); ++i) {
            out[i] = sample(bytes + static_cast<std::int64_t>(i) * stride);
        }
    });
}

void decode_pairs(NumberType type, bool big_endian, const char* bytes, const Scale& scale,
                  std::span<double> left, std::span<double> right) {
    if (!big_endian && split_pairs(type, bytes, scale, left, right)) {
        return;
    }
    with_sample(type, big_endian, scale, [&](auto sample, auto width) {
        for (std::size_t i = 0; i < left.size(); ++i) {
            left[i] = sample(bytes + 2 * i * width);
            right[i] = sample(bytes + (2 * i + 1) * width);
        }
    });
}

}  // namespace vybeg
