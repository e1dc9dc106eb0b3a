#pragma once

#include <span>

namespace vybeg {

// out[i] = value at start + i step of the polynomial through the (up to) 4 points (nodes, values)
// round it, two on either side; at the ends, through the 4 outermost. The nodes rise and may be
// uneven; between even nodes h apart the error of a sinusoid of amplitude 1 is at most
// 3/128 (2 pi f h)^4. A NaN value makes NaN of every point that it takes part in.
// Precondition: one node or more.
void interpolate_cubic(std::span<const double> nodes, std::span<const double> values, double start,
                       double step, std::span<double> out);

}  // namespace vybeg
