#include "core/estimators/algorithms/maximum_likelihood.h"

#include "core/estimators/batch/carrier_sums.h"
#include "core/estimators/batch/profile.h"
#include "core/estimators/batch/window_estimate.h"

#include <cmath>

namespace vybeg {
namespace {

VYBEG_DISPATCHED
void report_maximum(const ProjectionBatch& __restrict batch, const BatchMaximum& __restrict maximum,
                    const TaylorFrame& __restrict frame, WaveReport<Vec8>& __restrict waves) {
    const Vec8 x = load(maximum.x);
    const Jet2<Vec8> g = gram_jet(frame, x);
    const Vec8 by_cos = 1 / g.value;
    const Vec8 by_sin = 1 / (static_cast<double>(frame.length()) - g.value);
    const auto at = [x](const TaylorSums& sums) VYBEG_INLINED {
        return polynomial<taylor_orders>(
            x, [&](std::size_t k) VYBEG_INLINED { return load(sums[k]); });
    };
    const PhasorParts<Vec8> phasors{at(batch.c_cos) * by_cos, -at(batch.c_sin) * by_sin,
                                    at(batch.d_cos) * by_cos, -at(batch.d_sin) * by_sin};
    waves = report_batch(batch, frame, x, g, phasors, state_of(phasors));
}

class MaximumLikelihood final : public Estimator {
public:
    explicit MaximumLikelihood(const EstimatorOptions& options)
        : options_(options),
          bracket_(main_lobe(options.f0_hz, options.rate_hz, options.length)),
          sums_(options.length, bracket_.centre) {}

    void estimate(const WindowBlock& block, double, std::span<WaveEstimate> out) override {
        ProjectionBatch batch;
        BatchMaximum maximum;
        WaveReport<Vec8> waves;
        sums_.take(block, out.size());
        for (std::size_t first = 0, count = 0; first < out.size(); first += count) {
            count = sums_.next(first, batch, maximum);
            report_maximum(batch, maximum, sums_.frame(), waves);
            for (std::size_t lane = 0; lane < count; ++lane) {
                const Window window = window_of(block, first + lane);
                const double power = batch.cc[lane] + batch.dd[lane];
                if (!std::isfinite(power)) {
                    out[first + lane] = no_estimate(Flag::gap);
                } else if (maximum.arrived[lane] == 0) {
                    out[first + lane] = estimate_window(window);
                } else {
                    const WaveReport<double> wave = lane_of(waves, lane);
                    out[first + lane] = complete_estimate(
                        wave, {residual_of(power - maximum.power[lane], power, window, wave)},
                        options_);
                }
            }
        }
    }

private:
    // Estimate of a window beyond the reach of the series, from its samples at its own frequency.
    WaveEstimate estimate_window(const Window& window) const {
        const ProfileMaximum maximum = maximise_profile(window, bracket_);
        Flags flags = 0;
        if (maximum.at_bound) {
            set(flags, Flag::at_bound);
        }
        if (!maximum.converged) {
            set(flags, Flag::not_converged);
        }
        return complete_estimate(maximum.phasors, maximum.w, flags, window, options_);
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
