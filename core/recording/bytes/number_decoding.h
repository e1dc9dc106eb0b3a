#pragma once

#include "core/recording/bytes/number_type.h"

#include <cstdint>
#include <span>

namespace vybeg {

// Fills `out` with the scaled numbers from `bytes` on, `stride` bytes apart, for any alignment.
// Integers beyond 2^53 are rounded; NaN and infinite values, also after scaling, become NaN.
void decode(NumberType type, bool big_endian, const char* bytes, std::int64_t stride,
            const Scale& scale, std::span<double> out);

// The same for two interleaved columns: each number of `left` is followed by one of `right`.
// Precondition: equal lengths.
void decode_pairs(NumberType type, bool big_endian, const char* bytes, const Scale& scale,
                  std::span<double> left, std::span<double> right);

}  // namespace vybeg
