#pragma once

#include "core/track/trend.h"

#include <cstddef>
#include <optional>

namespace vybeg {

// A beat of a slow variable between two times: a damped sinusoid on a straight line,
//     v(t) = value + slope u + e^{-u/tau} (in_phase cos(2 pi f u) + quadrature sin(2 pi f u)),
// u = t - centre_s. Deviations by least squares.
struct Beat {
    std::size_t windows = 0;
    double centre_s = 0;  // middle of the points
    double value = 0;
    double slope_per_s = 0;
    double in_phase = 0;
    double quadrature = 0;
    double frequency_hz = 0;
    double sd_frequency_hz = 0;
    double damping_per_s = 0;  // 1/tau
    double sd_damping_per_s = 0;
    double amplitude = 0;  // at centre_s
    double sd_amplitude = 0;
    double chi2_per_dof = 0;

    double at(double time_s) const;
};

// Frequencies from one and a quarter periods to 100 periods between the times are searched: less of
// a period fits any smooth curve. Nothing where the amplitude lies within six of its deviations of
// zero, where the points scatter about the beat by more than their noise (scatter_about()), because
// the motion then is another one, or for fewer than ten points.
std::optional<Beat> find_beat(const Track& track, SlowVariable variable, double from_s, double to_s,
                              std::size_t apart);

}  // namespace vybeg
