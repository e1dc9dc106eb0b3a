#pragma once

#include <cmath>

namespace vybeg {

// Fractional turns of a frequency up to a frame (whole or half), exact to rounding for any length:
// the product is reduced by whole turns, which is exact, with its own rounding error carried.
inline double turns_at(double frame, double f_hz, double rate_hz) {
    const double product = frame * f_hz;
    const double lost = std::fma(frame, f_hz, -product);
    return (std::remainder(product, rate_hz) + lost) / rate_hz;
}

}  // namespace vybeg
