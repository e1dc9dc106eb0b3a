#pragma once

#include "core/drift/log_drift.h"
#include "core/resonator/results/resonator_parameters.h"

#include <Eigen/Core>

#include <array>
#include <numbers>
#include <span>

namespace vybeg {

// What drift and efforts say of the resonator.
struct HeldResonator {
    Estimate damping_anisotropy_per_s;  // g, from the drift
    Estimate theta_tau_rad;
    Estimate tau_s;     // 2 rho/g, rho the fourth harmonic of the amplitude effort over its mean
    Estimate split_hz;  // from the quadrature effort, as large for its motion as the amplitude's
    Estimate theta_w_rad;
};

inline constexpr std::array<ParameterOf<HeldResonator>, 5> held_parameters{{
    {"damping_anisotropy_per_s", "1/s", &HeldResonator::damping_anisotropy_per_s},
    {"theta_tau_rad", "rad", &HeldResonator::theta_tau_rad, std::numbers::pi / 2},
    {"tau_s", "s", &HeldResonator::tau_s},
    {"split_hz", "Hz", &HeldResonator::split_hz},
    {"theta_w_rad", "rad", &HeldResonator::theta_w_rad, std::numbers::pi / 2},
}};

// What the fourth harmonic of the drift and the efforts of the logs say of the resonator. `drift`:
// cos4, sin4, rad/s, with the covariance of its noise and that with the channels, for u.
HeldResonator held_resonator(const Eigen::Vector2d& drift, const Eigen::Matrix2d& of_noise,
                             const Eigen::Matrix2d& with_channels,
                             std::span<const LogDrift* const> logs);

}  // namespace vybeg
