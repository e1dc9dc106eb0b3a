#pragma once

#include "core/recording/bytes/number_type.h"

#include <cstdint>
#include <span>

namespace vybeg {

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
