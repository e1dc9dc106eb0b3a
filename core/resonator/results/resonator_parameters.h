#pragma once

#include "core/resonator/results/resonator_result.h"

#include <array>
#include <numbers>

namespace vybeg {

// Parameters of a resonator, with their names in identify JSON. Files and comparison iterate over
// this list.
struct ResonatorParameter {
    const char* name;
    const char* unit;  // "" for a ratio
    Estimate ResonatorEstimate::*member;
    double period;  // of an axis, rad; 0 for values that are no angles
};

inline constexpr std::array<ResonatorParameter, 12> resonator_parameters{{
    {"f_mean_hz", "Hz", &ResonatorEstimate::f_mean_hz, 0},
    {"split_hz", "Hz", &ResonatorEstimate::split_hz, 0},
    {"theta_w_rad", "rad", &ResonatorEstimate::theta_w_rad, std::numbers::pi / 2},
    {"tau_s", "s", &ResonatorEstimate::tau_s, 0},
    {"q", "", &ResonatorEstimate::q, 0},
    {"damping_anisotropy_per_s", "1/s", &ResonatorEstimate::damping_anisotropy_per_s, 0},
    {"theta_tau_rad", "rad", &ResonatorEstimate::theta_tau_rad, std::numbers::pi / 2},
    {"angle_rate_rad_s", "rad/s", &ResonatorEstimate::angle_rate_rad_s, 0},
    {"kappa", "", &ResonatorEstimate::kappa, 0},
    {"non_orthogonality_rad", "rad", &ResonatorEstimate::non_orthogonality_rad, 0},
    {"delay_s", "s", &ResonatorEstimate::delay_s, 0},
    {"frequency_per_power", "Hz per squared unit", &ResonatorEstimate::frequency_per_power, 0},
}};

// A parameter of something else.
template <class Owner>
struct ParameterOf {
    const char* name;
    const char* unit;
    Estimate Owner::*member;
};

// Of each mode.
using ModeParameter = ParameterOf<ModeEstimate>;

inline constexpr std::array<ModeParameter, 3> mode_parameters{{
    {"f_hz", "Hz", &ModeEstimate::f_hz},
    {"tau_s", "s", &ModeEstimate::tau_s},
    {"q", "", &ModeEstimate::q},
}};

}  // namespace vybeg
