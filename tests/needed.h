#pragma once

#include "core/base/result.h"

#include <cstdio>
#include <cstdlib>

namespace vybeg::test {

// What must succeed for a test or a benchmark to make sense: an error is printed and ends the
// program.
inline void needed(const Status& status) {
    if (!status) {
        std::fprintf(stderr, "%s\n", english(status.error()).c_str());
        std::abort();
    }
}

// With its value.
template <class Value>
Value needed(Result<Value> result) {
    needed(result ? Status() : Status(result.error()));
    return std::move(*result);
}

}  // namespace vybeg::test
