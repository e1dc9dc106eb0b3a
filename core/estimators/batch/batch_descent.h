#pragma once

#include "core/estimators/batch/wave_report.h"

namespace vybeg {

// Algorithm 5 for eight windows: the conjugate gradient of conjugate_gradient.h with the same
// steps; F and its derivatives come from the series of the projections.
template <class Real>
struct DescentFit {
    WaveReport<Real> wave;
    Real residual;  // n F at the minimum
    Real motion;    // motion_power()
    // 1; 0 where the steps leave the reach of the series or a step is not the exact one. descend()
    // estimates such windows.
    Real arrived;
};

struct BatchStart {
    Lanes a_A;
    Lanes a_B;
    Lanes two_theta_A;
    Lanes alpha;
    Lanes x;
};

// Start values of algorithm 5, (15), (18), at the reference frequency.
void in_phase_starts(const ProjectionBatch& batch, const TaylorFrame& frame, BatchStart& start);

void descend_batch(const ProjectionBatch& batch, const TaylorFrame& frame, const BatchStart& start,
                   DescentFit<Vec8>& found);

}  // namespace vybeg
