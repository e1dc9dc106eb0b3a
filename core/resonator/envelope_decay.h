#pragma once

#include "core/resonator/phasor_model.h"

#include <span>

namespace vybeg {

// The decay of the power |z|^2 of a run, which knows nothing of phase and frequency: a weighted
// straight line through log |z|^2, down to a power of 100 noise variances.
struct EnvelopeDecay {
    double per_s = 0;        // 1/tau, half the slope
    double sd = 0;           // from the noise; infinite for fewer than three usable windows
    double model_per_s = 0;  // the same line through the power of a fitted motion
};

EnvelopeDecay envelope_decay(const ScaledRun& run, const Shared& shared, const Own& own);

}  // namespace vybeg
