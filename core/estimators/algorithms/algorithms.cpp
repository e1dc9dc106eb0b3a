#include "core/estimators/algorithms/algorithms.h"

#include "core/estimators/batch/carrier_sums.h"
#include "core/estimators/batch/closed_forms.h"
#include "core/estimators/batch/window_estimate.h"
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
constexpr int most_steps = 200;

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
                return fits.arrived[lane] > 0
                           ? complete_estimate(lane_of(fits, lane), power, window, options_)
                           : alone(k, window);
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
class ClosedFormEstimator final : public BlockEstimator {
public:
    ClosedFormEstimator(Algorithm algorithm, const EstimatorOptions& options)
        : BlockEstimator(options),
          algorithm_(closed_form_algorithm(algorithm)),
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
        ClosedFit<Vec8> fits;
        for_windows(
            block, out,
            [&](std::size_t, std::size_t) {
                algorithm_.fit_batch(batch_, sums_.frame(),
                                     form_frame(sums_.frame(), quarter_period_), fits);
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
    WaveEstimate estimate_window(const Window& window, std::size_t lane) const {
        const TaylorFrame& frame = sums_.frame();
        const std::int64_t n = frame.length();
        const auto count = static_cast<double>(n);
        const SampleProducts sum{batch_.cc[lane], batch_.dd[lane], batch_.cd[lane],
                                 batch_.cq[lane]};
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
                                                           : lane_projections(batch_, lane, x),
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
    double quarter_period_;  // of the carrier, samples
    std::optional<FractionalDelay> delay_;
};

// Whether a sample of the span is missing (NaN).
bool has_gap(std::span<const double> samples) {
    return std::any_of(samples.begin(), samples.end(), [](double x) { return !std::isfinite(x); });
}

// n F and its derivatives by a_A, a_B, 2theta_A, alpha and w.
WaveFunctional<double> functional_at(const Window& window, const Five<double>& at) {
    return evaluate_functional({{at[0], at[1], at[2], at[3]}, at[4]}, window_moments(window, at[4]),
                               window_kernel(window.length(), at[4]));
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
                const WaveParameters begin = start_values(window, centre_of(block, k, centre_s));
                return estimate_of(descend(window, bracket_, begin), window);
            });
    }

private:
    struct Previous {
        WaveParameters parameters;
        double centre_s = 0;
    };

    // The same wave at the centre of another window, with continuous tau = w u - alpha.
    WaveParameters carried(const WaveParameters& from, double from_s, double to_s) const {
        WaveParameters to = from;
        // Wrapped, because the phase of a long recording would otherwise lose digits.
        to.state.alpha = wrap(to.state.alpha - from.w * options_.rate_hz * (to_s - from_s));
        return to;
    }

    double centre_of(const WindowBlock& block, std::size_t k, double first_s) const {
        return first_s + static_cast<double>(k) * static_cast<double>(block.hop) / options_.rate_hz;
    }

    WaveParameters typed_start(double centre_s) const {
        const double w = 2 * pi * options_.initial->f_hz / options_.rate_hz;
        return carried({options_.initial->state, w}, options_.first_centre_s, centre_s);
    }

    WaveParameters start_values(const Window& window, double centre_s) const {
        if (options_.initial) {
            return typed_start(centre_s);
        }
        return {in_phase_start(window, bracket_.centre), bracket_.centre};
    }

    void set_start(BatchStart& start, std::size_t lane, const WaveParameters& values,
                   const TaylorFrame& frame) const {
        const auto& [a_A, a_B, two_theta_A, alpha] = values.state;
        const double x = 0.5 * static_cast<double>(options_.length) * (values.w - frame.w0());
        const Five<double> five{a_A, a_B, two_theta_A, alpha, x};
        for (std::size_t k = 0; k < five.size(); ++k) {
            start[k][lane] = five[k];
        }
    }

    WaveEstimate estimate_of(const Descent& descent, const Window& window) const {
        Flags flags = 0;
        if (!descent.converged) {
            set(flags, Flag::not_converged);
        }
        const WaveParameters& found = descent.parameters;
        return complete_estimate(to_phasors(found.state), found.w, flags, window, options_);
    }

    // Starts from the window before if that one converged.
    WaveEstimate estimate_next(const Window& window, double centre_s) {
        if (has_gap(window.c) || has_gap(window.d)) {
            previous_.reset();
            return no_estimate(Flag::gap);
        }
        const Descent found =
            descend(window, bracket_,
                    previous_ ? carried(previous_->parameters, previous_->centre_s, centre_s)
                              : start_values(window, centre_s));
        if (found.converged) {
            previous_ = Previous{found.parameters, centre_s};
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

WaveState in_phase_start(const Window& window, double w) {
    const std::int64_t n = window.length();
    const WindowJets<double> jets = jets_of(window_projections(window, w), window_kernel(n, w));
    return InPhaseForm<double>(sample_products(window), {static_cast<double>(n)})
        .at(jets, 0)
        .wave.wave;
}

Descent descend(const Window& window, const FrequencyBracket& bracket,
                const WaveParameters& start) {
    const std::int64_t length = window.length();
    const auto n = static_cast<double>(length);
    const double edge = 1e-6 * (bracket.high - bracket.low);
    const WaveState& state = start.state;
    Five<double> at{state.a_A, state.a_B, state.two_theta_A, state.alpha,
                    std::clamp(start.w, bracket.low + edge, bracket.high - edge)};
    const double tolerance = descent_tolerance(at[4], length);
    const double spread = window_kernel(length, at[4]).spread;
    const auto ended = [&at](bool converged) {
        return Descent{{{at[0], at[1], at[2], at[3]}, at[4]}, converged};
    };
    WaveFunctional<double> f = functional_at(window, at);
    Preconditioner<double> scale(at, n, spread, 1);
    Five<double> direction{};
    int since_restart = 0;
    for (int steps = 0; steps < most_steps; ++steps) {
        if (since_restart == 0) {
            scale = Preconditioner<double>(at, n, spread, 1);
            direction = {};
        }
        const Five<double> scaled = scale.apply(f.gradient);
        // g.M^-1.g / n is the mean squared change of the samples by the remaining steps.
        if (dot(f.gradient, scaled) <= tolerance * tolerance * power_of(at) * n) {
            return ended(is_positive(f.hessian));
        }
        const DescentWay<double> way = next_way(f, scaled, direction);
        direction = way.direction;
        // Point after the exact step, or after the first shorter step that descends. Where F is not
        // convex along the direction, the preconditioned length of the direction is the step.
        const double exact = way.curvature > 0 ? -way.slope / way.curvature : 1;
        constexpr int most_halvings = 30;
        int halving = 0;
        for (double step = exact; halving < most_halvings; ++halving, step /= 2) {
            const Five<double> to = moved(at, direction, step);
            if (!bracket.contains(to[4])) {
                continue;
            }
            const WaveFunctional<double> there = functional_at(window, to);
            if (excess_of(there.value, f.value, step, way.slope) <= 0) {
                at = to;
                f = there;
                break;
            }
        }
        if (halving < most_halvings) {
            since_restart = (since_restart + 1) % descent_restart;
        } else if (since_restart == 0) {
            return ended(false);
        } else {
            since_restart = 0;
        }
    }
    return ended(false);
}

std::unique_ptr<Estimator> make_estimator(Algorithm algorithm, const EstimatorOptions& options) {
    switch (algorithm) {
        case Algorithm::in_phase:
        case Algorithm::phase_shift:
        case Algorithm::moving_axes:
        case Algorithm::demodulation:
            return std::make_unique<ClosedFormEstimator>(algorithm, options);
        case Algorithm::conjugate_gradient: return std::make_unique<ConjugateGradient>(options);
        case Algorithm::maximum_likelihood: return std::make_unique<MaximumLikelihood>(options);
    }
    return nullptr;
}

}  // namespace vybeg
