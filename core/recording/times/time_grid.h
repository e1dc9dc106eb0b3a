#pragma once

#include "core/base/diagnostic.h"
#include "core/base/result.h"

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vybeg {

// How finely a column of times is written: no time is known better than to the coarser of decimals
// and digits. Times that were 32 bit floats before have been rounded twice.
struct TimeResolution {
    double absolute_s = 0;        // one unit of the last decimal that any of them has
    int significant_digits = 17;  // the most that any of them has
    double single_unit_s = 0;     // unit (s) in which all of them were 32 bit floats; 0: in none

    double at(double time_s) const;  // seconds
};

// Whether a 32 bit float lies within `half_digit` of the number, which is a float's where the digit
// is 0.
inline bool is_single(double number, double half_digit) {
    constexpr double ties = 1 + 1e-6;  // a float halfway between two texts, and its parsing
    constexpr double parsing = 1.2e-16;
    const double apart = std::abs(number - static_cast<double>(static_cast<float>(number)));
    return apart <= half_digit * ties + parsing * std::abs(number);
}

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

// How far a time may lie from a grid of the given step and still be even, s: a thousandth of a step
// plus what its digits leave open.
double allowed_deviation(double step_s, const TimeResolution& resolution, double time_s);

// The longest step from one time to the next that rounding may make of the given step, s.
double longest_rounded_step(double step_s, const TimeResolution& resolution, double time_s);

// False where the gaps between so many rows are so long that a grid of so many frames would be
// absurdly larger than the file.
bool is_plausible_grid(double frames, double rows);

// The slope of times (s) between their gaps, s per row. Precondition: two times or more.
double typical_step(const TimedSamples& samples);

// The frames between `before` and `after` are missing.
struct TimeGap {
    std::int64_t before;
    std::int64_t after;
};

// One time_gap for each; from the 20th gap on, one for all.
void report_gaps(std::span<const TimeGap> gaps, double rate_hz,
                 std::vector<Diagnostic>& diagnostics);

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
