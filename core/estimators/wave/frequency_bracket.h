#pragma once

#include <cstdint>

namespace vybeg {

// Where a window's frequency is looked for, radians per sample: the main lobe about the carrier,
// |f - f0| < rate / n, as far as the window can tell cos from sin there.
struct FrequencyBracket {
    double low = 0;
    double centre = 0;
    double high = 0;

    bool contains(double w) const { return w > low && w < high; }
};

FrequencyBracket main_lobe(double f0_hz, double rate_hz, std::int64_t n);

}  // namespace vybeg
