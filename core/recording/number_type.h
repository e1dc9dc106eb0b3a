#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace vybeg {

// The numbers that binary files are made of.
enum class NumberType { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

int bytes_of(NumberType type);
std::string name_of(NumberType type);  // e.g. "16 bit integer"

// Fills `out` with the numbers that stand `stride` bytes apart from `bytes` on, wherever they are
// aligned. Integers beyond 2^53 are rounded; NaN and infinite numbers become NaN.
void decode(NumberType type, bool big_endian, const char* bytes, std::int64_t stride,
            std::span<double> out);

}  // namespace vybeg
