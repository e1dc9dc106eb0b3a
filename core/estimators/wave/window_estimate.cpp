#include "core/estimators/wave/window_estimate.h"

#include "core/estimators/wave/precision_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = std::numbers::pi;

// A difference of two angles in (-pi, pi] by whole periods of pi or 2 pi, to half a period; two
// steps reach it, without the division of std::remainder.
double reduced(double difference, double period) {
    for (int step = 0; step < 2; ++step) {
        if (std::abs(difference) > period / 2) {
            difference -= std::copysign(period, difference);
        }
    }
    return difference;
}

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
    WaveEstimate estimate{none, nan, nan, nan, nan, nan, none, nan, nan, nan, 0};
    set(estimate.flags, flag);
    return estimate;
}

void add_leakage(WaveEstimate& estimate, const BestWave& best) {
    bool beyond = false;
    const auto add = [&beyond](double difference, double& sd) {
        beyond = beyond || std::abs(difference) > sd;
        sd = std::sqrt(sd * sd + difference * difference);
    };
    // (2theta_A, alpha) and (2theta_A + pi, alpha + pi) are the same wave.
    estimate.leakage_f_hz = estimate.f_hz - best.f_hz;
    add(estimate.leakage_f_hz, estimate.sd_f_hz);
    add(estimate.state.a_A - best.state.a_A, estimate.sd.a_A);
    add(reduced(estimate.state.two_theta_A - best.state.two_theta_A, pi), estimate.sd.two_theta_A);
    add(reduced(estimate.state.alpha - best.state.alpha, pi), estimate.sd.alpha);
    if (!has(estimate.flags, Flag::no_quadrature)) {
        add(estimate.state.a_B - best.state.a_B, estimate.sd.a_B);
        add(reduced(estimate.delta_phi_CD - best.delta_phi_CD, 2 * pi), estimate.sd_delta_phi_CD);
    }
    if (beyond) {
        set(estimate.flags, Flag::leakage);
    }
}

EquivalentNoise noise_of(double residual_noise, const EstimatorOptions& options) {
    return options.noise.value_or(EquivalentNoise{residual_noise, residual_noise});
}

void drop_what_is_not(WaveEstimate& estimate, double noise, std::int64_t n) {
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
    const double variance = 4 * noise * noise / count;
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

WaveEstimate complete_estimate(const FoundWave& found, const Window& window,
                               const EstimatorOptions& options) {
    return complete_estimate(
        found, residual_sum(window, {found.phasors.c, found.phasors.d}, found.w),
        sample_products(window), window_kernel(options.length, found.w), options);
}

WaveEstimate complete_estimate(const FoundWave& found, double residual,
                               const SampleProducts& products, const WindowKernel& kernel,
                               const EstimatorOptions& options) {
    const WaveState& state = found.state;
    const auto n = static_cast<double>(options.length);

    WaveEstimate estimate;
    estimate.state = state;
    estimate.f_hz = found.w / (2 * std::numbers::pi) * options.rate_hz;
    estimate.delta_phi_CD = phase_difference(found.phasors);
    estimate.rms = std::sqrt(residual / n);
    estimate.noise = std::sqrt(residual / (2 * n - found.parameters));
    estimate.orthogonality = orthogonality(products, state.two_theta_A);
    estimate.flags = found.flags;

    const EquivalentNoise noise = noise_of(estimate.noise, options);
    const Precision precision =
        precision_bound(found.phasors, kernel, options.rate_hz, noise.phasors);
    estimate.sd = precision.sd;
    estimate.sd_delta_phi_CD = precision.sd_delta_phi_CD;
    estimate.sd_f_hz =
        options.noise
            ? precision_bound(found.phasors, kernel, options.rate_hz, noise.frequency).sd_f_hz
            : precision.sd_f_hz;

    if (found.best) {
        add_leakage(estimate, *found.best);
    }
    drop_what_is_not(estimate, noise.phasors, options.length);
    return estimate;
}

}  // namespace vybeg
