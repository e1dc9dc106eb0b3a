#pragma once

#include "core/estimators/batch/series_result.h"
#include "core/estimators/batch/window_series.h"

namespace vybeg {

// Algorithm 5 in windows that stand side by side: the conjugate gradient of descent.h,
// step by step the same, with F and its derivatives from the projections' series.

struct SeriesStart {
    Lanes a_A;
    Lanes a_B;
    Lanes two_theta_A;
    Lanes alpha;
    Lanes x;
};

// (15), (18) at the carrier.
void in_phase_starts(const SeriesBatch& batch, const SeriesFrame& frame, SeriesStart& start);

struct SeriesDescent {
    SeriesEstimates waves;
    Lanes residual;  // n F at the minimum
    // 1; or 0 where the way leaves the series' reach, or a step is not the exact one: such windows
    // are left to descend().
    Lanes arrived;
};

void descend_series(const SeriesBatch& batch, const SeriesFrame& frame, const SeriesStart& start,
                    SeriesDescent& descent);

}  // namespace vybeg
