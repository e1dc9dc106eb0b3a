#pragma once

#include "core/resonator/model/phasor_run.h"
#include "core/simulation/decay_motion.h"
#include "core/simulation/noise.h"

#include <cmath>
#include <cstdint>

namespace vybeg::test {

// The window phasors of a simulated decay, without the samples: mean_of(first, t) of each window
// (its first frame, the time of its middle), D over kappa, plus the noise that least squares over
// the window's samples leaves, sd noise * sqrt(2/n).
template <class MeanOf>
PhasorRun noisy_phasors(const FreeDecay& decay, std::int64_t window, std::uint64_t seed,
                        const MeanOf& mean_of) {
    GaussianNoise noise(seed);
    const auto n = static_cast<double>(window);
    const double sd = decay.noise * std::sqrt(2 / n);
    PhasorRun run;
    run.f_ref_hz = decay.f0_hz;
    run.rate_hz = decay.rate_hz;
    run.window_s = n / decay.rate_hz;
    for (std::int64_t first = 0; first + window <= frame_count(decay); first += window) {
        const double t = (static_cast<double>(first) + (n - 1) / 2) / decay.rate_hz;
        const Eigen::Vector2cd z = mean_of(first, t);
        const auto [c_re, c_im] = noise.next();
        const auto [d_re, d_im] = noise.next();
        run.time_s.push_back(t);
        run.c.push_back(z[0] + sd * std::complex(c_re, c_im));
        run.d.push_back(z[1] / decay.kappa + sd * std::complex(d_re, d_im));
        run.sd.push_back(sd);
    }
    return run;
}

// Those of the simulator's linear motion at a frequency `offset_hz` above its carrier, averaged
// over each window by Simpson's rule.
inline PhasorRun simulated_phasors(const FreeDecay& decay, std::int64_t window, std::uint64_t seed,
                                   double offset_hz = 0) {
    constexpr double two_pi = 6.283185307179586;
    const SlowMotion motion(decay);
    const Eigen::Vector2cd start = motion.at_frame(0);
    const double window_s = static_cast<double>(window) / decay.rate_hz;
    return noisy_phasors(decay, window, seed, [&](std::int64_t, double t) {
        Eigen::Vector2cd z = Eigen::Vector2cd::Zero();
        for (const auto& [at, weight] :
             {std::pair(-0.5, 1.0), {-0.25, 4.0}, {0.0, 2.0}, {0.25, 4.0}, {0.5, 1.0}}) {
            const double u = t + at * window_s;
            z += weight / 12 * std::polar(1.0, two_pi * offset_hz * u) *
                 (motion.propagator(u) * start);
        }
        return z;
    });
}

// Those of a motion that need not be linear, averaged over the samples.
inline PhasorRun moved_phasors(const FreeDecay& decay, std::int64_t window, std::uint64_t seed) {
    constexpr double two_pi = 6.283185307179586;
    DecayMotion motion(decay);
    return noisy_phasors(decay, window, seed, [&](std::int64_t first, double) {
        Eigen::Vector2cd z = Eigen::Vector2cd::Zero();
        for (std::int64_t frame = first; frame < first + window; ++frame) {
            const double turns = decay.f0_hz * static_cast<double>(frame) / decay.rate_hz;
            z += motion.next() *
                 std::polar(1 / static_cast<double>(window), -two_pi * std::remainder(turns, 1.0));
        }
        return z;
    });
}

// Turns the phasors as if the frequency were higher by offset + drift t, Hz, within no window.
inline void shift(PhasorRun& run, double offset_hz, double drift_hz_per_s = 0) {
    constexpr double two_pi = 6.283185307179586;
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        const double t = run.time_s[k];
        const auto turn = std::polar(1.0, two_pi * t * (offset_hz + drift_hz_per_s * t / 2));
        run.c[k] *= turn;
        run.d[k] *= turn;
    }
}

}  // namespace vybeg::test
