#pragma once

#include "core/resonator/results/resonator_result.h"
#include "core/resonator/runs/wave_motion.h"

#include <array>

namespace vybeg {

// Name of the order of modes, as in the files.
inline const char* mode_order_name(ModeOrder order) {
    return order == ModeOrder::decay ? "decay" : "frequency";
}

// Parameters of each run. Those of the direction refer to the start angle of the wave.
struct RunParameter {
    const char* name;
    const char* unit;
    Estimate RunEstimate::*member;
};

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
struct WaveParameter {
    const char* name;
    const char* unit;
    Estimate WaveMotion::*member;
};

inline constexpr std::array<WaveParameter, 4> wave_parameters{{
    {"f_hz", "Hz", &WaveMotion::f_hz},
    {"tau_s", "s", &WaveMotion::tau_s},
    {"theta_rate_rad_s", "rad/s", &WaveMotion::theta_rate_rad_s},
    {"quadrature_rate_per_s", "1/s", &WaveMotion::quadrature_rate_per_s},
}};

// An error of the channels, or an effect of the amplitude (of frequency and damping, at the largest
// amplitude), of a usual size, for the table of sensitivities.
struct UsualError {
    const char* name;
    const char* amount;  // as text, with its unit
    double size;         // in the unit of the sensitivity
    double ChannelSensitivity::*member;
};

inline constexpr std::array<UsualError, 8> usual_errors{{
    {"skew", "0.1 deg", 0.1, &ChannelSensitivity::skew_deg},
    {"delay", "10 ns", 1e-8, &ChannelSensitivity::delay_s},
    {"phase drift", "1e-4 rad", 1e-4, &ChannelSensitivity::phase_drift_rad},
    {"gain drift", "1e-4", 1e-4, &ChannelSensitivity::gain_drift},
    {"kappa", "0.001", 1e-3, &ChannelSensitivity::kappa},
    {"cubic", "10 uHz", 1e-5, &ChannelSensitivity::cubic_hz},
    {"damping", "1 %", 1e-2, &ChannelSensitivity::damping_share},
    {"pick-offs", "0.1 %", 1e-3, &ChannelSensitivity::pickoff_share},
}};

}  // namespace vybeg
