#pragma once

#include <array>
#include <span>
#include <vector>

namespace vybeg {

// Findings of the first seconds of a recording besides the wave (METHOD section 7).

// Supplies whose lines are looked for: the mains, and an aircraft's.
inline constexpr std::array<double, 3> supplies_hz{50, 60, 400};

struct MainsLine {
    double f_hz = 0;
    double ratio = 0;  // its amplitude relative to the largest line above 200 Hz, the carrier, the
                       // powers of both channels summed
};

// Lines at 50, 100, 150, 60, 120, 180 and, of an aircraft's supply, 400 and 800 Hz in up to four
// seconds of samples, eight times above the median around them and above 1e-3 of the carrier; those
// above 200 Hz at least 20 Hz from it. A missing sample counts as zero. Empty if the samples are
// too short for a resolution of 5 Hz.
std::vector<MainsLine> mains_lines(std::span<const double> c, std::span<const double> d,
                                   double rate_hz);

// Seconds from the start until the power of both channels, less that of the noise, decays as in the
// second half of the samples, in steps of a 64th of their length. 0 without a transient, where the
// power changes smoothly all the way (a beat behind channels of different gain), and where the
// check is inconclusive: no exponential decay, or fewer than 4096 samples.
double start_transient_s(std::span<const double> c, std::span<const double> d, double f0_hz,
                         double rate_hz);

}  // namespace vybeg
