#pragma once

#include "core/resonator/results/resonator_fit.h"
#include "core/resonator/results/resonator_parameters.h"
#include "tests/core/resonator/simulated_phasors.h"
#include "tests/needed.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace vybeg::test {

// Runs of one resonator that start at the angles theta_A (deg), each with its own phase and offset
// of frequency, as window phasors. `decay` holds the resonator and the noise.
inline std::vector<PhasorRun> set_of(const FreeDecay& decay, const std::vector<double>& angles,
                                     std::int64_t window, std::uint64_t seed) {
    std::vector<PhasorRun> runs;
    for (const double angle : angles) {
        const auto k = static_cast<double>(runs.size());
        FreeDecay run = decay;
        run.two_theta_A = 2 * angle * std::numbers::pi / 180;
        run.alpha = 0.4 + 1.7 * k;
        runs.push_back(
            simulated_phasors(run, window, 1000 * seed + runs.size(), 0.013 * (1 - 0.8 * k)));
    }
    return runs;
}

inline ResonatorFit fitted(const std::vector<PhasorRun>& runs, const FitOptions& options = {}) {
    return needed(fit_resonator(runs, options, {}));
}

// The article's case, four starts 22.5 degrees apart, is `reference` over these angles.
inline const std::vector<double> four_angles{0, 22.5, 45, 67.5};

inline FreeDecay reference() {
    FreeDecay decay;
    decay.tau_s = 400;
    decay.noise = 1e-3;
    return decay;
}

// The others zero.
constexpr ChannelTolerance channels(std::initializer_list<std::pair<ErrorSource, double>> errors) {
    ChannelTolerance sizes{};
    for (const auto& [source, size] : errors) {
        sizes[source] = size;
    }
    return sizes;
}

// 10 ns at 5300 Hz, 0.1 degrees, 1e-4.
inline constexpr FitOptions assuming{.assumed =
                                         channels({{kappa_error, 0.01},
                                                   {skew_error, 0.1 * std::numbers::pi / 180},
                                                   {delay_error, 3.3e-4},
                                                   {crosstalk_error, 1e-4},
                                                   {phase_drift_error, 1e-4},
                                                   {gain_drift_error, 1e-4}})};

// D with errors of these sizes.
inline void spoil(std::vector<PhasorRun>& runs, const ChannelTolerance& size) {
    for (PhasorRun& run : runs) {
        for (std::size_t k = 0; k < run.d.size(); ++k) {
            const double share = run.time_s[k] / run.time_s.back();
            const double gain = (1 + size[gain_drift_error] * share) / (1 + size[kappa_error]);
            const double phase = size[delay_error] + size[phase_drift_error] * share;
            run.d[k] = run.d[k] * std::polar(gain, phase) +
                       std::complex(std::sin(size[skew_error]), size[crosstalk_error]) * run.c[k];
        }
    }
}

// Errors drawn from tolerances, normal up to two and a half of them.
inline ChannelTolerance drawn_from(const ChannelTolerance& tolerance, std::uint64_t seed) {
    GaussianNoise random(seed);
    ChannelTolerance size{};
    for (const ToleratedError& error : channel_errors) {
        size[error.source] = tolerance[error.source] * std::clamp(random.next().first, -2.5, 2.5);
    }
    return size;
}

// nullptr: none.
inline const Diagnostic* warning_of(const ResonatorFit& fit, DiagnosticKind kind) {
    const auto found = std::ranges::find(fit.warnings, kind, &Diagnostic::kind);
    return found == fit.warnings.end() ? nullptr : &*found;
}

inline bool warns(const ResonatorFit& fit, DiagnosticKind kind) {
    return std::ranges::any_of(fit.warnings,
                               [kind](const Diagnostic& known) { return known.kind == kind; });
}

// The estimate without what u holds besides, such as the spread assumed between two recordings.
inline Estimate statistical(Estimate estimate) {
    estimate.u = std::numeric_limits<double>::quiet_NaN();
    return estimate;
}

// What is wrong with an estimate: empty where it is given, lies within `k` of its combined
// uncertainties of the truth, and these are at most `most`.
inline QString fault(const Estimate& estimate, double truth, double k, double most) {
    const bool fine = estimate.given() &&
                      std::abs(estimate.value - truth) <= k * estimate.uncertainty() &&
                      estimate.uncertainty() <= most;
    return fine ? QString()
                : QString("%1 +- %2 for %3")
                      .arg(estimate.value, 0, 'g', 12)
                      .arg(estimate.uncertainty())
                      .arg(truth, 0, 'g', 12);
}

}  // namespace vybeg::test

// QCOMPARE tells the line, and the fault what is wrong.
#define VYBEG_NEAR(estimate, truth, k, most) QCOMPARE(fault(estimate, truth, k, most), QString())
