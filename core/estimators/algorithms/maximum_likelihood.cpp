#include "core/estimators/algorithms/algorithms.h"
#include "core/estimators/batch/carrier_sums.h"
#include "core/estimators/batch/profile.h"
#include "core/estimators/batch/window_estimate.h"

#include <cmath>

namespace vybeg {
namespace {

VYBEG_DISPATCHED
void report_maximum(const ProjectionBatch& __restrict batch, const BatchMaximum& __restrict maximum,
                    const TaylorFrame& __restrict frame, SeriesFit<Vec8>& __restrict fits) {
    const Vec8 x = load(maximum.x);
    const WindowJets<Vec8> s = jets_at(batch, frame, x);
    const Vec8 by_cos = 1 / s.g.value;
    const Vec8 by_sin = 1 / s.h.value;
    const PhasorParts<Vec8> phasors{s.pc.value * by_cos, -s.qc.value * by_sin, s.pd.value * by_cos,
                                    -s.qd.value * by_sin};
    fits.residual = load(batch.cc) + load(batch.dd) - load(maximum.power);
    fits.motion = motion_power(s, spread_by_x(frame));
    fits.arrived = load(maximum.arrived);
    fits.wave = report_batch(batch, frame, x, s.g, phasors, state_of(phasors));
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
        SeriesFit<Vec8> fits;
        sums_.take(block, out.size());
        for (std::size_t first = 0, count = 0; first < out.size(); first += count) {
            count = sums_.next(first, batch, maximum);
            report_maximum(batch, maximum, sums_.frame(), fits);
            for (std::size_t lane = 0; lane < count; ++lane) {
                const Window window = window_of(block, first + lane);
                const double power = batch.cc[lane] + batch.dd[lane];
                if (!std::isfinite(power)) {
                    out[first + lane] = no_estimate(Flag::gap);
                } else if (maximum.arrived[lane] == 0) {
                    out[first + lane] = estimate_window(window);
                } else {
                    out[first + lane] =
                        complete_estimate(lane_of(fits, lane), power, window, options_);
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
