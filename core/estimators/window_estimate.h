#pragma once

#include "core/estimators/estimator.h"
#include "core/estimators/window_moments.h"

namespace vybeg {

// Samples of one window of a block.
Window window_of(const WindowBlock& block, std::size_t k);

// True where a sample of the span is missing.
bool has_gap(std::span<const double> samples);

// An estimate without values, for a window that has none; `flag` says why.
WaveEstimate no_estimate(Flag flag);

// Completes what an algorithm found in a window: rms from the residuals of `phasors` at w, noise
// from the rms with the degrees of freedom removed (2n - parameters), standard deviations from the
// precision bound, dphi_CD, orthogonality, and the flag `circular` (angles NaN) where |a_A - |a_B||
// is below three standard deviations.
WaveEstimate complete_estimate(const Window& window, double rate_hz, const WaveState& state,
                               const Phasors& phasors, double w, int parameters, Flags flags);

}  // namespace vybeg
