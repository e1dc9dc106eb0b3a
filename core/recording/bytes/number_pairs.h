#pragma once

#include "core/recording/bytes/number_type.h"

#include <span>

namespace vybeg {

// decode_pairs() of little endian numbers with the widest registers of the processor. Returns false
// without effect for rare types and for gains near the end of the range. The bits of the samples
// are the same on all processors.
bool split_pairs(NumberType type, const char* bytes, const Scale& scale, std::span<double> left,
                 std::span<double> right);

}  // namespace vybeg
