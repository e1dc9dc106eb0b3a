#pragma once

#include "core/base/diagnostic.h"
#include "core/base/result.h"
#include "core/recording/times/uniform_times.h"

#include <span>
#include <string>
#include <vector>

namespace vybeg {

// Samples with a time for each, strictly rising but for what its digits leave open.
struct TimedSamples {
    std::vector<double> time_s;
    std::vector<double> c;
    std::vector<double> d;
    TimeResolution resolution;
};

struct UniformSamples {
    double rate_hz = 0;
    double rate_relative_sd = 0;  // standard deviation of rate_hz relative to it
    std::vector<double> c;        // NaN where samples are missing
    std::vector<double> d;
    std::vector<Diagnostic> diagnostics;  // time_uneven, time_gap
};

// One time_gap for each; from the 20th gap on, one for all.
void report_gaps(std::span<const FrameRange> gaps, double rate_hz,
                 std::vector<Diagnostic>& diagnostics);

// out[i] = value at start + i step of the polynomial through the (up to) 4 points (nodes, values)
// round it, two on either side; at the ends, through the 4 outermost. The nodes rise and may be
// uneven; between even nodes h apart the error of a sinusoid of amplitude 1 is at most
// 3/128 (2 pi f h)^4. A NaN value makes NaN of every point that it takes part in.
// Precondition: one node or more.
void interpolate_cubic(std::span<const double> nodes, std::span<const double> values, double start,
                       double step, std::span<double> out);

// The samples on a uniform grid from the first time on (METHOD section 3). The rate is that of the
// straight line of least squares through the times between gaps. Where no time lies further from
// the grid than a thousandth of a sample plus what its digits leave open, the samples are taken as
// they are; else they are interpolated by a cubic through the 4 nearest of their times
// (time_uneven). A step of more than 1.5 median steps is a gap: its frames are NaN (time_gap; from
// the 20th gap on, one diagnostic for all).
//
// Precondition: two samples or more. Errors, about `where`: format_limit, where the gaps are so
// long that the grid would be absurdly larger than the file.
Result<UniformSamples> to_uniform_grid(const TimedSamples& samples, const std::string& where);

}  // namespace vybeg
