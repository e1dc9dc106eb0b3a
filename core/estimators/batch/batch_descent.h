#pragma once

#include "core/estimators/batch/wave_report.h"

namespace vybeg {

// Algorithm 5 in eight windows: the conjugate gradient of conjugate_gradient.h, step by step the
// same, with F and its derivatives from the projections' series.
template <class Real>
struct DescentFit {
    WaveReport<Real> wave;
    Real residual;  // n F at the minimum
    // 1; or 0 where the way leaves the series' reach, or a step is not the exact one: such windows
    // are left to descend().
    Real arrived;
};

struct BatchStart {
    Lanes a_A;
    Lanes a_B;
    Lanes two_theta_A;
    Lanes alpha;
    Lanes x;
};

// (15), (18) at the reference frequency.
void in_phase_starts(const ProjectionBatch& batch, const TaylorFrame& frame, BatchStart& start);

void descend_batch(const ProjectionBatch& batch, const TaylorFrame& frame, const BatchStart& start,
                   DescentFit<Vec8>& found);

}  // namespace vybeg
