#pragma once

#include "core/estimators/batch/series_result.h"
#include "core/estimators/batch/window_series.h"

namespace vybeg {

// Algorithms 1 to 4 in windows that stand side by side: J, the functional that each of them
// minimises by the frequency, (16), (25), (29), as a function of the projections' series, and its
// minimum by Newton's steps on them.
struct ClosedSeries {
    SeriesEstimates waves;
    Lanes residual;  // n J at the minimum
    Lanes arrived;   // 1; or 0 where the steps leave the series' reach or meet no convexity
    // The best wave of the same samples.
    Lanes best_w;
    Lanes best_a_A;
    Lanes best_a_B;
    Lanes best_two_theta_A;
    Lanes best_alpha;
    Lanes best_delta_phi_CD;
};

// Largest |x| of the series at which J is evaluated by it: right to 6e-11 there.
inline constexpr double closed_form_reach = 0.2;

// What they estimate in closed form stands beside their algorithm (in_phase.cpp and so on).
void in_phase_series(const SeriesBatch& batch, const SeriesFrame& frame, ClosedSeries& found);
// quarter_period: the delay of S_D in batch.cq, samples; about pi/2 at the frame's frequency.
void phase_shift_series(const SeriesBatch& batch, const SeriesFrame& frame, double quarter_period,
                        ClosedSeries& found);
void moving_axes_series(const SeriesBatch& batch, const SeriesFrame& frame, ClosedSeries& found);
void demodulation_series(const SeriesBatch& batch, const SeriesFrame& frame, ClosedSeries& found);

}  // namespace vybeg
