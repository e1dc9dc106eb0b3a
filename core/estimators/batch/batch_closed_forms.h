#pragma once

#include "core/estimators/batch/closed_forms.h"
#include "core/estimators/batch/wave_report.h"
#include "core/estimators/wave/estimator.h"

namespace vybeg {

// Minimum of n J over the frequency and the wave at the minimum.
template <class Real>
struct ClosedFit {
    WaveReport<Real> wave;
    BestWaveOf<Real> best;  // of the same samples
    Real residual;          // n J at the minimum
    Real arrived;  // 1; 0 where the steps leave the reach of the series or n J is not convex
};

// Largest |x| at which J is evaluated by its series, with an error of 6e-11.
inline constexpr double closed_form_reach = 0.2;

// One of algorithms 1 to 4.
struct ClosedFormAlgorithm {
    // The fit of eight windows, by Newton's steps on the projections' series.
    void (*fit_batch)(const ProjectionBatch& batch, const TaylorFrame& frame, const FormFrame& of,
                      ClosedFit<Vec8>& found);
    // n J of one window at one frequency less the power of the samples; also returns the wave.
    double (*functional)(const SampleProducts& sum, const FormFrame& of,
                         const WindowJets<double>& jets, double x);
    ClosedWave<double> (*wave)(const SampleProducts& sum, const FormFrame& of,
                               const WindowJets<double>& jets, double x);
    int parameters = 5;
    Flags flags = 0;
    bool delays = false;  // needs S_D delayed by a quarter period
};
ClosedFormAlgorithm closed_form_algorithm(Algorithm algorithm);

}  // namespace vybeg
