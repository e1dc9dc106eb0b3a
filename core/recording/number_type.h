#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace vybeg {

// The numbers that binary files are made of.
enum class NumberType { i8, u8, i16, u16, i24, i32, u32, i64, u64, f16, f32, f64 };

int bytes_of(NumberType type);
std::string name_of(NumberType type);  // e.g. "16 bit integer"

// Samples are gain * number + offset.
struct Scale {
    double gain = 1;
    double offset = 0;

    bool is_one() const { return *this == Scale{}; }

    friend bool operator==(const Scale&, const Scale&) = default;
};

// Fills `out` with the scaled numbers that stand `stride` bytes apart from `bytes` on, wherever
// they are aligned. Integers beyond 2^53 are rounded; what is NaN or infinite, also once it is
// scaled, becomes NaN.
void decode(NumberType type, bool big_endian, const char* bytes, std::int64_t stride,
            const Scale& scale, std::span<double> out);

// The same for two columns that stand side by side without anything between them: the numbers of
// `left`, as many as `right` has, are each followed by one of `right`.
void decode_pairs(NumberType type, bool big_endian, const char* bytes, const Scale& scale,
                  std::span<double> left, std::span<double> right);

}  // namespace vybeg
