#pragma once

#include "core/resonator/results/resonator_parameters.h"
#include "core/resonator/runs/wave_motion.h"

#include <array>

namespace vybeg {

// Name of the order of modes, as in the files.
inline const char* mode_order_name(ModeOrder order) {
    return order == ModeOrder::decay ? "decay" : "frequency";
}

// Parameters of each run. Those of the direction refer to the start angle of the wave.
using RunParameter = ParameterOf<RunEstimate>;

inline constexpr std::array<RunParameter, 9> run_parameters{{
    {"f_offset_hz", "Hz", &RunEstimate::f_offset_hz},
    {"a_A", "", &RunEstimate::a_A},
    {"a_B", "", &RunEstimate::a_B},
    {"two_theta_A_rad", "rad", &RunEstimate::two_theta_A_rad},
    {"split_sin_hz", "Hz", &RunEstimate::split_sin_hz},
    {"direction_f_hz", "Hz", &RunEstimate::direction_f_hz},
    {"direction_tau_s", "s", &RunEstimate::direction_tau_s},
    {"q_envelope", "", &RunEstimate::q_envelope},
    {"drift_hz_per_s", "Hz/s", &RunEstimate::drift_hz_per_s},
}};

// Model-free parameters of the wave of each run.
using WaveParameter = ParameterOf<WaveMotion>;

inline constexpr std::array<WaveParameter, 4> wave_parameters{{
    {"f_hz", "Hz", &WaveMotion::f_hz},
    {"tau_s", "s", &WaveMotion::tau_s},
    {"theta_rate_rad_s", "rad/s", &WaveMotion::theta_rate_rad_s},
    {"quadrature_rate_per_s", "1/s", &WaveMotion::quadrature_rate_per_s},
}};

// An error of a usual size, for the table of sensitivities; where no tolerance of the channels is
// told, that size is assumed (kappa: 0.01). Effects of the amplitude refer to the largest one.
struct UsualError {
    ErrorSource source;
    const char* name;
    const char* key;     // of its sensitivity in JSON
    const char* amount;  // as text, with its unit
    double size;         // in the unit of the sensitivity
};

inline constexpr std::array<UsualError, 11> usual_errors{{
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
}};

}  // namespace vybeg
