#include "core/estimators/batch/window_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
using std::numbers::pi;

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

void add_leakage(WaveEstimate& estimate, const BestWave& best, double rate_hz) {
    bool beyond = false;
    const auto add = [&beyond](double difference, double& sd) {
        beyond = beyond || std::abs(difference) > sd;
        sd = std::sqrt(sd * sd + difference * difference);
    };
    // (2theta_A, alpha) and (2theta_A + pi, alpha + pi) are the same wave.
    estimate.leakage_f_hz = estimate.f_hz - best.w / (2 * pi) * rate_hz;
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

void clear_undefined(WaveEstimate& estimate, double noise, std::int64_t n) {
    if (has(estimate.flags, Flag::no_quadrature)) {
        estimate.state.a_B = estimate.sd.a_B = nan;
        estimate.delta_phi_CD = estimate.sd_delta_phi_CD = nan;
        return;
    }
    // The smaller travelling wave, u+ or u-, has a standard deviation of sigma sqrt(4/n) in
    // modulus; the second bound is the rounding error of a perfect circle.
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
                   const WaveReport<double>& wave) {
    constexpr double least_difference = 1e-8;
    const PhasorParts<double>& z = wave.phasors;
    return difference < least_difference * power
               ? residual_sum(window, {{z.c_re, z.c_im}, {z.d_re, z.d_im}}, wave.w)
               : difference;
}

WaveEstimate complete_estimate(const Phasors& phasors, double w, Flags flags, const Window& window,
                               const EstimatorOptions& options) {
    const PhasorParts<double> parts = parts_of(phasors);
    return complete_estimate(report_wave(sample_products(window), w,
                                         window_kernel(options.length, w), parts, state_of(parts)),
                             {residual_sum(window, {phasors.c, phasors.d}, w), 5, flags}, options);
}

WaveEstimate complete_estimate(const WaveReport<double>& wave, const WaveFit& fit,
                               const EstimatorOptions& options) {
    const auto n = static_cast<double>(options.length);
    const double hertz = options.rate_hz / (2 * pi);
    WaveEstimate estimate;
    estimate.noise = std::sqrt(fit.residual / (2 * n - fit.parameters));
    const EquivalentNoise noise =
        options.noise.value_or(EquivalentNoise{estimate.noise, estimate.noise});
    const WaveState& unit = wave.unit_sd.sd;
    estimate.state = wave.state;
    estimate.f_hz = wave.w * hertz;
    estimate.delta_phi_CD = wave.delta_phi_CD;
    estimate.rms = std::sqrt(fit.residual / n);
    estimate.orthogonality = wave.orthogonality;
    estimate.sd = {noise.phasors * unit.a_A, noise.phasors * unit.a_B,
                   noise.phasors * unit.two_theta_A, noise.phasors * unit.alpha};
    estimate.sd_f_hz = noise.frequency * wave.unit_sd.w * hertz;
    estimate.sd_delta_phi_CD = noise.phasors * wave.unit_sd.delta_phi_CD;
    estimate.flags = fit.flags;
    if (fit.best) {
        add_leakage(estimate, *fit.best, options.rate_hz);
    }
    clear_undefined(estimate, noise.phasors, options.length);
    return estimate;
}

}  // namespace vybeg
