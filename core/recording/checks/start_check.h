#pragma once

#include <span>
#include <vector>

namespace vybeg {

// What the first seconds of a recording show besides the wave (METHOD section 7).

struct MainsLine {
    double f_hz = 0;
    double ratio = 0;  // its amplitude relative to the largest line above 200 Hz, the carrier, the
                       // powers of both channels summed
};

// Lines at 50, 100, 150, 60, 120, 180 and, of an aircraft's supply, 400 and 800 Hz in up to four
// seconds of samples that stand eight times above the median of what is around them and above 1e-3
// of the carrier; those above 200 Hz 20 Hz from it at least. A missing sample counts as zero.
// Nothing where the samples are too short for a resolution of 5 Hz.
std::vector<MainsLine> mains_lines(std::span<const double> c, std::span<const double> d,
                                   double rate_hz);

// Seconds from the start until the power of both channels, less that of the noise, falls as it does
// over the second half of the samples, in steps of a 64th of their length. 0 where it does so from
// the start, and where nothing can be said: the decay is no exponential (beats), or there are fewer
// than 4096 samples.
double start_transient_s(std::span<const double> c, std::span<const double> d, double f0_hz,
                         double rate_hz);

}  // namespace vybeg
