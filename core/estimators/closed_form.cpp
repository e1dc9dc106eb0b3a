#include "core/estimators/closed_form.h"

#include "core/estimators/profile.h"
#include "core/estimators/window_estimate.h"
#include "core/numerics/minimise.h"

#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

// J of (7) for a model with the given phasors, from averages alone.
double error_functional(const WindowPowers& powers, const Projections& mean, const Phasors& model,
                        const WindowKernel& kernel, std::int64_t n) {
    const auto product = [](std::complex<double> a, std::complex<double> b) {
        return a.real() * b.real() + a.imag() * b.imag();
    };
    const auto model_power = [&](std::complex<double> x) {
        return (x.real() * x.real() * kernel.gram_cos + x.imag() * x.imag() * kernel.gram_sin) /
               static_cast<double>(n);
    };
    return powers.cc + powers.dd - product(mean.c, model.c) - product(mean.d, model.d) +
           model_power(model.c) + model_power(model.d);
}

}  // namespace

WindowPowers window_powers(const Window& window, std::span<const double> delayed) {
    WindowPowers sum;
    for (std::size_t j = 0; j < window.c.size(); ++j) {
        sum.cc += window.c[j] * window.c[j];
        sum.dd += window.d[j] * window.d[j];
        sum.cd += window.c[j] * window.d[j];
    }
    for (std::size_t j = 0; j < delayed.size(); ++j) {
        sum.quarter += window.c[j] * delayed[j];
    }
    const auto n = static_cast<double>(window.length());
    return {sum.cc / n, sum.dd / n, sum.cd / n, sum.quarter / n};
}

Projections demodulate(const Window& window, double w) {
    const double scale = 2 / static_cast<double>(window.length());
    const Projections sum = window_projections(window, w);
    return {scale * sum.c, scale * sum.d};
}

double wave_angle(const WindowPowers& powers) {
    const double angle = 0.5 * std::atan2(2 * powers.cd, powers.cc - powers.dd);
    return angle <= -std::numbers::pi / 2 ? std::numbers::pi / 2 : angle;
}

double wave_phase(double two_theta_A, const Projections& mean) {
    return -std::arg(mean.c * std::cos(two_theta_A) + mean.d * std::sin(two_theta_A));
}

ClosedFormEstimator::ClosedFormEstimator(const EstimatorOptions& options)
    : options_(options), bracket_(main_lobe(options.f0_hz, options.rate_hz, options.length)) {}

std::vector<double> ClosedFormEstimator::quarter_delayed(const WindowBlock&) const {
    return {};
}

void ClosedFormEstimator::estimate(const WindowBlock& block, double, std::span<WaveEstimate> out) {
    const std::vector<double> delayed = quarter_delayed(block);
    for (std::size_t k = 0; k < out.size(); ++k) {
        const Window window = window_of(block, k);
        const auto start = k * static_cast<std::size_t>(block.hop);
        const auto own = delayed.empty() ? std::span<const double>{}
                                         : std::span(delayed).subspan(start, window.c.size());
        const bool gap = has_gap(window.c) || has_gap(window.d) || has_gap(own);
        out[k] = gap ? no_estimate(Flag::gap) : estimate_window(window, own);
    }
}

WaveEstimate ClosedFormEstimator::estimate_window(const Window& window,
                                                  std::span<const double> delayed) const {
    const std::int64_t n = window.length();
    const WindowPowers powers = window_powers(window, delayed);
    const auto functional = [&](double w) {
        const Projections mean = demodulate(window, w);
        return error_functional(powers, mean, closed_form(powers, mean, w).phasors,
                                window_kernel(n, w), n);
    };
    // The closed forms' J has its minimum near the profile's, within the window's leakage: start
    // there.
    const ProfileMaximum profile = maximise_profile(window, bracket_);
    const double lobe = 2 * std::numbers::pi / static_cast<double>(n);
    const Minimum minimum =
        minimise(functional, bracket_.low, profile.w, bracket_.high, 1e-3 * lobe, 1e-9 * lobe);

    const Projections mean = demodulate(window, minimum.at);
    const ClosedForm found = closed_form(powers, mean, minimum.at);
    Flags flags = own_flags();
    if (minimum.at_bound) {
        set(flags, Flag::at_bound);
    }
    return complete_estimate({found.state, found.phasors, minimum.at, parameter_count(), flags},
                             window, options_.rate_hz);
}

}  // namespace vybeg
