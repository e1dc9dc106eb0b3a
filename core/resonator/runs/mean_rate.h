#pragma once

#include "core/base/job_control.h"
#include "core/resonator/model/reason.h"

#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// A number over time, one value per window, with the standard deviations of the windows' noise.
struct RateSeries {
    std::vector<double> time_s;
    std::vector<double> value;
    std::vector<double> sd;
    // Part of each value, from 0 on, not falling; each part has its own unknown constant. Empty:
    // one part.
    std::vector<std::size_t> part{};
    // Variance of the noise added to all values from this one on; empty: none.
    std::vector<double> step_variance{};
};

// Smooth trend of a series at its times: a parabola and the constants of the parts, by weighted
// least squares. Precondition: at least eight values.
std::vector<double> trend_of(const RateSeries& series);

// Slopes, per s, of the straight lines of least squares through series of one motion, weights
// 1/sd^2, and their deviations: a line's coefficients applied to the covariance I + a K of the
// values in units of their sd, K that of a Lorentz line of half width w (exp(-2 pi w lag), averaged
// over blocks of windows). The likelihood of a and w is the restricted one of the residual of the
// trend, w from 0.28/T by factors of two; the deviation is the mean over the likelihood. Noise
// about the carrier is common to all series, so series with little evidence add to the likelihood
// of the others. a is zero if the logarithm rises by less than 3. The slope of a curved motion is
// the mean of its rate; its deviation from a straight line counts as noise, its deviation from a
// parabola if the curvature exceeds eight deviations of white noise. `inflation` multiplies the
// variances of means over many windows (noise that is correlated from window to window).
// Precondition: at least eight values each, times rise. A cancelled job ends the search for
// coloured noise early.
std::vector<Estimate> mean_rates(std::span<const RateSeries> series, double inflation,
                                 const JobControl& job);

// The same slopes without their deviations.
std::vector<Estimate> mean_slopes(std::span<const RateSeries> series);

}  // namespace vybeg
