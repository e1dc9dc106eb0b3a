#pragma once

#include "core/recording/bytes/number_type.h"

#include <span>

namespace vybeg {

// decode_pairs() of little endian numbers with the widest registers that the processor has; false,
// and nothing done, for the types that recordings seldom have and for gains near the end of the
// range. The bits of the samples are the same everywhere.
bool split_pairs(NumberType type, const char* bytes, const Scale& scale, std::span<double> left,
                 std::span<double> right);

}  // namespace vybeg
