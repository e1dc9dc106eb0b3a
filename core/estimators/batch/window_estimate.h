#pragma once

#include "core/estimators/batch/taylor_window.h"
#include "core/estimators/wave/estimator.h"
#include "core/estimators/wave/wave_formulas.h"

#include <algorithm>

namespace vybeg {

// Least-squares wave of a window, for comparison with that of a closed form.
template <class Real>
struct BestWaveOf {
    WaveStateOf<Real> state;
    Real w;  // rad per sample
    Real delta_phi_CD;
    Real power;   // of the best phasors
    Real motion;  // motion_power()
};
using BestWave = BestWaveOf<double>;

// Wave of a window by one algorithm, with all derived values except the noise.
template <class Real>
struct WaveReport {
    Real w;  // rad per sample
    PhasorParts<Real> phasors;
    WaveStateOf<Real> state;
    Real delta_phi_CD;
    Real orthogonality;
    PrecisionOf<Real> unit_sd;  // for noise of one recording unit
};

template <class Real>
VYBEG_INLINED inline WaveReport<Real> report_wave(const SampleProductsOf<Real>& sum, Real w,
                                                  const WindowKernelOf<Real>& kernel,
                                                  const PhasorParts<Real>& phasors,
                                                  const OrientedWave<Real>& found) {
    // <S_A S_B> over <S_A^2> + <S_B^2>: orthogonality of the wave axes, (30), from sums of the
    // samples.
    const Real orthogonality =
        (sum.cd * found.turn_cos + 0.5 * (sum.dd - sum.cc) * found.turn_sin) / (sum.cc + sum.dd);
    return {w,
            phasors,
            found.wave,
            phase_difference_of(phasors),
            orthogonality,
            unit_precision(phasors, kernel)};
}

VYBEG_INLINED inline SampleProductsOf<Vec8> products_of(const ProjectionBatch& batch) {
    return {load(batch.cc), load(batch.dd), load(batch.cd), load(batch.cq)};
}

// Of eight windows at x; `g` by x.
VYBEG_INLINED inline WaveReport<Vec8> report_batch(const ProjectionBatch& batch,
                                                   const TaylorFrame& frame, Vec8 x,
                                                   const Jet2<Vec8>& g,
                                                   const PhasorParts<Vec8>& phasors,
                                                   const OrientedWave<Vec8>& found) {
    const auto n = static_cast<double>(frame.length());
    return report_wave(
        products_of(batch), frame.w0() + 2 * x / n,
        {g.value, n - g.value, 0.5 * n * g.slope, 0.25 * n * n * g.bend, frame.spread()}, phasors,
        found);
}

// Least-squares wave of a window from the series of its projections.
template <class Real>
struct SeriesFit {
    WaveReport<Real> wave;
    Real residual;  // n F at the minimum
    Real motion;    // motion_power()
    Real arrived;   // 1; 0 where the steps have not converged within the reach of the series
};

// Samples of window k of a block.
Window window_of(const WindowBlock& block, std::size_t k);

// Estimate with NaN values; `flag` is the reason.
WaveEstimate no_estimate(Flag flag);

// Quality of a wave's fit in its window.
struct WaveFit {
    double residual = 0;             // n F, sum of squared residuals
    double steady = 0;               // that of the best wave without the linear part of its motion
    Flags flags = 0;                 // no_quadrature: four parameters, otherwise five
    const BestWave* best = nullptr;  // algorithms 1 to 4
};

// n F, the sum of squared residuals: `difference`, the window's power (sum C^2 + D^2) less the
// power of the wave, if it exceeds 1e-8 of the power and so keeps eight digits; otherwise a sum
// over the samples.
double residual_of(double difference, double power, const Window& window,
                   const PhasorParts<double>& phasors, double w);

// The residual without the power of the motion (motion_power()); a remainder within the rounding of
// both is that rounding.
inline double without_motion(double residual, double motion) {
    return std::max(residual - motion, 1e-12 * residual);
}

// Best wave with the powers of its window.
BestWave best_wave(const Phasors& phasors, double w, const Window& window);

// Gives the deviations of an estimate for another noise than that of its own window. The leakage of
// a closed form stays in them, and Flag::leakage follows them.
void set_noise(WaveEstimate& estimate, double noise);

// Degrees of freedom of WaveEstimate::steady_noise.
inline double steady_freedom(std::int64_t n) {
    return 2 * static_cast<double>(n) - 8;
}

// Estimate of a window, whose samples have the `power`: rms from the residual; noise with 2n -
// parameters degrees of freedom; standard deviations for the known noise, otherwise for the steady
// noise of the window.
WaveEstimate complete_estimate(const WaveReport<double>& wave, const WaveFit& fit,
                               const EstimatorOptions& options);

// The same with everything from the window itself, for a wave of five parameters.
WaveEstimate complete_estimate(const Phasors& phasors, double w, Flags flags, const Window& window,
                               const EstimatorOptions& options);

}  // namespace vybeg
