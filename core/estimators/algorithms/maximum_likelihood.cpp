#include "core/estimators/algorithms/maximum_likelihood.h"

#include "core/estimators/batch/carrier_sums.h"
#include "core/estimators/batch/series_estimates.h"
#include "core/estimators/batch/window_series.h"
#include "core/estimators/wave/profile.h"
#include "core/estimators/wave/window_estimate.h"

#include <cmath>

namespace vybeg {
namespace {

class MaximumLikelihood final : public Estimator {
public:
    explicit MaximumLikelihood(const EstimatorOptions& options)
        : options_(options),
          bracket_(main_lobe(options.f0_hz, options.rate_hz, options.length)),
          sums_(options.length, bracket_.centre) {}

    void estimate(const WindowBlock& block, double, std::span<WaveEstimate> out) override {
        SeriesBatch batch;
        SeriesMaximum maximum;
        SeriesEstimates waves;
        sums_.take(block, out.size());
        for (std::size_t first = 0, count = 0; first < out.size(); first += count) {
            count = sums_.next(first, batch, maximum);
            series_estimates(batch, maximum, sums_.frame(), waves);
            for (std::size_t lane = 0; lane < count; ++lane) {
                out[first + lane] =
                    estimate_lane(window_of(block, first + lane), batch, maximum, waves, lane);
            }
        }
    }

private:
    WaveEstimate estimate_lane(const Window& window, const SeriesBatch& batch,
                               const SeriesMaximum& maximum, const SeriesEstimates& waves,
                               std::size_t lane) const {
        const double power = batch.cc[lane] + batch.dd[lane];
        if (!std::isfinite(power)) {
            return no_estimate(Flag::gap);
        }
        if (maximum.arrived[lane] == 0) {
            return estimate_window(window);
        }
        return estimate_of_lane(waves, lane, window, {power, power - maximum.power[lane]},
                                options_);
    }

    // Far from the carrier the series does not reach: the window by itself, at its own frequency.
    WaveEstimate estimate_window(const Window& window) const {
        const ProfileMaximum maximum = maximise_profile(window, bracket_);
        FoundWave found{to_wave_state(maximum.phasors), maximum.phasors, maximum.w, 5, 0};
        if (maximum.at_bound) {
            set(found.flags, Flag::at_bound);
        }
        if (!maximum.converged) {
            set(found.flags, Flag::not_converged);
        }
        return complete_estimate(found, window, options_);
    }

    EstimatorOptions options_;
    FrequencyBracket bracket_;
    CarrierSums sums_;
};

}  // namespace

std::unique_ptr<Estimator> make_maximum_likelihood(const EstimatorOptions& options) {
    return std::make_unique<MaximumLikelihood>(options);
}

}  // namespace vybeg
