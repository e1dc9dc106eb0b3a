#include "core/sweep/form_leakage.h"

#include "core/numerics/statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace vybeg {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int phases = 8;  // of alpha in half a turn: leakage has the period pi

using Errors = std::array<double, sweep_variable_count>;

// The samples of a wave about the middle of a window of n, with context on both sides.
void sample(const WaveState& wave, double w, std::int64_t n, std::int64_t context,
            std::vector<double>& c, std::vector<double>& d) {
    const Phasors z = to_phasors(wave);
    c.resize(static_cast<std::size_t>(n + 2 * context));
    d.resize(c.size());
    const double centre = static_cast<double>(context) + 0.5 * static_cast<double>(n - 1);
    for (std::size_t k = 0; k < c.size(); ++k) {
        const std::complex<double> turn = std::polar(1.0, w * (static_cast<double>(k) - centre));
        c[k] = (z.c * turn).real();
        d[k] = (z.d * turn).real();
    }
}

Errors errors_of(const WaveEstimate& found, const WaveState& wave, double f0_hz) {
    return {found.state.a_A - wave.a_A, found.state.a_B - wave.a_B,
            std::remainder(found.state.two_theta_A - wave.two_theta_A, pi), found.f_hz - f0_hz,
            std::remainder(found.delta_phi_CD - phase_difference(to_phasors(wave)), 2 * pi)};
}

}  // namespace

Errors form_leakage(Algorithm algorithm, std::span<const WaveState> waves, std::int64_t n,
                    double f0_hz, double rate_hz) {
    EstimatorOptions options;
    options.length = n;
    options.rate_hz = rate_hz;
    options.f0_hz = f0_hz;
    const auto estimator = make_estimator(algorithm, options);
    const std::int64_t context = estimator->context();
    const double w = 2 * pi * f0_hz / rate_hz;
    std::array<std::vector<double>, sweep_variable_count> of_waves;
    std::vector<double> c;
    std::vector<double> d;
    for (const WaveState& wave : waves) {
        Errors squares{};
        for (int phase = 0; phase < phases; ++phase) {
            WaveState turned = wave;
            turned.alpha = wave.alpha + pi * phase / phases;
            sample(turned, w, n, context, c, d);
            WaveEstimate found;
            estimator->estimate({c, d, context, n, n}, 0, {&found, 1});
            const Errors errors = errors_of(found, turned, f0_hz);
            for (std::size_t v = 0; v < errors.size(); ++v) {
                squares[v] += errors[v] * errors[v] / phases;
            }
        }
        for (std::size_t v = 0; v < squares.size(); ++v) {
            if (std::isfinite(squares[v])) {
                of_waves[v].push_back(std::sqrt(squares[v]));
            }
        }
    }
    Errors typical;
    typical.fill(SweepValue::none);
    for (std::size_t v = 0; v < typical.size(); ++v) {
        if (!of_waves[v].empty()) {
            typical[v] = median(std::move(of_waves[v]));
        }
    }
    return typical;
}

}  // namespace vybeg
