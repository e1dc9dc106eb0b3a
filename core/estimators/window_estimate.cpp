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
double orthogonality(const SampleProducts& sum, double two_theta_A) {
    const double product =
        sum.cd * std::cos(2 * two_theta_A) + 0.5 * (sum.dd - sum.cc) * std::sin(2 * two_theta_A);
    return product / (sum.cc + sum.dd);
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

void drop_what_is_not(WaveEstimate& estimate, double residual, int parameters, std::int64_t n) {
    if (has(estimate.flags, Flag::no_quadrature)) {
        estimate.state.a_B = estimate.sd.a_B = nan;
        estimate.delta_phi_CD = estimate.sd_delta_phi_CD = nan;
        return;
    }
    // The smaller travelling wave, u+ or u-, has a standard deviation of sigma sqrt(4/n) in
    // modulus; the second bound is what rounding leaves of a perfect circle.
    const WaveState& state = estimate.state;
    const double smaller = state.a_A - std::abs(state.a_B);
    const auto count = static_cast<double>(n);
    const double variance = 4 * residual / ((2 * count - parameters) * count);
    if (!(smaller * smaller > 9 * variance && smaller > 1e-12 * state.a_A)) {
        set(estimate.flags, Flag::circular);
        estimate.state.two_theta_A = estimate.sd.two_theta_A = nan;
        estimate.state.alpha = estimate.sd.alpha = nan;
        estimate.orthogonality = nan;
    }
}

double residual_of(double difference, double power, const Window& window,
                   const Projections& phasors, double w) {
    constexpr double least_difference = 1e-8;
    return difference < least_difference * power ? residual_sum(window, phasors, w) : difference;
}

WaveEstimate complete_estimate(const FoundWave& found, const Window& window, double rate_hz) {
    const std::int64_t n = window.length();
    return complete_estimate(found,
                             residual_sum(window, {found.phasors.c, found.phasors.d}, found.w),
                             sample_products(window), window_kernel(n, found.w), n, rate_hz);
}

WaveEstimate complete_estimate(const FoundWave& found, double residual,
                               const SampleProducts& products, const WindowKernel& kernel,
                               std::int64_t n, double rate_hz) {
    const WaveState& state = found.state;
    const double noise = std::sqrt(residual / static_cast<double>(2 * n - found.parameters));

    WaveEstimate estimate;
    estimate.state = state;
    estimate.f_hz = found.w / (2 * std::numbers::pi) * rate_hz;
    estimate.delta_phi_CD = phase_difference(found.phasors);
    estimate.rms = std::sqrt(residual / static_cast<double>(n));
    estimate.orthogonality = orthogonality(products, state.two_theta_A);
    estimate.flags = found.flags;

    const Precision precision = precision_bound(found.phasors, kernel, rate_hz, noise);
    estimate.sd = precision.sd;
    estimate.sd_f_hz = precision.sd_f_hz;
    estimate.sd_delta_phi_CD = precision.sd_delta_phi_CD;

    drop_what_is_not(estimate, residual, found.parameters, n);
    return estimate;
}

}  // namespace vybeg
