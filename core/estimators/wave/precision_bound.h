#pragma once

#include "core/estimators/wave/wave_state.h"
#include "core/estimators/wave/window_moments.h"

#include <cstdint>

namespace vybeg {

// Least standard deviations that any unbiased estimator can reach in one window, in white noise.
struct Precision {
    WaveState sd;  // recording units and rad
    double sd_f_hz = 0;
    double sd_delta_phi_CD = 0;
};

// Cramer-Rao bound of all five parameters together, for the window as it is: with the residual of
// section 3 it keeps what METHOD section 6 drops, and equals section 6 where that residual is zero
// (tested). noise_sd is per sample and channel, recording units. Angles' bounds are infinite where
// a_A = |a_B|.
Precision precision_bound(const Phasors& phasors, double f_hz, double rate_hz, std::int64_t n,
                          double noise_sd);

// The same where the window's kernel at that frequency is known already.
Precision precision_bound(const Phasors& phasors, const WindowKernel& kernel, double rate_hz,
                          double noise_sd);

}  // namespace vybeg
