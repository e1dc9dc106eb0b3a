#pragma once

#include <vector>

namespace vybeg {

// A number over time, one value a window, with the standard deviations of the windows' own noise.
struct RateSeries {
    std::vector<double> time_s;
    std::vector<double> value;
    std::vector<double> sd;
};

struct MeanRate {
    double value = 0;  // per s
    double sd = 0;
};

// The smooth trend of a series: a polynomial of fourth order (of lower order below 16 values) by
// weighted least squares. Its values at the series' times. Precondition: at least eight values.
std::vector<double> trend_of(const RateSeries& series);

// Slope of the straight line of least squares, weights 1/sd^2, and its deviation: the line's
// coefficients applied to the covariance I + a K of the values in units of their sd, K that of a
// Lorentz line (exp(-2 pi w lag), averaged over blocks of windows). a and w by restricted maximum
// likelihood of what the trend leaves, w from 0.28/T by factors of two; the deviation is the mean
// over the likelihood. a is zero where the likelihood rises by less than e^4. A slope of a bent
// motion is the mean of its rate; what the trend does not follow of it counts as noise.
// `inflation` multiplies the variances of means over many windows (noise that is correlated from
// window to window). Precondition: at least eight values, times rise.
MeanRate mean_rate(const RateSeries& series, double inflation);

}  // namespace vybeg
