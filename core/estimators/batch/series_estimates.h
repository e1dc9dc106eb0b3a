#pragma once

#include "core/estimators/batch/series_result.h"
#include "core/estimators/batch/window_series.h"
#include "core/estimators/wave/estimator.h"
#include "core/estimators/wave/window_estimate.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace vybeg {

// wave_state.h, precision_bound.h and (30) for all lanes at once, at the frequencies of `maximum`.
void series_estimates(const SeriesBatch& batch, const SeriesMaximum& maximum,
                      const SeriesFrame& frame, SeriesEstimates& estimates);

// What else an estimate is made of.
struct LaneResidual {
    double power = 0;       // of the window, sum C^2 + D^2
    double difference = 0;  // the power less what the wave takes of it
    int parameters = 5;     // that were fitted
    Flags flags = 0;
    std::optional<BestWave> best = std::nullopt;  // algorithms 1 to 4
};

// One lane as an estimate: noise and standard deviations from the residual, and without what does
// not exist (window_estimate.h).
WaveEstimate estimate_of_lane(const SeriesEstimates& waves, std::size_t lane, const Window& window,
                              const LaneResidual& residual, const EstimatorOptions& options);

}  // namespace vybeg
