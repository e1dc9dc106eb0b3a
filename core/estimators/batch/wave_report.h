#pragma once

#include "core/estimators/batch/window_jets.h"
#include "core/estimators/wave/precision_bound.h"

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

}  // namespace vybeg
