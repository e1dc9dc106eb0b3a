#pragma once

#include <vector>

namespace vybeg {

// The value in the middle by size, of an even number of values the larger of the two in the middle;
// NaN of none.
double median(std::vector<double> values);

}  // namespace vybeg
