#pragma once

#include "core/estimators/batch/wave_report.h"
#include "core/estimators/wave/estimator.h"

namespace vybeg {

// Samples of one window of a block.
Window window_of(const WindowBlock& block, std::size_t k);

// True where a sample of the span is missing.
bool has_gap(std::span<const double> samples);

// An estimate without values, for a window that has none; `flag` says why.
WaveEstimate no_estimate(Flag flag);

// How well a wave fits its window.
struct WaveFit {
    double residual = 0;  // n F, the sum of squares that the wave leaves
    int parameters = 5;
    Flags flags = 0;
    const BestWave* best = nullptr;  // algorithms 1 to 4
};

// n F: `difference`, the window's power (sum C^2 + D^2) less the power of the wave, while that has
// kept eight digits; where less than 1e-8 of the power is left, a sum over the samples.
double residual_of(double difference, double power, const Window& window,
                   const WaveReport<double>& wave);

// Adds to an estimate by a closed form what that has beyond the best wave of the same samples:
// leakage of a window off Snap, power of the noise in the averages. The best wave is efficient, so
// that the difference is not correlated with its error (J. A. Hausman, 1978): variances add, and
// the closed form has that of the best wave plus the squared difference. Flag leakage where a
// difference exceeds its standard deviation.
void add_leakage(WaveEstimate& estimate, const BestWave& best, double rate_hz);

// Makes unknown what does not exist: a_B and dphi_CD where the algorithm has none (flag
// no_quadrature), else the angles where |a_A - |a_B|| is below three standard deviations (flag
// circular). `noise` is that of the phasors.
void clear_undefined(WaveEstimate& estimate, double noise, std::int64_t n);

// The estimate of a window: rms from the residual, noise from the rms with the degrees of freedom
// removed (2n - parameters), standard deviations for the known noise, else for that of the
// residual.
WaveEstimate complete_estimate(const WaveReport<double>& wave, const WaveFit& fit,
                               const EstimatorOptions& options);

// The same with everything from the window itself, for a wave of five parameters.
WaveEstimate complete_estimate(const Phasors& phasors, double w, Flags flags, const Window& window,
                               const EstimatorOptions& options);

}  // namespace vybeg
