#pragma once

#include "core/track/track.h"

#include <cstdint>
#include <optional>

namespace vybeg {

// Straight line through a slow variable between two times, by weighted least squares.
struct Trend {
    std::size_t windows = 0;  // that count
    double centre_s = 0;      // weighted mean time, where value and slope are uncorrelated
    double value = 0;         // of the line there, stored units; or its logarithm
    double sd_value = 0;
    double slope_per_s = 0;
    double sd_slope_per_s = 0;
    double chi2_per_dof = 0;  // of the windows about the line, before the deviations are enlarged

    double at(double time_s) const { return value + slope_per_s * (time_s - centre_s); }
};

enum class TrendOf : std::uint8_t { value, logarithm };

// Windows that share samples have correlated errors, so only every k-th counts, where k hops reach
// over a window: `apart` is that k. Their noise is pooled.
// Windows without value or with samples missing, clipped or
// disturbed do not count. 2theta_A is taken as it is, unwrapped; delta_phi_CD and alpha are
// unwrapped between successive windows. Where the windows scatter about the line by more than three
// standard deviations of chi^2 allow, the deviations are multiplied by the root of chi^2 per degree
// of freedom, as the scatter then is no white noise or the motion no line. Nothing for fewer than
// three windows that count, for a variable without standard deviations, or for the logarithm of
// values that are not positive.
std::optional<Trend> line_trend(const Track& track, SlowVariable variable, double from_s,
                                double to_s, std::size_t apart, TrendOf of = TrendOf::value);

// Hops of a plan that reach over a window of `length` samples.
std::size_t windows_apart(std::int64_t length, std::int64_t hop);

struct DecayTime {
    double tau_s = 0;
    double sd_s = 0;
};

// Amplitude decay time from the trend of the logarithm of an amplitude; nothing where its slope
// lies within two standard deviations of zero.
std::optional<DecayTime> decay_time(const Trend& of_logarithm);

}  // namespace vybeg
