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

// What an algorithm found in a window.
struct FoundWave {
    WaveState state;
    Phasors phasors;
    double w = 0;  // rad per sample
    int parameters = 5;
    Flags flags = 0;
};

// n F, the sum of squares that a wave leaves of a window: `difference`, the window's power
// (sum C^2 + D^2) less what the wave takes of it, while that has kept eight digits; where less than
// 1e-8 of the power is left, summed up over the samples.
double residual_of(double difference, double power, const Window& window,
                   const Projections& phasors, double w);

// Takes away what does not exist: a_B and dphi_CD where the algorithm has none (flag
// no_quadrature), else the angles where |a_A - |a_B|| is below three standard deviations (flag
// circular). `residual` is n F.
void drop_what_is_not(WaveEstimate& estimate, double residual, int parameters, std::int64_t n);

// Completes what was found: rms from the residual, noise from the rms with the degrees of freedom
// removed (2n - parameters), standard deviations from the precision bound, dphi_CD, orthogonality,
// and the flag `circular` (angles NaN) where |a_A - |a_B|| is below three standard deviations.
// `residual` is n F, the sum of squares that the wave leaves; `kernel` is that of n samples at w.
WaveEstimate complete_estimate(const FoundWave& found, double residual,
                               const SampleProducts& products, const WindowKernel& kernel,
                               std::int64_t n, double rate_hz);

// The same with everything from the window itself.
WaveEstimate complete_estimate(const FoundWave& found, const Window& window, double rate_hz);

}  // namespace vybeg
