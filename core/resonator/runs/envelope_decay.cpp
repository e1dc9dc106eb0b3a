#include "core/resonator/runs/envelope_decay.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vybeg {

EnvelopeDecay envelope_decay(const ScaledRun& run, std::span<const Eigen::Vector2cd> expected) {
    double weights = 0;
    double mean_t = 0;
    int used = 0;
    // Both sums use the same windows and weights, so that a decay other than a straight line
    // affects both alike.
    const auto for_windows = [&](const auto& use) {
        for (std::size_t k = 0; k < run.size(); ++k) {
            const double power = run.z[k].squaredNorm();
            const double variance = 1 / (run.weight[k] * run.weight[k]);
            if (power > 100 * variance) {
                // The noise adds four variances to the power; the logarithm's variance is 4
                // variances over the power.
                use(k, power - 4 * variance, power / (4 * variance));
            }
        }
    };
    for_windows([&](std::size_t k, double, double weight) {
        weights += weight;
        mean_t += weight * run.time_s[k];
        ++used;
    });
    if (used < 3) {
        return {0, std::numeric_limits<double>::infinity(), 0};
    }
    mean_t /= weights;
    double spread = 0;
    double seen = 0;
    double fitted = 0;
    double difference = 0;  // of measured and expected logarithm
    double square = 0;
    for_windows([&](std::size_t k, double power, double weight) {
        const double t = run.time_s[k] - mean_t;
        spread += weight * t * t;
        seen += weight * t * std::log(power);
        fitted += weight * t * std::log(expected[k].squaredNorm());
        const double off = std::log(power / expected[k].squaredNorm());
        difference += weight * off;
        square += weight * off * off;
    });
    // The scatter refers to the predicted line, because a motion other than a line bends both
    // alike.
    const double slope = (seen - fitted) / spread;
    const double scatter =
        (square - difference * difference / weights - slope * slope * spread) / (used - 2);
    return {-seen / spread / 2, 0.5 * std::sqrt(std::max(scatter, 1.0) / spread),
            -fitted / spread / 2};
}

}  // namespace vybeg
