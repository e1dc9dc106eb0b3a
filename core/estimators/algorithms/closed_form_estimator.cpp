#include "core/estimators/algorithms/algorithms.h"
#include "core/estimators/batch/carrier_sums.h"
#include "core/estimators/batch/closed_forms.h"
#include "core/estimators/batch/window_estimate.h"
#include "core/numerics/fractional_delay.h"
#include "core/numerics/minimise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace vybeg {
namespace {

constexpr double pi = std::numbers::pi;

class ClosedFormEstimator final : public Estimator {
public:
    ClosedFormEstimator(Algorithm algorithm, const EstimatorOptions& options)
        : algorithm_(closed_form_algorithm(algorithm)),
          options_(options),
          bracket_(main_lobe(options.f0_hz, options.rate_hz, options.length)),
          sums_(options.length, bracket_.centre),
          quarter_period_(options.rate_hz / (4 * options.f0_hz)) {
        if (algorithm_.delays) {
            delay_.emplace(quarter_period_);
        }
    }

    std::int64_t context() const override {
        return delay_ ? std::max(delay_->reach_before(), delay_->reach_after()) : 0;
    }

    void estimate(const WindowBlock& block, double, std::span<WaveEstimate> out) override {
        const std::vector<double> delayed = quarter_delayed(block);
        sums_.take(block, out.size(), delayed);
        ProjectionBatch batch;
        BatchMaximum maximum;
        ClosedFit<Vec8> fits;
        for (std::size_t first = 0, count = 0; first < out.size(); first += count) {
            count = sums_.next(first, batch, maximum);
            algorithm_.fit_batch(batch, sums_.frame(), form_frame(sums_.frame(), quarter_period_),
                                 fits);
            for (std::size_t lane = 0; lane < count; ++lane) {
                const Window window = window_of(block, first + lane);
                const double power = batch.cc[lane] + batch.dd[lane];
                if (!std::isfinite(power)) {
                    // A missing sample makes the whole sum NaN.
                    out[first + lane] = no_estimate(Flag::gap);
                } else if (!std::isfinite(batch.cq[lane])) {
                    out[first + lane] = no_estimate(Flag::delay_reach);
                } else if (fits.arrived[lane] > 0) {
                    const ClosedFit<double> fit = lane_of(fits, lane);
                    out[first + lane] =
                        complete(window, power, fit.residual, fit.wave, fit.best, 0);
                } else {
                    out[first + lane] = estimate_window(window, batch, lane);
                }
            }
        }
    }

private:
    // S_D delayed by a quarter period where the algorithm needs it; NaN where the delay reaches
    // outside.
    std::vector<double> quarter_delayed(const WindowBlock& block) const {
        if (!delay_) {
            return {};
        }
        const auto frames = static_cast<std::int64_t>(block.d.size());
        std::vector<double> delayed(block.d.size(), std::numeric_limits<double>::quiet_NaN());
        const std::int64_t from = std::max(block.first, delay_->reach_before());
        const std::int64_t to = frames - delay_->reach_after();
        if (from < to) {
            delay_->apply(block.d, from,
                          std::span(delayed).subspan(static_cast<std::size_t>(from),
                                                     static_cast<std::size_t>(to - from)));
        }
        return delayed;
    }

    WaveEstimate complete(const Window& window, double power, double residual,
                          const WaveReport<double>& wave, const BestWave& best, Flags flags) const {
        const double steady = without_motion(residual_of(power - best.power, power, window,
                                                         parts_of(to_phasors(best.state)), best.w),
                                             best.motion);
        return complete_estimate(
            wave,
            {residual_of(residual, power, window, wave), steady, algorithm_.parameters,
             static_cast<Flags>(algorithm_.flags | flags), &best},
            options_);
    }

    // Minimum of J by a search over the main lobe, for windows in which Newton's steps on the
    // series do not converge.
    WaveEstimate estimate_window(const Window& window, const ProjectionBatch& batch,
                                 std::size_t lane) const {
        const TaylorFrame& frame = sums_.frame();
        const std::int64_t n = frame.length();
        const auto count = static_cast<double>(n);
        const SampleProducts sum{batch.cc[lane], batch.dd[lane], batch.cd[lane], batch.cq[lane]};
        const double power = sum.cc + sum.dd;
        const FormFrame form = form_frame(frame, quarter_period_);
        const auto x_at = [&](double w) { return 0.5 * count * (w - frame.w0()); };
        // Within the reach of the series the kernel follows from the series.
        const auto kernel_at = [&](double w) {
            return std::abs(x_at(w)) > closed_form_reach ? window_kernel(n, w)
                                                         : frame.kernel(x_at(w));
        };
        const auto jets_at = [&](double w) {
            const double x = x_at(w);
            return jets_of(std::abs(x) > closed_form_reach ? window_projections(window, w)
                                                           : lane_projections(batch, lane, x),
                           kernel_at(w));
        };
        // The minimum of J lies near that of the best wave, within the window's leakage; the search
        // starts there.
        const ProfileMaximum best = maximise_profile(window, bracket_);
        const double lobe = 2 * pi / count;
        const Minimum minimum = minimise(
            [&](double w) { return power + algorithm_.functional(sum, form, jets_at(w), x_at(w)); },
            bracket_.low, best.w, bracket_.high, 1e-3 * lobe, 1e-9 * lobe);
        const double w = minimum.at;
        const ClosedWave<double> closed = algorithm_.wave(sum, form, jets_at(w), x_at(w));
        Flags flags = 0;
        if (minimum.at_bound) {
            set(flags, Flag::at_bound);
        }
        return complete(window, power, minimum.value,
                        report_wave(sum, w, kernel_at(w), closed.phasors, closed.wave),
                        best_wave(best.phasors, best.w, window), flags);
    }

    ClosedFormAlgorithm algorithm_;
    EstimatorOptions options_;
    FrequencyBracket bracket_;
    CarrierSums sums_;
    double quarter_period_;  // of the carrier, samples
    std::optional<FractionalDelay> delay_;
};

}  // namespace

WaveState in_phase_start(const Window& window, double w) {
    const std::int64_t n = window.length();
    const WindowJets<double> jets = jets_of(window_projections(window, w), window_kernel(n, w));
    return InPhaseForm<double>(sample_products(window), {static_cast<double>(n)})
        .at(jets, 0)
        .wave.wave;
}

std::unique_ptr<Estimator> make_closed_form(Algorithm algorithm, const EstimatorOptions& options) {
    return std::make_unique<ClosedFormEstimator>(algorithm, options);
}

}  // namespace vybeg
