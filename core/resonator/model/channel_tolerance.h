#pragma once

#include "core/resonator/model/parameters.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numbers>
#include <optional>
#include <span>

namespace vybeg {

// Sources of error besides the noise: channels, clock and the spread of a set, which have a
// tolerance, and effects that the model holds at zero.
enum ErrorSource : int {
    kappa_error,
    skew_error,
    delay_error,
    crosstalk_error,
    phase_drift_error,
    gain_drift_error,
    channel_error_count,
    rate_error = channel_error_count,  // sample rate
    spread_error,  // recordings of a set that differ in decay, split and gain ratio
    tolerated_count,
    cubic_error = tolerated_count,  // spring that follows the amplitude
    damping_error,                  // likewise
    pickoff_error,                  // gain that follows the amplitude
    springs_error,                  // cubic springs unlike along the axes
    eighth_error,                   // eighth harmonic of the drift of the angle
    error_sources
};
using BySource = std::array<double, error_sources>;

// Tolerances by source: standard deviations about the calibrated pair, of drifts over a whole run;
// zero: known exactly. Those of the channels as errors of the fit's parameters, and all as the
// command line has them; none: see assumed_tolerance().
using ChannelTolerance = std::array<double, channel_error_count>;
using Tolerance = std::array<std::optional<double>, tolerated_count>;

// The tolerance where none is stated: the fit finds the gain ratio alone.
inline constexpr ChannelTolerance untold_channels{0.01};

// The single list that the fit, the option, the settings, the results and the window go through.
struct ToleratedError {
    ErrorSource source;
    SharedParameter parameter;      // shared_count: of no channel
    const char* name;               // on the command line and in results
    const char* unit;               // there; "" for a ratio
    const char* amount;             // there: what the number is
    double factor = 1;              // SI per unit; of a delay rad per s and Hz: a late D lags
    const char* shown_unit = unit;  // in sentences and in the window
    double shown = 1;               // units per unit shown

    // Of the fit's parameter per unit, at a carrier of f_hz.
    constexpr double per_unit(double f_hz) const {
        return source == delay_error ? factor * f_hz : factor;
    }
};

inline constexpr std::array<ToleratedError, tolerated_count> tolerated_errors{{
    {kappa_error, kappa_at, "kappa", "", "relative"},
    {skew_error, skew_at, "skew", "deg", "deg", std::numbers::pi / 180},
    {delay_error, phase_at, "delay", "s", "s", -2 * std::numbers::pi, "ns", 1e-9},
    {crosstalk_error, crosstalk_at, "crosstalk", "", "relative"},
    {phase_drift_error, phase_drift_at, "phase-drift", "rad", "rad over a run"},
    {gain_drift_error, gain_drift_at, "gain-drift", "", "relative, over a run"},
    {rate_error, shared_count, "rate", "ppm", "ppm", 1e-6},
    {spread_error, shared_count, "spread", "", "relative"},
}};
static_assert(std::ranges::adjacent_find(tolerated_errors, std::greater_equal(),
                                         &ToleratedError::source) == tolerated_errors.end() &&
              tolerated_errors.back().source == spread_error);

inline constexpr auto channel_errors = std::span(tolerated_errors).first<channel_error_count>();

// An error of a usual size, for the table of sensitivities; where no tolerance of the channels is
// stated, that size is assumed (kappa: untold_channels). Effects of the amplitude refer to the
// largest one.
struct UsualError {
    ErrorSource source;
    const char* name;
    const char* key;     // of its sensitivity in JSON
    const char* amount;  // as text, with its unit
    double size;         // in the unit of the sensitivity
};

inline constexpr auto usual_errors = std::to_array<UsualError>({
    {skew_error, "skew", "skew_deg", "0.1 deg", 0.1},
    {delay_error, "delay", "delay_s", "10 ns", 1e-8},
    {phase_drift_error, "phase drift", "phase_drift_rad", "1e-4 rad", 1e-4},
    {gain_drift_error, "gain drift", "gain_drift", "1e-4", 1e-4},
    {kappa_error, "kappa", "kappa", "0.001", 1e-3},
    {crosstalk_error, "crosstalk", "crosstalk", "1e-4", 1e-4},
    {cubic_error, "cubic", "cubic_hz", "10 uHz", 1e-5},
    {damping_error, "damping", "damping_share", "1 %", 1e-2},
    {pickoff_error, "pick-offs", "pickoff_share", "0.1 %", 1e-3},
    {springs_error, "springs", "springs_hz", "10 uHz", 1e-5},
    {eighth_error, "harmonic 8", "eighth_rad_s", "1e-6 rad/s", 1e-6},
});

// Those that C has as D has: the fit sees the difference of both channels, and takes what both do
// for frequency and decay.
inline constexpr std::array drift_errors{phase_drift_error, gain_drift_error};

}  // namespace vybeg
