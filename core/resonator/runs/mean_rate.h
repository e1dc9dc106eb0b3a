#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// A number over time, one value a window, with the standard deviations of the windows' own noise.
struct RateSeries {
    std::vector<double> time_s;
    std::vector<double> value;
    std::vector<double> sd;
    // Number of the part that a value belongs to, from 0 on, not falling; each part has an unknown
    // constant of its own. Empty: one part.
    std::vector<std::size_t> part{};
    // Variance of what noise adds to all values from this one on; empty: nothing adds up.
    std::vector<double> step_variance{};
};

struct MeanRate {
    double value = 0;  // per s
    double sd = 0;
};

// The smooth trend of a series: a parabola, and the parts' constants, by weighted least squares.
// Its values at the series' times. Precondition: at least eight values.
std::vector<double> trend_of(const RateSeries& series);

// Slopes of the straight lines of least squares through series of one motion, weights 1/sd^2, and
// their deviations: a line's coefficients applied to the covariance I + a K of the values in units
// of their sd, K that of a Lorentz line of half width w (exp(-2 pi w lag), averaged over blocks of
// windows). The likelihood of a and w is that of what the trend leaves, restricted to it, w from
// 0.28/T by factors of two; the deviation is the mean over the likelihood. Noise about the carrier
// is common to all series: series that show little by themselves add to the likelihood of the
// others. a is zero where the logarithm rises by less than 3. The slope of a bent motion is the
// mean of its rate; what a straight line does not follow of it counts as noise, or a parabola where
// the bend is beyond eight deviations of white noise. `inflation` multiplies
// the variances of means over many windows (noise that is correlated from window to window).
// Precondition: at least eight values each, times rise.
std::vector<MeanRate> mean_rates(std::span<const RateSeries> series, double inflation);

}  // namespace vybeg
