#pragma once

#include "core/resonator/phasor_run.h"
#include "core/simulation/slow_motion.h"

#include <numbers>
#include <random>

namespace vybeg::test {

// Noisy phasors straight from the simulator's equations of motion, as windows of `window` samples
// of a recording would give them; kappa and offsets are left out.
inline PhasorRun motion_run(const FreeDecay& decay, std::int64_t window, std::uint64_t seed) {
    const SlowMotion motion(decay);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const double sd = decay.noise * std::sqrt(2 / static_cast<double>(window));
    PhasorRun run;
    run.f_ref_hz = decay.f0_hz;
    run.window_s = static_cast<double>(window) / decay.rate_hz;
    for (std::int64_t k = 0; k < frame_count(decay) / window; ++k) {
        const double frame =
            static_cast<double>(k * window) + 0.5 * static_cast<double>(window - 1);
        const Eigen::Vector2cd z = motion.at_frame(frame) * std::conj(motion.carrier(frame));
        const auto noise = [&] {
            const double real = sd * normal(random);
            return std::complex<double>(real, sd * normal(random));
        };
        run.time_s.push_back(frame / decay.rate_hz);
        run.c.push_back(z[0] + noise());
        run.d.push_back(z[1] + noise());
        run.sd.push_back(sd);
    }
    return run;
}

}  // namespace vybeg::test
