#include "core/resonator/runs/merge_windows.h"

#include "core/resonator/model/kept_windows.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace vybeg {
namespace {

constexpr double most_turn = 0.3;  // rad

// Whether window k + 1 follows window k without a gap.
bool touch(const PhasorRun& run, std::size_t k) {
    const auto between = [&](double at) { return at > run.time_s[k] && at < run.time_s[k + 1]; };
    return std::abs((run.time_s[k + 1] - run.time_s[k]) / run.window_s - 1) < 0.01 &&
           std::ranges::none_of(run.breaks, between, &RunBreak::time_s);
}

double correlation_at(const PhasorRun& run, std::ptrdiff_t lag) {
    const auto at = static_cast<std::size_t>(std::abs(lag));
    if (run.noise_correlation.empty()) {
        return at == 0 ? 1 : 0;
    }
    return at < run.noise_correlation.size() ? run.noise_correlation[at] : 0;
}

// Covariance of the means of `count` windows each, `lag` of those means apart, in units of a
// window's variance.
double merged_covariance(const PhasorRun& run, std::size_t count, std::ptrdiff_t lag) {
    const auto n = static_cast<std::ptrdiff_t>(count);
    double sum = 0;
    for (std::ptrdiff_t difference = 1 - n; difference < n; ++difference) {
        sum += static_cast<double>(n - std::abs(difference)) *
               correlation_at(run, lag * n + difference);
    }
    return sum / static_cast<double>(n * n);
}

std::vector<double> merged_correlation(const PhasorRun& run, std::size_t count) {
    std::vector<double> correlation;
    const std::size_t lags = (run.noise_correlation.size() + count - 1) / count;
    const double own = merged_covariance(run, count, 0);
    for (std::size_t lag = 0; !run.noise_correlation.empty() && lag <= lags; ++lag) {
        correlation.push_back(merged_covariance(run, count, static_cast<std::ptrdiff_t>(lag)) /
                              own);
    }
    return correlation;
}

// Root mean square change of z from one window to the next, over its size, without the noise.
double turn_per_window(const PhasorRun& run) {
    double change = 0;
    double power = 0;
    for (std::size_t k = 0; k + 1 < run.time_s.size(); ++k) {
        if (touch(run, k)) {
            change += std::norm(run.c[k + 1] - run.c[k]) + std::norm(run.d[k + 1] - run.d[k]) -
                      4 * (run.sd[k] * run.sd[k] + run.sd[k + 1] * run.sd[k + 1]);
            power += std::norm(run.c[k]) + std::norm(run.d[k]);
        }
    }
    return power > 0 ? std::sqrt(std::max(change, 0.0) / power) : most_turn;
}

// Merges `count` windows at a time; a gap begins a new group.
PhasorRun merged_by(const PhasorRun& run, std::size_t count) {
    PhasorRun merged;
    merged.f_ref_hz = run.f_ref_hz;
    merged.window_s = run.window_s * static_cast<double>(count);
    merged.noise_correlation = merged_correlation(run, count);
    merged.breaks = run.breaks;
    merged.two_theta_zero = run.two_theta_zero;
    // Correlated noise averages less.
    const double noise_left = merged_covariance(run, count, 0) * static_cast<double>(count);
    const double share = 1 / static_cast<double>(count);
    std::size_t first = 0;
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        if (k + 1 - first == count) {
            double time = 0;
            double variance = 0;
            std::complex<double> c = 0;
            std::complex<double> d = 0;
            for (std::size_t j = first; j <= k; ++j) {
                time += share * run.time_s[j];
                variance += share * share * run.sd[j] * run.sd[j];
                c += share * run.c[j];
                d += share * run.d[j];
            }
            merged.time_s.push_back(time);
            merged.c.push_back(c);
            merged.d.push_back(d);
            merged.sd.push_back(std::sqrt(variance * noise_left));
            first = k + 1;
        } else if (k + 1 < run.time_s.size() && !touch(run, k)) {
            first = k + 1;
        }
    }
    return merged;
}

}  // namespace

PhasorRun usable_windows(const PhasorRun& run) {
    return kept_windows(run, [&](std::size_t k) {
        const double sum = run.time_s[k] + std::abs(run.c[k]) + std::abs(run.d[k]) + run.sd[k];
        return std::isfinite(sum) && run.sd[k] > 0;
    });
}

PhasorRun merge_windows(const PhasorRun& run, std::size_t most) {
    const std::size_t windows = run.time_s.size();
    if (windows <= most) {
        return run;
    }
    const double by_turn = most_turn / std::max(turn_per_window(run), 1e-9);
    std::size_t count =
        std::min((windows + most - 1) / most, static_cast<std::size_t>(std::max(by_turn, 1.0)));
    for (; count > 1; count /= 2) {
        PhasorRun merged = merged_by(run, count);
        if (10 * merged.time_s.size() * count >= 9 * windows) {
            return merged;
        }
    }
    return run;
}

}  // namespace vybeg
