#pragma once

#include "core/drift/log_drift.h"
#include "core/resonator/model/reason.h"

#include <Eigen/Core>

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

// What the fourth harmonic of the drift and the efforts of the logs say of the resonator. `drift`:
// cos4, sin4, rad/s, with the covariance of its noise and that with the channels, for u.
HeldResonator held_resonator(const Eigen::Vector2d& drift, const Eigen::Matrix2d& of_noise,
                             const Eigen::Matrix2d& with_channels,
                             std::span<const LogDrift* const> logs);

}  // namespace vybeg
