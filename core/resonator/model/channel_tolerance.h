#pragma once

#include "core/resonator/model/parameters.h"

#include <array>

namespace vybeg {

// Tolerances of the channels: standard deviations about the ideal pair, of drifts over a whole run.
// Zero: known exactly.
struct ChannelTolerance {
    double kappa = 0.01;     // relative
    double skew_rad = 0;     // non-orthogonality of the pick-offs
    double phase_rad = 0;    // of D against C: 2 pi f times the delay
    double crosstalk = 0;    // of C into D in quadrature, relative
    double phase_drift = 0;  // rad over a run
    double gain_drift = 0;   // relative, over a run

    friend bool operator==(const ChannelTolerance&, const ChannelTolerance&) = default;
};

// Sources of error besides the noise: channels, clock and the spread of a set, which have a
// tolerance, and effects that the model holds at zero.
enum ErrorSource : int {
    kappa_error,
    skew_error,
    delay_error,
    crosstalk_error,
    phase_drift_error,
    gain_drift_error,
    rate_error,     // sample rate
    spread_error,   // recordings of a set that differ in decay, split and gain ratio
    cubic_error,    // spring that follows the amplitude
    damping_error,  // likewise
    pickoff_error,  // gain that follows the amplitude
    springs_error,  // cubic springs unlike along the axes
    eighth_error,   // eighth harmonic of the drift of the angle
    error_sources
};
using BySource = std::array<double, error_sources>;

// Names on the command line of those with a tolerance.
inline constexpr std::array<const char*, spread_error + 1> tolerance_names{
    "kappa", "skew", "delay", "crosstalk", "phase-drift", "gain-drift", "rate", "spread"};
static_assert(tolerance_names.back() != nullptr);

// Errors of the channels as parameters of the fit.
struct ChannelError {
    ErrorSource source;
    SharedParameter parameter;
    double ChannelTolerance::*tolerance;
};

inline constexpr std::array<ChannelError, 6> channel_errors{{
    {kappa_error, kappa_at, &ChannelTolerance::kappa},
    {skew_error, skew_at, &ChannelTolerance::skew_rad},
    {delay_error, phase_at, &ChannelTolerance::phase_rad},
    {crosstalk_error, crosstalk_at, &ChannelTolerance::crosstalk},
    {phase_drift_error, phase_drift_at, &ChannelTolerance::phase_drift},
    {gain_drift_error, gain_drift_at, &ChannelTolerance::gain_drift},
}};

// Those that C has as D has: the fit sees the difference of both channels, and takes what both do
// for frequency and decay.
inline constexpr std::array drift_errors{phase_drift_error, gain_drift_error};

}  // namespace vybeg
