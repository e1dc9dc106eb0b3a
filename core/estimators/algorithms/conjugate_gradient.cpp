#include "core/estimators/algorithms/algorithms.h"
#include "core/estimators/batch/carrier_sums.h"
#include "core/estimators/batch/descent.h"
#include "core/estimators/batch/window_estimate.h"
#include "core/numerics/phase.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace vybeg {
namespace {

constexpr int most_steps = 200;

// Whether a sample of the span is missing (NaN).
bool has_gap(std::span<const double> samples) {
    return std::any_of(samples.begin(), samples.end(), [](double x) { return !std::isfinite(x); });
}

// n F and its derivatives by a_A, a_B, 2theta_A, alpha and w.
WaveFunctional<double> functional_at(const Window& window, const Five<double>& at) {
    return evaluate_functional({{at[0], at[1], at[2], at[3]}, at[4]}, window_moments(window, at[4]),
                               window_kernel(window.length(), at[4]));
}

class ConjugateGradient final : public Estimator {
public:
    explicit ConjugateGradient(const EstimatorOptions& options)
        : options_(options),
          bracket_(main_lobe(options.f0_hz, options.rate_hz, options.length)),
          sums_(options.length, bracket_.centre) {}

    bool sequential() const override { return options_.start == StartRule::previous; }

    void estimate(const WindowBlock& block, double centre_s, std::span<WaveEstimate> out) override {
        if (sequential()) {
            for (std::size_t k = 0; k < out.size(); ++k) {
                out[k] = estimate_next(window_of(block, k), centre_of(block, k, centre_s));
            }
            return;
        }
        sums_.take(block, out.size());
        ProjectionBatch batch;
        BatchMaximum maximum;
        BatchStart start;
        SeriesFit<Vec8> fits;
        for (std::size_t first = 0, count = 0; first < out.size(); first += count) {
            count = sums_.next(first, batch, maximum);
            const TaylorFrame& frame = sums_.frame();
            in_phase_starts(batch, frame, start);
            if (options_.initial) {
                for (std::size_t lane = 0; lane < lane_count; ++lane) {
                    const std::size_t k = first + std::min(lane, count - 1);
                    set_start(start, lane, typed_start(centre_of(block, k, centre_s)), frame);
                }
            }
            descend_batch(batch, frame, start, fits);
            for (std::size_t lane = 0; lane < count; ++lane) {
                const std::size_t k = first + lane;
                const Window window = window_of(block, k);
                const double power = batch.cc[lane] + batch.dd[lane];
                if (!std::isfinite(power)) {
                    out[k] = no_estimate(Flag::gap);
                } else if (fits.arrived[lane] > 0) {
                    out[k] = complete_estimate(lane_of(fits, lane), power, window, options_);
                } else {
                    const WaveParameters begin =
                        start_values(window, centre_of(block, k, centre_s));
                    out[k] = estimate_of(descend(window, bracket_, begin), window);
                }
            }
        }
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
        const double w = 2 * std::numbers::pi * options_.initial->f_hz / options_.rate_hz;
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

    EstimatorOptions options_;
    FrequencyBracket bracket_;
    CarrierSums sums_;
    std::optional<Previous> previous_;
};

}  // namespace

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
    const auto ended = [&](int steps, bool converged) {
        return Descent{{{at[0], at[1], at[2], at[3]}, at[4]}, steps, converged};
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
            return ended(steps, is_positive(f.hessian));
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
            return ended(steps, false);
        } else {
            since_restart = 0;
        }
    }
    return ended(most_steps, false);
}

std::unique_ptr<Estimator> make_conjugate_gradient(const EstimatorOptions& options) {
    return std::make_unique<ConjugateGradient>(options);
}

}  // namespace vybeg
