#include "core/resonator/merge_windows.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace vybeg {
namespace {

constexpr double most_turn = 0.3;  // rad

bool touch(const PhasorRun& run, std::size_t k) {
    return std::abs((run.time_s[k + 1] - run.time_s[k]) / run.window_s - 1) < 0.01;
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

// `count` windows at a time; those that do not touch begin anew.
PhasorRun merged_by(const PhasorRun& run, std::size_t count) {
    PhasorRun merged{run.f_ref_hz, run.window_s * static_cast<double>(count), {}, {}, {}, {}};
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
            merged.sd.push_back(std::sqrt(variance));
            first = k + 1;
        } else if (k + 1 < run.time_s.size() && !touch(run, k)) {
            first = k + 1;
        }
    }
    return merged;
}

}  // namespace

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
