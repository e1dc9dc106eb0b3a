#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace vybeg::test {

// The largest of some numbers, NaN where one of them is. std::max() passes over NaN, so that a
// worst difference collected with it would hide results that are no numbers.
inline double largest_of(std::initializer_list<double> numbers) {
    return std::ranges::any_of(numbers, [](double x) { return std::isnan(x); })
               ? std::numeric_limits<double>::quiet_NaN()
               : std::max(numbers);
}

}  // namespace vybeg::test
