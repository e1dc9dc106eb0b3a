#include "core/resonator/envelope_decay.h"

#include <cmath>
#include <limits>

namespace vybeg {

EnvelopeDecay envelope_decay(const ScaledRun& run, const Shared& shared, const Own& own) {
    const SlowDynamics motion(rates_of(shared));
    const Eigen::Vector2cd start = start_of(own);
    const double kappa = shared[kappa_index];
    double weights = 0;
    double mean_t = 0;
    int used = 0;
    // Both sums over the same windows and weights, so that a decay that is no straight line bends
    // both alike.
    const auto for_windows = [&](const auto& use) {
        for (std::size_t k = 0; k < run.size(); ++k) {
            const double power = run.z[k].squaredNorm();
            const double variance = 1 / (run.weight[k] * run.weight[k]);
            if (power > 100 * variance) {
                // The noise adds four variances to the power; the logarithm's variance is 4
                // variances over the power.
                use(run.time_s[k], power - 4 * variance, power / (4 * variance));
            }
        }
    };
    for_windows([&](double t, double, double weight) {
        weights += weight;
        mean_t += weight * t;
        ++used;
    });
    if (used < 3) {
        return {0, std::numeric_limits<double>::infinity(), 0};
    }
    mean_t /= weights;
    double spread = 0;
    double seen = 0;
    double fitted = 0;
    for_windows([&](double t, double power, double weight) {
        Eigen::Vector2cd z = motion.propagator(t) * start;
        z[1] /= kappa;
        spread += weight * (t - mean_t) * (t - mean_t);
        seen += weight * (t - mean_t) * std::log(power);
        fitted += weight * (t - mean_t) * std::log(z.squaredNorm());
    });
    return {-seen / spread / 2, 0.5 / std::sqrt(spread), -fitted / spread / 2};
}

}  // namespace vybeg
