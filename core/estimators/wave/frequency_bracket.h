#pragma once

#include <cstdint>

namespace vybeg {

// Search range of a window's frequency, radians per sample: the main lobe about the carrier, |f -
// f0| < rate / n, limited to frequencies at which cos and sin are distinct in the window.
struct FrequencyBracket {
    double low = 0;
    double centre = 0;
    double high = 0;

    bool contains(double w) const { return w > low && w < high; }
};

FrequencyBracket main_lobe(double f0_hz, double rate_hz, std::int64_t n);

}  // namespace vybeg
