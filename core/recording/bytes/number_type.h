#pragma once

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

}  // namespace vybeg
