#include "core/estimators/batch/window_estimate.h"

#include "core/estimators/batch/profile.h"

#include <algorithm>
#include <array>
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

constexpr std::array<double WaveErrors::*, 6> all_errors{
    &WaveErrors::f_hz,        &WaveErrors::a_A,   &WaveErrors::a_B,
    &WaveErrors::two_theta_A, &WaveErrors::alpha, &WaveErrors::delta_phi_CD};

void add_leakage(WaveEstimate& estimate) {
    bool beyond = false;
    for (double WaveErrors::*error : all_errors) {
        const double leakage = estimate.leakage.*error;
        double& sd = estimate.sd.*error;
        beyond = beyond || std::abs(leakage) > sd;
        sd = std::sqrt(sd * sd + leakage * leakage);
    }
    estimate.flags = static_cast<Flags>(estimate.flags & ~static_cast<Flags>(Flag::leakage));
    if (beyond) {
        set(estimate.flags, Flag::leakage);
    }
}

// Adds the leakage of a closed form to its deviations: the difference from the best wave of the
// same samples, due to a window off Snap and to the power of the noise in averages. The best wave
// is efficient, so that the difference is not correlated with its error (J. A. Hausman, 1978) and
// variances add: that of the best wave plus the squared difference. Sets Flag::leakage where a
// difference exceeds its standard deviation.
void add_leakage(WaveEstimate& estimate, const BestWave& best, double rate_hz) {
    // (2theta_A, alpha) and (2theta_A + pi, alpha + pi) are the same wave.
    estimate.leakage = {{estimate.state.a_A - best.state.a_A, estimate.state.a_B - best.state.a_B,
                         reduced(estimate.state.two_theta_A - best.state.two_theta_A, pi),
                         reduced(estimate.state.alpha - best.state.alpha, pi)},
                        estimate.f_hz - best.w / (2 * pi) * rate_hz,
                        reduced(estimate.delta_phi_CD - best.delta_phi_CD, 2 * pi)};
    if (has(estimate.flags, Flag::no_quadrature)) {
        estimate.leakage.a_B = estimate.leakage.delta_phi_CD = 0;
    }
    add_leakage(estimate);
}

// Sets undefined values to NaN: a_B and dphi_CD of an algorithm without quadrature (flag
// no_quadrature), otherwise the angles where |a_A - |a_B|| is below three standard deviations (flag
// circular). `noise`: that of the phasors, sd per sample and channel.
void clear_undefined(WaveEstimate& estimate, double noise, std::int64_t n) {
    if (has(estimate.flags, Flag::no_quadrature)) {
        estimate.state.a_B = estimate.sd.a_B = nan;
        estimate.delta_phi_CD = estimate.sd.delta_phi_CD = nan;
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

}  // namespace

Window window_of(const WindowBlock& block, std::size_t k) {
    const auto start =
        static_cast<std::size_t>(block.first + static_cast<std::int64_t>(k) * block.hop);
    const auto length = static_cast<std::size_t>(block.length);
    return {block.c.subspan(start, length), block.d.subspan(start, length)};
}

WaveEstimate no_estimate(Flag flag) {
    const WaveState none{nan, nan, nan, nan};
    WaveEstimate estimate{none, nan, nan, nan, nan, nan, nan, {none, nan, nan}, {{}, nan, nan}, 0};
    set(estimate.flags, flag);
    return estimate;
}

void set_noise(WaveEstimate& estimate, double noise) {
    const double ratio = noise / estimate.steady_noise;
    if (!(ratio > 0 && std::isfinite(ratio))) {
        return;  // no estimate, or one without noise
    }
    const bool leaks = estimate.leakage.f_hz != 0;
    for (double WaveErrors::*error : all_errors) {
        const double leakage = estimate.leakage.*error;
        double& sd = estimate.sd.*error;
        sd = ratio * (leaks ? std::sqrt(std::max(sd * sd - leakage * leakage, 0.0)) : sd);
    }
    if (leaks) {
        add_leakage(estimate);
    }
}

double residual_of(double difference, double power, const Window& window,
                   const PhasorParts<double>& z, double w) {
    constexpr double least_difference = 1e-8;
    return difference < least_difference * power
               ? residual_sum(window, {{z.c_re, z.c_im}, {z.d_re, z.d_im}}, w)
               : difference;
}

BestWave best_wave(const Phasors& phasors, double w, const Window& window) {
    const WindowJets<double> jets =
        jets_of(window_moments(window, w), window_kernel(window.length(), w));
    return {to_wave_state(phasors), w, phase_difference(phasors), profile_power(jets).value,
            motion_power(jets, window_kernel(window.length(), w).spread)};
}

WaveEstimate complete_estimate(const Phasors& phasors, double w, Flags flags, const Window& window,
                               const EstimatorOptions& options) {
    const PhasorParts<double> parts = parts_of(phasors);
    const double residual = residual_sum(window, phasors, w);
    const double motion = best_wave(phasors, w, window).motion;
    return complete_estimate(report_wave(sample_products(window), w,
                                         window_kernel(options.length, w), parts, state_of(parts)),
                             {residual, without_motion(residual, motion), flags}, options);
}

WaveEstimate complete_estimate(const WaveReport<double>& wave, const WaveFit& fit,
                               const EstimatorOptions& options) {
    const auto n = static_cast<double>(options.length);
    const double hertz = options.rate_hz / (2 * pi);
    WaveEstimate estimate;
    const int parameters = has(fit.flags, Flag::no_quadrature) ? 4 : 5;
    estimate.noise = std::sqrt(fit.residual / (2 * n - parameters));
    estimate.steady_noise = std::sqrt(fit.steady / steady_freedom(options.length));
    const EquivalentNoise noise =
        options.noise.value_or(EquivalentNoise{estimate.steady_noise, estimate.steady_noise});
    estimate.state = wave.state;
    estimate.f_hz = wave.w * hertz;
    estimate.delta_phi_CD = wave.delta_phi_CD;
    estimate.rms = std::sqrt(fit.residual / n);
    estimate.orthogonality = wave.orthogonality;
    estimate.sd = errors_of(wave.unit_sd, noise.phasors, noise.frequency, hertz);
    estimate.flags = fit.flags;
    if (fit.best) {
        add_leakage(estimate, *fit.best, options.rate_hz);
    }
    clear_undefined(estimate, options.noise ? noise.phasors : estimate.noise, options.length);
    return estimate;
}

}  // namespace vybeg
