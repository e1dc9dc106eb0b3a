#include "core/base/dispatch.h"
#include "core/recording/bytes/number_type.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

// Not VYBEG_DISPATCHED, which lets multiplication and addition be fused.
#define VYBEG_EACH_PROCESSOR VYBEG_TARGETS("default", "avx2", "avx512f")

namespace vybeg {
namespace {

static_assert(std::endian::native == std::endian::little);

// Above this gain an integer of 32 bits could become infinite.
constexpr double largest_gain = 1e290;

using Bytes16 = std::int8_t __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));

template <class Number>
inline Number native_number(const char* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return number;
}

// NaN where it is NaN or infinite: value - value is 0 otherwise.
inline double present(double value) {
    return value - (value - value);
}

// 24 bits at the top of 32.
inline std::int32_t at_top(const char* bytes) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes, 3);
    return static_cast<std::int32_t>(number << 8);
}

VYBEG_EACH_PROCESSOR void split_i16(const char* bytes, Scale scale, double* __restrict left,
                                    double* __restrict right, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const auto both = native_number<std::uint32_t>(bytes + 4 * i);
        left[i] = scale.gain * static_cast<std::int16_t>(both) + scale.offset;
        right[i] = scale.gain * (static_cast<std::int32_t>(both) >> 16) + scale.offset;
    }
}

VYBEG_EACH_PROCESSOR void split_i24(const char* bytes, Scale scale, double* __restrict left,
                                    double* __restrict right, std::size_t count) {
    const double gain = scale.gain / 256;
    const Bytes16 zero{};
    std::size_t i = 0;
    // Four frames are 24 bytes: the first two in 16 of them, the others in 16 that end with them.
    for (; i + 4 <= count; i += 4) {
        const auto a = native_number<Bytes16>(bytes + 6 * i);
        const auto b = native_number<Bytes16>(bytes + 6 * i + 8);
        const auto first = std::bit_cast<Int4>(
            __builtin_shufflevector(a, zero, 16, 0, 1, 2, 16, 6, 7, 8, 16, 3, 4, 5, 16, 9, 10, 11));
        const auto second = std::bit_cast<Int4>(__builtin_shufflevector(
            b, zero, 16, 4, 5, 6, 16, 10, 11, 12, 16, 7, 8, 9, 16, 13, 14, 15));
        const Int4 l = __builtin_shufflevector(first, second, 0, 1, 4, 5);
        const Int4 r = __builtin_shufflevector(first, second, 2, 3, 6, 7);
        const Double4 scaled_l = __builtin_convertvector(l, Double4) * gain + scale.offset;
        const Double4 scaled_r = __builtin_convertvector(r, Double4) * gain + scale.offset;
        std::memcpy(left + i, &scaled_l, sizeof scaled_l);
        std::memcpy(right + i, &scaled_r, sizeof scaled_r);
    }
    for (; i < count; ++i) {
        left[i] = gain * at_top(bytes + 6 * i) + scale.offset;
        right[i] = gain * at_top(bytes + 6 * i + 3) + scale.offset;
    }
}

VYBEG_EACH_PROCESSOR void split_i32(const char* bytes, Scale scale, double* __restrict left,
                                    double* __restrict right, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        left[i] = scale.gain * native_number<std::int32_t>(bytes + 8 * i) + scale.offset;
        right[i] = scale.gain * native_number<std::int32_t>(bytes + 8 * i + 4) + scale.offset;
    }
}

template <class Float>
__attribute__((always_inline)) inline void split_floats(const char* bytes, Scale scale,
                                                        double* __restrict left,
                                                        double* __restrict right,
                                                        std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double l = native_number<Float>(bytes + 2 * sizeof(Float) * i);
        const double r = native_number<Float>(bytes + 2 * sizeof(Float) * i + sizeof(Float));
        left[i] = present(scale.gain * l + scale.offset);
        right[i] = present(scale.gain * r + scale.offset);
    }
}

VYBEG_EACH_PROCESSOR void split_f32(const char* bytes, Scale scale, double* __restrict left,
                                    double* __restrict right, std::size_t count) {
    split_floats<float>(bytes, scale, left, right, count);
}

VYBEG_EACH_PROCESSOR void split_f64(const char* bytes, Scale scale, double* __restrict left,
                                    double* __restrict right, std::size_t count) {
    split_floats<double>(bytes, scale, left, right, count);
}

}  // namespace

bool split_pairs(NumberType type, const char* bytes, const Scale& scale, std::span<double> left,
                 std::span<double> right) {
    const bool stays_finite =
        std::abs(scale.gain) <= largest_gain && std::abs(scale.offset) <= largest_gain;
    const auto split = [&](auto function) {
        function(bytes, scale, left.data(), right.data(), left.size());
        return true;
    };
    switch (type) {
        case NumberType::i16: return stays_finite && split(split_i16);
        case NumberType::i24: return stays_finite && split(split_i24);
        case NumberType::i32: return stays_finite && split(split_i32);
        case NumberType::f32: return split(split_f32);
        case NumberType::f64: return split(split_f64);
        default: return false;
    }
}

}  // namespace vybeg
