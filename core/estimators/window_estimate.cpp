#include "core/estimators/window_estimate.h"

#include "core/estimators/precision_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// <S_A S_B> over <S_A^2> + <S_B^2>: the wave axes' orthogonality (30), straight from the samples.
double orthogonality(const Window& window, double two_theta_A) {
    const double cosine = std::cos(two_theta_A);
    const double sine = std::sin(two_theta_A);
    double product = 0;
    double power = 0;
    for (std::size_t j = 0; j < window.c.size(); ++j) {
        const double a = window.c[j] * cosine + window.d[j] * sine;
        const double b = window.d[j] * cosine - window.c[j] * sine;
        product += a * b;
        power += a * a + b * b;
    }
    return product / power;
}

}  // namespace

Window window_of(const WindowBlock& block, std::size_t k) {
    const auto start =
        static_cast<std::size_t>(block.first + static_cast<std::int64_t>(k) * block.hop);
    const auto length = static_cast<std::size_t>(block.length);
    return {block.c.subspan(start, length), block.d.subspan(start, length)};
}

bool has_gap(std::span<const double> samples) {
    return std::any_of(samples.begin(), samples.end(), [](double x) { return !std::isfinite(x); });
}

WaveEstimate no_estimate(Flag flag) {
    const WaveState none{nan, nan, nan, nan};
    WaveEstimate estimate{none, nan, nan, nan, nan, none, nan, nan, 0};
    set(estimate.flags, flag);
    return estimate;
}

WaveEstimate complete_estimate(const Window& window, double rate_hz, const WaveState& state,
                               const Phasors& phasors, double w, int parameters, Flags flags) {
    const std::int64_t n = window.length();
    const double sum = residual_sum(window, {phasors.c, phasors.d}, w);
    const double noise = std::sqrt(sum / static_cast<double>(2 * n - parameters));

    WaveEstimate estimate;
    estimate.state = state;
    estimate.f_hz = w / (2 * std::numbers::pi) * rate_hz;
    estimate.delta_phi_CD = phase_difference(phasors);
    estimate.rms = std::sqrt(sum / static_cast<double>(n));
    estimate.orthogonality = orthogonality(window, state.two_theta_A);
    estimate.flags = flags;

    const Precision precision = precision_bound(phasors, estimate.f_hz, rate_hz, n, noise);
    estimate.sd = precision.sd;
    estimate.sd_f_hz = precision.sd_f_hz;
    estimate.sd_delta_phi_CD = precision.sd_delta_phi_CD;

    if (has(flags, Flag::no_quadrature)) {
        estimate.state.a_B = estimate.sd.a_B = nan;
        estimate.delta_phi_CD = estimate.sd_delta_phi_CD = nan;
    } else {
        // The smaller travelling wave, u+ or u-, has a standard deviation of sigma sqrt(4/n) in
        // modulus; the second bound is what rounding leaves of a perfect circle.
        const double smaller = state.a_A - std::abs(state.a_B);
        const double doubt =
            std::max(3 * noise * std::sqrt(4.0 / static_cast<double>(n)), 1e-12 * state.a_A);
        if (!(smaller > doubt)) {
            set(estimate.flags, Flag::circular);
            estimate.state.two_theta_A = estimate.sd.two_theta_A = nan;
            estimate.state.alpha = estimate.sd.alpha = nan;
            estimate.orthogonality = nan;
        }
    }
    return estimate;
}

}  // namespace vybeg
