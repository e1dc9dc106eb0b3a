#pragma once

#include "core/resonator/model/scaled_run.h"

#include <Eigen/Core>

#include <span>

namespace vybeg {

// Decay of the power |z|^2 of a run, independent of phase and frequency: a weighted straight line
// through log |z|^2, down to a power of 100 noise variances.
struct EnvelopeDecay {
    double per_s = 0;  // 1/tau, half the slope
    // From the scatter about the line, at least that of the noise; infinite for fewer than three
    // usable windows.
    double sd = 0;
    double model_per_s = 0;  // the same line through the power of `expected`
};

// `expected`: the phasors of a fitted motion in the run's windows, scaled units.
EnvelopeDecay envelope_decay(const ScaledRun& run, std::span<const Eigen::Vector2cd> expected);

}  // namespace vybeg
