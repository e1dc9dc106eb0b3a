#pragma once

#include "core/estimators/wave/estimator.h"
#include "core/estimators/wave/window_moments.h"

#include <optional>

namespace vybeg {

// Samples of one window of a block.
Window window_of(const WindowBlock& block, std::size_t k);

// True where a sample of the span is missing.
bool has_gap(std::span<const double> samples);

// An estimate without values, for a window that has none; `flag` says why.
WaveEstimate no_estimate(Flag flag);

// The best wave of a window in the sense of least squares, beside that of a closed form.
struct BestWave {
    WaveState state;
    double f_hz = 0;
    double delta_phi_CD = 0;
};

// What an algorithm found in a window.
struct FoundWave {
    WaveState state;
    Phasors phasors;
    double w = 0;  // rad per sample
    int parameters = 5;
    Flags flags = 0;
    std::optional<BestWave> best = std::nullopt;  // algorithms 1 to 4
};

// n F, the sum of squares that a wave leaves of a window: `difference`, the window's power
// (sum C^2 + D^2) less what the wave takes of it, while that has kept eight digits; where less than
// 1e-8 of the power is left, summed up over the samples.
double residual_of(double difference, double power, const Window& window,
                   const Projections& phasors, double w);

// Adds to an estimate by a closed form what that has beyond the best wave of the same samples:
// leakage of a window off Snap, power of the noise in the averages. The best wave is efficient, so
// that the difference is not correlated with its error (J. A. Hausman, 1978): variances add, and
// the closed form has that of the best wave plus the squared difference. Flag leakage where a
// difference exceeds its standard deviation.
void add_leakage(WaveEstimate& estimate, const BestWave& best);

// Takes away what does not exist: a_B and dphi_CD where the algorithm has none (flag
// no_quadrature), else the angles where |a_A - |a_B|| is below three standard deviations (flag
// circular). `noise` is that of the phasors.
void drop_what_is_not(WaveEstimate& estimate, double noise, std::int64_t n);

// The noise by which standard deviations are scaled: the known one, else that of the residual.
EquivalentNoise noise_of(double residual_noise, const EstimatorOptions& options);

// Completes what was found: rms from the residual, noise from the rms with the degrees of freedom
// removed (2n - parameters), standard deviations from the precision bound, dphi_CD, orthogonality,
// and the flag `circular` (angles NaN) where |a_A - |a_B|| is below three standard deviations.
// `residual` is n F, the sum of squares that the wave leaves; `kernel` is that of n samples at w, n
// the options' length.
WaveEstimate complete_estimate(const FoundWave& found, double residual,
                               const SampleProducts& products, const WindowKernel& kernel,
                               const EstimatorOptions& options);

// The same with everything from the window itself.
WaveEstimate complete_estimate(const FoundWave& found, const Window& window,
                               const EstimatorOptions& options);

}  // namespace vybeg
