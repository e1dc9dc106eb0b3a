#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

namespace vybeg {

// Number types of binary files.
enum class NumberType { i8, u8, i16, u16, i24, i32, u32, i64, u64, f16, f32, f64 };

int bytes_of(NumberType type);
std::string name_of(NumberType type);  // e.g. "16 bit integer" (context "Format")

// Samples are gain * number + offset.
struct Scale {
    double gain = 1;
    double offset = 0;

    bool is_one() const { return *this == Scale{}; }

    friend bool operator==(const Scale&, const Scale&) = default;
};

// Fills `out` with the scaled numbers from `bytes` on, `stride` bytes apart, for any alignment.
// Integers beyond 2^53 are rounded; NaN and infinite values, also after scaling, become NaN.
void decode(NumberType type, bool big_endian, const char* bytes, std::int64_t stride,
            const Scale& scale, std::span<double> out);

// The same for two interleaved columns: each number of `left` is followed by one of `right`.
// Precondition: equal lengths.
void decode_pairs(NumberType type, bool big_endian, const char* bytes, const Scale& scale,
                  std::span<double> left, std::span<double> right);

// decode_pairs() of little endian numbers with the widest registers of the processor. Returns false
// without effect for rare types and for gains near the end of the range. The bits of the samples
// are the same on all processors.
bool split_pairs(NumberType type, const char* bytes, const Scale& scale, std::span<double> left,
                 std::span<double> right);

// Number at `bytes` in the given byte order, for any alignment.
template <class Number>
Number load(const char* bytes, bool big_endian) {
    std::array<char, sizeof(Number)> copy;
    std::memcpy(copy.data(), bytes, copy.size());
    if (big_endian != (std::endian::native == std::endian::big)) {
        std::reverse(copy.begin(), copy.end());
    }
    return std::bit_cast<Number>(copy);
}

// The bytes of a number in the given byte order.
template <class Number>
std::string store(Number number, bool big_endian) {
    auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (big_endian != (std::endian::native == std::endian::big)) {
        std::reverse(bytes.begin(), bytes.end());
    }
    return {bytes.begin(), bytes.end()};
}

}  // namespace vybeg
