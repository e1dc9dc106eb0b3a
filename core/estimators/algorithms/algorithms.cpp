#include "core/estimators/batch/carrier_sums.h"
#include "core/estimators/batch/closed_forms.h"
#include "core/estimators/batch/descent.h"
#include "core/estimators/batch/window_estimate.h"
#include "core/estimators/wave/estimator.h"
#include "core/numerics/fractional_delay.h"
#include "core/numerics/minimise.h"
#include "core/numerics/phase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace vybeg {
namespace {

constexpr double pi = std::numbers::pi;

// Estimates of a block, eight windows at a time by their series.
class BlockEstimator : public Estimator {
public:
    explicit BlockEstimator(const EstimatorOptions& options)
        : options_(options),
          bracket_(main_lobe(options.f0_hz, options.rate_hz, options.length)),
          sums_(options.length, bracket_.centre) {}

protected:
    // Calls fit(first, count) for the windows of one reference, whose sums are batch_ and maximum_,
    // then takes one(k, lane, window, power) for each of them without a gap.
    template <class Fit, class One>
    void for_windows(const WindowBlock& block, std::span<WaveEstimate> out, const Fit& fit,
                     const One& one, std::span<const double> delayed = {}) {
        sums_.take(block, out.size(), delayed);
        for (std::size_t first = 0, count = 0; first < out.size(); first += count) {
            count = sums_.next(first, batch_, maximum_);
            fit(first, count);
            for (std::size_t lane = 0; lane < count; ++lane) {
                const std::size_t k = first + lane;
                // A missing sample makes the whole sum NaN.
                const double power = batch_.cc[lane] + batch_.dd[lane];
                out[k] = std::isfinite(power) ? one(k, lane, window_of(block, k), power)
                                              : no_estimate(Flag::gap);
            }
        }
    }

    // Likewise where all five parameters follow from the series: fit(first, count, fits). Takes
    // alone(k, window) where the steps have not arrived.
    template <class Fit, class Alone>
    void for_series(const WindowBlock& block, std::span<WaveEstimate> out, const Fit& fit,
                    const Alone& alone) {
        SeriesFit<Vec8> fits;
        for_windows(
            block, out, [&](std::size_t first, std::size_t count) { fit(first, count, fits); },
            [&](std::size_t k, std::size_t lane, const Window& window, double power) {
                if (!(fits.arrived[lane] > 0)) {
                    return alone(k, window);
                }
                const SeriesFit<double> found = lane_of(fits, lane);
                const double residual =
                    residual_of(found.residual, power, window, found.wave.phasors, found.wave.w);
                return complete_estimate(
                    found.wave, {residual, without_motion(residual, found.motion)}, options_);
            });
    }

    EstimatorOptions options_;
    FrequencyBracket bracket_;
    CarrierSums sums_;
    ProjectionBatch batch_{};
    BatchMaximum maximum_{};
};

// The article's algorithms 1 to 4: four parameters in closed form at a given frequency, and the
// frequency from the minimum of J, (16), (25), (29), in one parameter.
template <template <class> class Form, FitBatch fit_batch>
class ClosedFormEstimator final : public BlockEstimator {
public:
    explicit ClosedFormEstimator(const EstimatorOptions& options)
        : BlockEstimator(options), quarter_period_(options.rate_hz / (4 * options.f0_hz)) {
        if (Form<double>::delays) {
            delay_.emplace(quarter_period_);
        }
    }

    std::int64_t context() const override {
        return delay_ ? std::max(delay_->reach_before(), delay_->reach_after()) : 0;
    }

    void estimate(const WindowBlock& block, double, std::span<WaveEstimate> out) override {
        const std::vector<double> delayed = quarter_delayed(block);
        ClosedFit<Vec8> fits;
        for_windows(
            block, out,
            [&](std::size_t, std::size_t) {
                fit_batch(batch_, sums_.frame(), form_frame(sums_.frame(), quarter_period_), fits);
            },
            [&](std::size_t, std::size_t lane, const Window& window, double power) {
                if (!std::isfinite(batch_.cq[lane])) {
                    return no_estimate(Flag::delay_reach);
                }
                if (!(fits.arrived[lane] > 0)) {
                    return estimate_window(window, lane);
                }
                const ClosedFit<double> fit = lane_of(fits, lane);
                return complete(window, power, fit.residual, fit.wave, fit.best, 0);
            },
            delayed);
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
        const double of_best =
            residual_of(power - best.power, power, window, phasors_of(turned(best.state)), best.w);
        if (!Form<double>::has_quadrature) {
            set(flags, Flag::no_quadrature);
        }
        return complete_estimate(wave,
                                 {residual_of(residual, power, window, wave.phasors, wave.w),
                                  without_motion(of_best, best.motion), flags, &best},
                                 options_);
    }

    // Minimum of J by a search over the main lobe, for windows in which Newton's steps on the
    // series do not converge.
    WaveEstimate estimate_window(const Window& window, std::size_t lane) const {
        const TaylorFrame& frame = sums_.frame();
        const std::int64_t n = frame.length();
        const auto count = static_cast<double>(n);
        const SampleProducts sum{batch_.cc[lane], batch_.dd[lane], batch_.cd[lane],
                                 batch_.cq[lane]};
        const double power = sum.cc + sum.dd;
        const Form<double> form(sum, form_frame(frame, quarter_period_));
        const auto x_at = [&](double w) { return 0.5 * count * (w - frame.w0()); };
        // Within the reach of the series the kernel follows from the series.
        const auto kernel_at = [&](double w) {
            return std::abs(x_at(w)) > closed_form_reach ? window_kernel(n, w)
                                                         : frame.kernel(x_at(w));
        };
        const auto jets_at = [&](double w) {
            const double x = x_at(w);
            return jets_of(std::abs(x) > closed_form_reach ? window_projections(window, w)
                                                           : lane_projections(batch_, lane, x),
                           kernel_at(w));
        };
        // The minimum of J lies near that of the best wave, within the window's leakage; the search
        // starts there.
        const ProfileMaximum best = maximise_profile(window, bracket_);
        const double lobe = 2 * pi / count;
        const Minimum minimum =
            minimise([&](double w) { return power + form.functional(jets_at(w), x_at(w)).value; },
                     bracket_.low, best.w, bracket_.high, 1e-3 * lobe, 1e-9 * lobe);
        const double w = minimum.at;
        const ClosedWave<double> closed = form.at(jets_at(w), x_at(w));
        Flags flags = 0;
        if (minimum.at_bound) {
            set(flags, Flag::at_bound);
        }
        return complete(window, power, minimum.value,
                        report_wave(sum, w, kernel_at(w), closed.phasors, closed.wave),
                        best_wave(best.phasors, best.w, window), flags);
    }

    double quarter_period_;  // of the carrier, samples
    std::optional<FractionalDelay> delay_;
};

// Whether a sample of the span is missing (NaN).
bool has_gap(std::span<const double> samples) {
    return std::any_of(samples.begin(), samples.end(), [](double x) { return !std::isfinite(x); });
}

// Algorithm 5: the article's conjugate gradient over all five parameters at once, with the analytic
// gradient and Hessian of F.
class ConjugateGradient final : public BlockEstimator {
public:
    using BlockEstimator::BlockEstimator;

    bool sequential() const override { return options_.start == StartRule::previous; }

    void estimate(const WindowBlock& block, double centre_s, std::span<WaveEstimate> out) override {
        if (sequential()) {
            for (std::size_t k = 0; k < out.size(); ++k) {
                out[k] = estimate_next(window_of(block, k), centre_of(block, k, centre_s));
            }
            return;
        }
        BatchStart start;
        for_series(
            block, out,
            [&](std::size_t first, std::size_t count, SeriesFit<Vec8>& fits) {
                const TaylorFrame& frame = sums_.frame();
                in_phase_starts(batch_, frame, start);
                for (std::size_t lane = 0; options_.initial && lane < lane_count; ++lane) {
                    const std::size_t k = first + std::min(lane, count - 1);
                    set_start(start, lane, typed_start(centre_of(block, k, centre_s)), frame);
                }
                descend_batch(batch_, frame, start, fits);
            },
            [&](std::size_t k, const Window& window) {
                const Five<double> begin = start_values(window, centre_of(block, k, centre_s));
                return estimate_of(descend(window, bracket_, begin), window);
            });
    }

private:
    struct Previous {
        Five<double> at{};
        double centre_s = 0;
    };

    // The same wave at the centre of another window, with continuous tau = w u - alpha.
    Five<double> carried(Five<double> wave, double from_s, double to_s) const {
        // Wrapped, because the phase of a long recording would otherwise lose digits.
        wave[3] = wrap(wave[3] - wave[4] * options_.rate_hz * (to_s - from_s));
        return wave;
    }

    double centre_of(const WindowBlock& block, std::size_t k, double first_s) const {
        return first_s + static_cast<double>(k) * static_cast<double>(block.hop) / options_.rate_hz;
    }

    Five<double> typed_start(double centre_s) const {
        const double w = 2 * pi * options_.initial->f_hz / options_.rate_hz;
        return carried(five_of(options_.initial->state, w), options_.first_centre_s, centre_s);
    }

    Five<double> start_values(const Window& window, double centre_s) const {
        return options_.initial ? typed_start(centre_s) : in_phase_start(window, bracket_.centre);
    }

    void set_start(BatchStart& start, std::size_t lane, Five<double> values,
                   const TaylorFrame& frame) const {
        values[4] = 0.5 * static_cast<double>(options_.length) * (values[4] - frame.w0());
        for (std::size_t k = 0; k < values.size(); ++k) {
            start[k][lane] = values[k];
        }
    }

    WaveEstimate estimate_of(const Descent& descent, const Window& window) const {
        Flags flags = 0;
        if (!descent.converged) {
            set(flags, Flag::not_converged);
        }
        const auto& [a_A, a_B, two_theta_A, alpha, w] = descent.at;
        return complete_estimate(to_phasors({a_A, a_B, two_theta_A, alpha}), w, flags, window,
                                 options_);
    }

    // Starts from the window before if that one converged.
    WaveEstimate estimate_next(const Window& window, double centre_s) {
        if (has_gap(window.c) || has_gap(window.d)) {
            previous_.reset();
            return no_estimate(Flag::gap);
        }
        const Descent found =
            descend(window, bracket_,
                    previous_ ? carried(previous_->at, previous_->centre_s, centre_s)
                              : start_values(window, centre_s));
        if (found.converged) {
            previous_ = Previous{found.at, centre_s};
        }
        return estimate_of(found, window);
    }

    std::optional<Previous> previous_;
};

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

// Algorithm 6: least squares over all five parameters by variable projection (METHOD section 5.6),
// which in white noise is maximum likelihood. Exact for every window of at least least_window()
// samples.
class MaximumLikelihood final : public BlockEstimator {
public:
    using BlockEstimator::BlockEstimator;

    void estimate(const WindowBlock& block, double, std::span<WaveEstimate> out) override {
        for_series(
            block, out,
            [&](std::size_t, std::size_t, SeriesFit<Vec8>& fits) {
                report_maximum(batch_, maximum_, sums_.frame(), fits);
            },
            // Beyond the reach of the series: from the samples at the window's own frequency.
            [&](std::size_t, const Window& window) {
                const ProfileMaximum maximum = maximise_profile(window, bracket_);
                return complete_estimate(maximum.phasors, maximum.w, maximum.flags, window,
                                         options_);
            });
    }
};

}  // namespace

std::unique_ptr<Estimator> make_estimator(Algorithm algorithm, const EstimatorOptions& options) {
    switch (algorithm) {
        case Algorithm::in_phase:
            return std::make_unique<ClosedFormEstimator<InPhaseForm, fit_in_phase>>(options);
        case Algorithm::phase_shift:
            return std::make_unique<ClosedFormEstimator<PhaseShiftForm, fit_phase_shift>>(options);
        case Algorithm::moving_axes:
            return std::make_unique<ClosedFormEstimator<MovingAxesForm, fit_moving_axes>>(options);
        case Algorithm::demodulation:
            return std::make_unique<ClosedFormEstimator<DemodulationForm, fit_demodulation>>(
                options);
        case Algorithm::conjugate_gradient: return std::make_unique<ConjugateGradient>(options);
        case Algorithm::maximum_likelihood: return std::make_unique<MaximumLikelihood>(options);
    }
    return nullptr;
}

}  // namespace vybeg
