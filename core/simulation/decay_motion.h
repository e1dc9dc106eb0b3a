#pragma once

#include "core/simulation/amplitude_factor.h"
#include "core/simulation/power_motion.h"
#include "core/simulation/slow_motion.h"

#include <cstdint>
#include <optional>

namespace vybeg {

// The wave frame by frame: the slow motion, linear or not, with its carrier whose frequency may
// drift and settle.
class DecayMotion {
public:
    // `late_s`: delay of the motion against each frame, s. Precondition: check(decay) passes.
    explicit DecayMotion(const FreeDecay& decay, double late_s = 0);

    // Phasors with their carrier, the signals being their real parts, at frame 0, 1, 2, ...
    Eigen::Vector2cd next();

    // The same at a frame (whole or half); frames in ascending order, not mixed with next().
    Eigen::Vector2cd at_frame(double frame);

    // f(t) plus the mean rate of phase of both phasors at a frame, Hz; `phasors` are those there.
    double frequency_hz(double frame, const Eigen::Vector2cd& phasors) const;

private:
    std::complex<double> turn(double frame) const;

    FreeDecay decay_;
    double late_s_;
    SlowMotion linear_;
    std::optional<PowerMotion> by_power_;
    std::optional<AmplitudeFactor> factor_;
    bool turns_;                    // whether f changes
    std::complex<double> earlier_;  // rotation of the carrier in late_s_
    Eigen::Matrix2cd step_;
    Eigen::Vector2cd z_;
    std::int64_t frame_ = 0;
};

}  // namespace vybeg
