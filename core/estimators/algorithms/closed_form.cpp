#include "core/estimators/algorithms/closed_form.h"

#include "core/estimators/batch/series_estimates.h"
#include "core/estimators/wave/profile.h"
#include "core/estimators/wave/window_estimate.h"
#include "core/numerics/minimise.h"

#include <algorithm>
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

WindowPowers window_powers(const Window& window) {
    const SampleProducts sum = sample_products(window);
    const auto n = static_cast<double>(window.length());
    return {sum.cc / n, sum.dd / n, sum.cd / n, 0};
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
    : options_(options),
      bracket_(main_lobe(options.f0_hz, options.rate_hz, options.length)),
      sums_(options.length, bracket_.centre) {}

std::vector<double> ClosedFormEstimator::quarter_delayed(const WindowBlock&) const {
    return {};
}

void ClosedFormEstimator::estimate(const WindowBlock& block, double, std::span<WaveEstimate> out) {
    const std::vector<double> delayed = quarter_delayed(block);
    sums_.take(block, out.size(), delayed);
    SeriesBatch batch;
    SeriesMaximum maximum;
    ClosedSeries series;
    for (std::size_t first = 0, count = 0; first < out.size(); first += count) {
        count = sums_.next(first, batch, maximum);
        closed_series(batch, sums_.frame(), series);
        for (std::size_t lane = 0; lane < count; ++lane) {
            const Window window = window_of(block, first + lane);
            const double power = batch.cc[lane] + batch.dd[lane];
            if (!std::isfinite(power)) {
                // A missing sample makes its whole sum one.
                out[first + lane] = no_estimate(Flag::gap);
            } else if (!std::isfinite(batch.cq[lane])) {
                out[first + lane] = no_estimate(Flag::delay_reach);
            } else if (series.arrived[lane] > 0) {
                out[first + lane] =
                    estimate_of_lane(series.waves, lane, window,
                                     {power, series.residual[lane], parameter_count(), own_flags(),
                                      best_of_lane(series, lane)},
                                     options_);
            } else {
                const auto n = static_cast<double>(block.length);
                const WindowPowers powers{batch.cc[lane] / n, batch.dd[lane] / n,
                                          batch.cd[lane] / n, batch.cq[lane] / n};
                out[first + lane] = estimate_window({window, powers, batch, lane, sums_.frame()});
            }
        }
    }
}

BestWave ClosedFormEstimator::best_of_lane(const ClosedSeries& series, std::size_t lane) const {
    return {{series.best_a_A[lane], series.best_a_B[lane], series.best_two_theta_A[lane],
             series.best_alpha[lane]},
            series.best_w[lane] / (2 * std::numbers::pi) * options_.rate_hz,
            series.best_delta_phi_CD[lane]};
}

Projections ClosedFormEstimator::demodulated(const SummedWindow& summed, double w) const {
    const auto n = static_cast<double>(summed.frame.length());
    const double x = 0.5 * n * (w - summed.frame.w0());
    if (std::abs(x) > closed_form_reach) {
        return demodulate(summed.window, w);
    }
    const Projections sum = series_projections(summed.batch, summed.lane, x);
    return {2 / n * sum.c, 2 / n * sum.d};
}

WindowKernel ClosedFormEstimator::kernel(const SeriesFrame& frame, double w) {
    const double x = 0.5 * static_cast<double>(frame.length()) * (w - frame.w0());
    return std::abs(x) <= closed_form_reach ? frame.kernel(x) : window_kernel(frame.length(), w);
}

WaveEstimate ClosedFormEstimator::estimate_window(const SummedWindow& summed) const {
    const std::int64_t n = summed.frame.length();
    const WindowPowers& powers = summed.powers;
    const auto functional = [&](double w) {
        const Projections mean = demodulated(summed, w);
        return error_functional(powers, mean, closed_form(powers, mean, w).phasors,
                                kernel(summed.frame, w), n);
    };
    // The closed forms' J has its minimum near the profile's, within the window's leakage: start
    // there.
    const auto count = static_cast<double>(n);
    const ProfileMaximum best = maximise_profile(summed.window, bracket_);
    const double start = best.w;
    const double turn = 2 * std::numbers::pi;
    const double lobe = turn / count;
    const Minimum minimum =
        minimise(functional, bracket_.low, start, bracket_.high, 1e-3 * lobe, 1e-9 * lobe);

    const ClosedForm closed = closed_form(powers, demodulated(summed, minimum.at), minimum.at);
    FoundWave found{closed.state,
                    closed.phasors,
                    minimum.at,
                    parameter_count(),
                    own_flags(),
                    BestWave{to_wave_state(best.phasors), best.w / turn * options_.rate_hz,
                             phase_difference(best.phasors)}};
    if (minimum.at_bound) {
        set(found.flags, Flag::at_bound);
    }
    const double residual = residual_of(count * minimum.value, count * (powers.cc + powers.dd),
                                        summed.window, {found.phasors.c, found.phasors.d}, found.w);
    return complete_estimate(found, residual,
                             {count * powers.cc, count * powers.dd, count * powers.cd},
                             kernel(summed.frame, found.w), options_);
}

}  // namespace vybeg
