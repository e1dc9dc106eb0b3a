#include "core/resonator/model/scaled_run.h"

#include "core/numerics/statistics.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>

namespace vybeg {

ScaledRun scaled_run(const PhasorRun& run, double scale) {
    ScaledRun scaled;
    const std::size_t n = run.time_s.size();
    scaled.time_s = run.time_s;
    scaled.window_s = run.window_s;
    scaled.correlation = run.noise_correlation;
    scaled.phase_lost = run.phase_lost;
    scaled.two_theta_zero = run.two_theta_zero;
    scaled.duration_s = run.time_s.back() + run.window_s / 2;
    std::vector<double> steps;
    double power = 0;
    double first_moment = 0;
    double square = 0;
    std::complex<double> turn = 0;
    for (std::size_t k = 0; k < n; ++k) {
        scaled.z.emplace_back(run.c[k] / scale, run.d[k] / scale);
        scaled.weight.push_back(scale / run.sd[k]);
        // The power of the noise, 4 variances, is subtracted from that of the wave.
        const double variance = 1 / (scaled.weight[k] * scaled.weight[k]);
        const double at = std::max(scaled.z[k].squaredNorm() - 4 * variance, 0.0);
        // Likewise for each channel; negative values are kept, so that means of pure noise are
        // unbiased.
        Eigen::Vector2cd channels = scaled.z[k];
        turn_channels(-run.two_theta_zero, channels[0], channels[1]);
        const double c = std::norm(channels[0]) - 2 * variance;
        const double d = std::norm(channels[1]) - 2 * variance;
        PowerSums& sums = scaled.power_sums;
        sums.cc += c * c;
        sums.cd += c * d;
        sums.dd += d * d;
        sums.c += c;
        sums.d += d;
        power += at;
        first_moment += at * run.time_s[k];
        square += at * at;
        if (k > 0) {
            steps.push_back(run.time_s[k] - run.time_s[k - 1]);
            // The rotation across a gap is ambiguous, as is that of a lost phase.
            if (!run.phase_lost && steps.back() < 1.5 * run.window_s) {
                turn += scaled.z[k - 1].dot(scaled.z[k]);
            }
        }
    }
    if (power > 0) {
        scaled.reference_s = first_moment / power;
        scaled.power = square / power;
    } else {
        scaled.reference_s = (run.time_s.front() + run.time_s.back()) / 2;
        scaled.power = 1;
    }
    scaled.step_s = median(std::move(steps));
    const double half_turn = std::arg(turn) / 2 * scaled.window_s / scaled.step_s;
    if (half_turn != 0) {
        scaled.power_kept = std::pow(std::sin(half_turn) / half_turn, 2);
    }
    // A break before the first window or after the last one has no effect.
    for (const RunBreak& at : run.breaks) {
        if (at.time_s > run.time_s.front() && at.time_s < run.time_s.back()) {
            scaled.breaks.push_back(at);
        }
    }
    return scaled;
}

std::vector<ScaledRun> scaled_runs(std::span<const PhasorRun> runs, double scale) {
    std::vector<ScaledRun> scaled;
    for (const PhasorRun& run : runs) {
        scaled.push_back(scaled_run(run, scale));
    }
    return scaled;
}

}  // namespace vybeg
