#include "core/estimators/conjugate_gradient.h"

#include "core/estimators/carrier_sums.h"
#include "core/estimators/closed_form.h"
#include "core/estimators/series_descent.h"
#include "core/estimators/window_estimate.h"
#include "core/numerics/phase.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace vybeg {
namespace {

constexpr int most_steps = 200;

Functional functional_at(const Window& window, const WaveParameters& at) {
    return evaluate_functional(at, window_moments(window, at.w),
                               window_kernel(window.length(), at.w));
}

// The Hessian that F has in an ideal window without noise, inverted: the natural scale of each
// parameter. Angle and phase are coupled through the quadrature wave; where a_A = |a_B| the
// coupling is total, and is held just below.
class Preconditioner {
public:
    Preconditioner(const WaveState& state, const WindowKernel& kernel, std::int64_t n) {
        const double power = state.a_A * state.a_A + state.a_B * state.a_B;
        const double product = std::clamp(2 * state.a_A * state.a_B, -0.999 * power, 0.999 * power);
        const double determinant = power * power - product * product;
        amplitude_ = 1 / static_cast<double>(n);
        same_ = amplitude_ * power / determinant;
        cross_ = amplitude_ * product / determinant;
        frequency_ = 1 / (power * kernel.spread);
    }

    Vector5 apply(const Vector5& g) const {
        Vector5 scaled;
        scaled << amplitude_ * g[0], amplitude_ * g[1], same_ * g[2] + cross_ * g[3],
            cross_ * g[2] + same_ * g[3], frequency_ * g[4];
        return scaled;
    }

private:
    double amplitude_ = 0;
    double same_ = 0;
    double cross_ = 0;
    double frequency_ = 0;
};

WaveParameters moved(const WaveParameters& from, const Vector5& direction, double step) {
    WaveParameters to = from;
    to.state.a_A += step * direction[0];
    to.state.a_B += step * direction[1];
    to.state.two_theta_A += step * direction[2];
    to.state.alpha += step * direction[3];
    to.w += step * direction[4];
    return to;
}

struct Step {
    WaveParameters parameters;
    Functional functional;
};

// The point that the exact step reaches, or the first of shorter ones that descends.
std::optional<Step> line_search(const Window& window, const FrequencyBracket& bracket,
                                const WaveParameters& from, const Functional& f,
                                const Vector5& direction) {
    const double slope = f.gradient.dot(direction);
    const double curvature = direction.dot(f.hessian * direction);
    // Where F is not convex along the direction, its preconditioned length is the best guess of a
    // step.
    double step = curvature > 0 ? -slope / curvature : 1;
    // What F can resolve: it is a difference of sums of squares.
    const double rounding = 1e-14 * (std::abs(f.value) + std::abs(slope * step));
    constexpr int most_halvings = 30;
    for (int halving = 0; halving < most_halvings; ++halving, step /= 2) {
        const WaveParameters to = moved(from, direction, step);
        if (!bracket.contains(to.w)) {
            continue;
        }
        const Functional there = functional_at(window, to);
        if (there.value <= f.value + 1e-4 * step * slope + rounding) {
            return Step{to, there};
        }
    }
    return std::nullopt;
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
        SeriesBatch batch;
        SeriesMaximum maximum;
        SeriesStart start;
        SeriesDescent descent;
        for (std::size_t first = 0, count = 0; first < out.size(); first += count) {
            count = sums_.next(first, batch, maximum);
            const SeriesFrame& frame = sums_.frame();
            in_phase_starts(batch, frame, start);
            if (options_.initial) {
                for (std::size_t lane = 0; lane < series_lanes; ++lane) {
                    const std::size_t k = first + std::min(lane, count - 1);
                    set_start(start, lane, typed_start(centre_of(block, k, centre_s)), frame);
                }
            }
            descend_series(batch, frame, start, descent);
            for (std::size_t lane = 0; lane < count; ++lane) {
                const std::size_t k = first + lane;
                const Window window = window_of(block, k);
                const double power = batch.cc[lane] + batch.dd[lane];
                if (!std::isfinite(power)) {
                    out[k] = no_estimate(Flag::gap);
                } else if (descent.arrived[lane] > 0) {
                    out[k] = estimate_of_lane(descent.waves, lane, window,
                                              {power, descent.residual[lane]}, options_);
                } else {
                    out[k] =
                        estimate_window(window, start_values(window, centre_of(block, k, centre_s)))
                            .estimate;
                }
            }
        }
    }

private:
    struct Previous {
        WaveParameters parameters;
        double centre_s = 0;
    };

    // The same wave at another window's centre: tau = w u - alpha goes on.
    WaveParameters carried(const WaveParameters& from, double from_s, double to_s) const {
        WaveParameters to = from;
        // Wrapped, or the phase of a long recording would lose its digits.
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

    void set_start(SeriesStart& start, std::size_t lane, const WaveParameters& values,
                   const SeriesFrame& frame) const {
        start.a_A[lane] = values.state.a_A;
        start.a_B[lane] = values.state.a_B;
        start.two_theta_A[lane] = values.state.two_theta_A;
        start.alpha[lane] = values.state.alpha;
        start.x[lane] = 0.5 * static_cast<double>(options_.length) * (values.w - frame.w0());
    }

    struct Estimated {
        WaveEstimate estimate;
        Descent descent;
    };

    Estimated estimate_window(const Window& window, const WaveParameters& start) const {
        const Descent descent = descend(window, bracket_, start);
        const WaveParameters& found = descent.parameters;
        Flags flags = 0;
        if (!descent.converged) {
            set(flags, Flag::not_converged);
        }
        const Phasors phasors = to_phasors(found.state);
        return {complete_estimate({canonical(found.state), phasors, found.w, 5, flags}, window,
                                  options_),
                descent};
    }

    // From the window before, where that has been found.
    WaveEstimate estimate_next(const Window& window, double centre_s) {
        if (has_gap(window.c) || has_gap(window.d)) {
            previous_.reset();
            return no_estimate(Flag::gap);
        }
        const Estimated found = estimate_window(
            window, previous_ ? carried(previous_->parameters, previous_->centre_s, centre_s)
                              : start_values(window, centre_s));
        if (found.descent.converged) {
            previous_ = Previous{found.descent.parameters, centre_s};
        }
        return found.estimate;
    }

    EstimatorOptions options_;
    FrequencyBracket bracket_;
    CarrierSums sums_;
    std::optional<Previous> previous_;
};

}  // namespace

Descent descend(const Window& window, const FrequencyBracket& bracket,
                const WaveParameters& start) {
    const std::int64_t n = window.length();
    WaveParameters at = start;
    at.w = std::clamp(at.w, bracket.low + 1e-6 * (bracket.high - bracket.low),
                      bracket.high - 1e-6 * (bracket.high - bracket.low));
    const double tolerance = descent_tolerance(at.w, n);
    Functional f = functional_at(window, at);
    Vector5 direction = Vector5::Zero();
    std::optional<Preconditioner> scale;
    int since_restart = 0;
    for (int steps = 0; steps < most_steps; ++steps) {
        if (since_restart == 0) {
            scale.emplace(at.state, window_kernel(n, at.w), n);
            direction.setZero();
        }
        const Vector5 scaled = scale->apply(f.gradient);
        const double power = at.state.a_A * at.state.a_A + at.state.a_B * at.state.a_B;
        // g.M^-1.g / n is the mean squared change of the samples that is still to come.
        if (f.gradient.dot(scaled) <= tolerance * tolerance * power * static_cast<double>(n)) {
            const bool minimum = f.hessian.llt().info() == Eigen::Success;
            return {at, steps, minimum};
        }
        // Conjugate to the direction before with respect to the Hessian here.
        const Vector5 bent = f.hessian * direction;
        const double curvature = direction.dot(bent);
        const double beta = curvature > 0 ? scaled.dot(bent) / curvature : 0;
        direction = -scaled + beta * direction;
        if (f.gradient.dot(direction) >= 0) {
            direction = -scaled;
        }
        const std::optional<Step> step = line_search(window, bracket, at, f, direction);
        if (!step) {
            if (since_restart == 0) {
                return {at, steps, false};
            }
            since_restart = 0;
            continue;
        }
        at = step->parameters;
        f = step->functional;
        since_restart = (since_restart + 1) % descent_restart;
    }
    return {at, most_steps, false};
}

std::unique_ptr<Estimator> make_conjugate_gradient(const EstimatorOptions& options) {
    return std::make_unique<ConjugateGradient>(options);
}

}  // namespace vybeg
