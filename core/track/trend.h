#pragma once

#include "core/track/track.h"
#include "core/track/trend_points.h"

#include <cstddef>
#include <optional>

namespace vybeg {

// Straight line through a slow variable between two times.
struct Trend {
    std::size_t windows = 0;  // that count
    double centre_s = 0;      // weighted mean time, where value and slope are uncorrelated
    double value = 0;         // of the line there, stored units; or its logarithm
    double sd_value = 0;
    double slope_per_s = 0;
    double sd_slope_per_s = 0;
    double chi2_per_dof = 0;  // of the windows about the line, before the deviations are enlarged
    double enlargement = 1;   // of the deviations, see scatter_about()

    double at(double time_s) const { return value + slope_per_s * (time_s - centre_s); }
};

// Weighted least squares over trend_points(). Nothing for fewer than three points.
std::optional<Trend> line_trend(const Track& track, SlowVariable variable, double from_s,
                                double to_s, std::size_t apart, TrendOf of = TrendOf::value);

struct DecayTime {
    double tau_s = 0;
    double sd_s = 0;
};

// Amplitude decay time from the trend of the logarithm of an amplitude; nothing where its slope
// lies within two standard deviations of zero.
std::optional<DecayTime> decay_time(const Trend& of_logarithm);

}  // namespace vybeg
