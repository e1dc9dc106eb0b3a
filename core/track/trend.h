#pragma once

#include "core/track/track.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace vybeg {

enum class TrendOf : std::uint8_t { value, logarithm };

// The windows of a slow variable between two times that count for a trend. Windows that share
// samples have correlated errors, so only every k-th counts, where k hops reach over a window:
// `apart` is that k. Windows without value or with samples missing, clipped or disturbed do not
// count, nor do values that are not positive, of which there is no logarithm. 2theta_A is taken as
// it is, unwrapped; delta_phi_CD and alpha are unwrapped between successive windows. A variable
// without standard deviations has no trend.
//
// Enlargement: factor of a trend's deviations, 1 for white noise of the stated size. Where the
// points, or the means of up to 24 groups of successive points, scatter by more than three standard
// deviations of chi^2 allow, it is the root of the larger chi^2 per degree of freedom. Groups see
// what single points hide: slow noise, and a motion that is not the trend's.

// Hops of a plan that reach over a window of `length` samples.
std::size_t windows_apart(std::int64_t length, std::int64_t hop);

// Straight line through a slow variable between two times.
struct Trend {
    std::size_t windows = 0;  // that count
    double centre_s = 0;      // weighted mean time, where value and slope are uncorrelated
    double value = 0;         // of the line there, stored units; or its logarithm
    double sd_value = 0;
    double slope_per_s = 0;
    double sd_slope_per_s = 0;
    double chi2_per_dof = 0;  // of the windows about the line, before the deviations are enlarged
    double enlargement = 1;   // of the deviations

    double at(double time_s) const { return value + slope_per_s * (time_s - centre_s); }
};

// Weighted least squares. Nothing for fewer than three points.
std::optional<Trend> line_trend(const Track& track, SlowVariable variable, double from_s,
                                double to_s, std::size_t apart, TrendOf of = TrendOf::value);

struct DecayTime {
    double tau_s = 0;
    double sd_s = 0;
};

// Amplitude decay time from the trend of the logarithm of an amplitude; nothing where its slope
// lies within two standard deviations of zero.
std::optional<DecayTime> decay_time(const Trend& of_logarithm);

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

inline constexpr double least_beat_periods = 1.25;  // between the times

// Frequencies from one and a quarter periods to 100 periods between the times are searched: less of
// a period fits any smooth curve. Nothing where the amplitude lies within six of its deviations of
// zero, where the points scatter about the beat by more than their noise, because
// the motion then is another one, or for fewer than ten points.
std::optional<Beat> find_beat(const Track& track, SlowVariable variable, double from_s, double to_s,
                              std::size_t apart);

}  // namespace vybeg
