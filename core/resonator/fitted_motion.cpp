#include "core/resonator/fitted_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

// Straight between the windows, as the integral itself is of straight lines; constant outside.
double power_integral(const FittedMotion::Run& run, double time_s) {
    const auto after = std::ranges::lower_bound(run.time_s, time_s) - run.time_s.begin();
    if (after == 0 || after == std::ssize(run.time_s)) {
        return after == 0 ? 0 : run.power_integral.back();
    }
    const auto k = static_cast<std::size_t>(after);
    const double part = (time_s - run.time_s[k - 1]) / (run.time_s[k] - run.time_s[k - 1]);
    return std::lerp(run.power_integral[k - 1], run.power_integral[k], part);
}

}  // namespace

Phasors predicted_phasors(const FittedMotion& motion, std::size_t run, double time_s) {
    const FittedMotion::Run& own = motion.runs[run];
    double turns = own.f_hz * time_s + own.drift_hz_per_s * time_s * (time_s / 2 - own.middle_s);
    if (motion.frequency_per_power != 0) {
        turns += motion.frequency_per_power * power_integral(own, time_s);
    }
    const Eigen::Vector2cd z = std::polar(1.0, 2 * std::numbers::pi * turns) *
                               (SlowDynamics(motion.rates).propagator(time_s) * own.start);
    return {z[0], z[1] / motion.kappa};
}

}  // namespace vybeg
