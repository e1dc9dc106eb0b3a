#pragma once

#include "core/estimators/wave/estimator.h"
#include "core/numerics/phase.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace vybeg::test {

// A wave with constant slow variables, written out as METHOD (6) says, in extended precision: the
// truth that the estimators are held against.
struct StillWave {
    WaveState state;  // alpha at sample `centre`
    double f_hz = 5300;
    double rate_hz = 33333;

    // Samples 0 .. count-1; the state's alpha holds at the place `centre`, in samples.
    void samples(std::int64_t count, double centre, std::vector<double>& c,
                 std::vector<double>& d) const {
        constexpr long double turn = 2 * std::numbers::pi_v<long double>;
        const long double cosine = std::cos(static_cast<long double>(state.two_theta_A));
        const long double sine = std::sin(static_cast<long double>(state.two_theta_A));
        const long double per_sample = static_cast<long double>(f_hz) / rate_hz;
        c.resize(static_cast<std::size_t>(count));
        d.resize(static_cast<std::size_t>(count));
        for (std::int64_t j = 0; j < count; ++j) {
            const long double tau =
                turn * per_sample * (static_cast<long double>(j) - centre) - state.alpha;
            const long double a = state.a_A * std::cos(tau);
            const long double b = state.a_B * std::sin(tau);
            c[static_cast<std::size_t>(j)] = static_cast<double>(a * cosine - b * sine);
            d[static_cast<std::size_t>(j)] = static_cast<double>(a * sine + b * cosine);
        }
    }
};

// Differences of an estimate from the truth, with (2theta_A, alpha) and (2theta_A + pi, alpha + pi)
// the same.
struct Deviation {
    double a_A, a_B, two_theta_A, alpha, f_hz;
};

inline Deviation deviation(const WaveState& found, double found_f_hz, const WaveState& truth,
                           double truth_f_hz) {
    double angle = wrap(found.two_theta_A - truth.two_theta_A);
    double phase = wrap(found.alpha - truth.alpha);
    if (std::abs(angle) > std::numbers::pi / 2) {
        angle = wrap(angle + std::numbers::pi);
        phase = wrap(phase + std::numbers::pi);
    }
    return {found.a_A - truth.a_A, found.a_B - truth.a_B, angle, phase, found_f_hz - truth_f_hz};
}

inline std::string describe(const StillWave& wave, std::int64_t n) {
    return "f=" + std::to_string(wave.f_hz) + " n=" + std::to_string(n) +
           " a_B=" + std::to_string(wave.state.a_B) +
           " 2theta=" + std::to_string(wave.state.two_theta_A) +
           " alpha=" + std::to_string(wave.state.alpha);
}

}  // namespace vybeg::test
