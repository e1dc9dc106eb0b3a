#include "core/estimators/wave/descent.h"

#include "core/estimators/wave/window_estimate.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
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

}  // namespace vybeg
