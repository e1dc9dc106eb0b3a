#pragma once

#include "core/analysis/settings.h"

#include <cstdint>
#include <vector>

namespace vybeg {

// What a band-pass makes of white noise in the means of windows at a carrier.
struct FilteredNoise {
    // Variance of a window's mean, in units of that which white noise of the density at the carrier
    // gives it: h times the integral over frequency v from the carrier of |H(v)|^2 sinc^2(v h), H
    // relative to the carrier, h the window.
    double variance = 1;
    // Correlation of the means of windows 0, 1, 2, ... window lengths apart, from 1 at lag 0, up to
    // the last one above 1e-3: the same integral with cos(2 pi v h lag). The part that turns, from
    // a carrier beside the band's middle, is left out.
    std::vector<double> correlation;
};

// Precondition: 0 < band.low_hz <= f_hz <= band.high_hz < rate_hz / 2.
FilteredNoise filtered_noise(const Band& band, double f_hz, std::int64_t window, double rate_hz);

}  // namespace vybeg
