#include "core/resonator/runs/merge_windows.h"

#include "core/numerics/kaiser.h"
#include "core/numerics/spectral_density.h"
#include "core/numerics/statistics.h"
#include "core/resonator/model/parameters.h"
#include "core/resonator/model/phasor_run.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>
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

// Covariance of the means of `count` windows each, `lag` of those means apart, in units of a
// window's variance.
double merged_covariance(const PhasorRun& run, std::size_t count, std::size_t lag) {
    const auto n = static_cast<std::ptrdiff_t>(count);
    const std::vector<double> white{1};
    return covariance_of_sums(run.noise_correlation.empty() ? white : run.noise_correlation, n,
                              static_cast<std::ptrdiff_t>(lag)) /
           static_cast<double>(n * n);
}

std::vector<double> merged_correlation(const PhasorRun& run, std::size_t count) {
    std::vector<double> correlation;
    const std::size_t lags = (run.noise_correlation.size() + count - 1) / count;
    const double own = merged_covariance(run, count, 0);
    for (std::size_t lag = 0; !run.noise_correlation.empty() && lag <= lags; ++lag) {
        correlation.push_back(merged_covariance(run, count, lag) / own);
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
            power += run.power(k);
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

// Power over that of the noise around, of both channels: noise of a million bins reaches 20.
constexpr double stands_out = 30;
// Bins of a line, and those of noise around it.
constexpr std::ptrdiff_t own_bins = 10;
constexpr std::ptrdiff_t around_bins = 40;
constexpr std::size_t least_points = 128;
// Side lobes below -90 dB: the residual of the wave in merged windows stays near it.
constexpr double beta = 12;

// Power of both channels' residual by frequency bin, windows on the grid of their times.
std::vector<double> residual_powers(const PhasorRun& run, const std::vector<Phasors>& expected) {
    const auto place = [&run](std::size_t k) {
        return static_cast<std::size_t>(
            std::lround((run.time_s[k] - run.time_s[0]) / run.window_s));
    };
    const std::size_t points = place(run.time_s.size() - 1) + 1;
    const std::size_t size = std::bit_ceil(points);
    std::vector<std::complex<double>> c(size);
    std::vector<std::complex<double>> d(size);
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        const std::size_t at = place(k);
        const double x = 2 * (static_cast<double>(at) + 0.5) / static_cast<double>(points) - 1;
        const double weight = kaiser_window(x, beta) / run.sd[k];
        c[at] = weight * (run.c[k] - expected[k].c);
        d[at] = weight * (run.d[k] - expected[k].d);
    }
    return bin_powers(std::move(c), std::move(d));
}

double noise_around(const std::vector<double>& power, std::ptrdiff_t bin) {
    // Median over mean of the sum of four squares.
    constexpr double median_over_mean = 0.83917;
    const auto size = std::ssize(power);
    std::vector<double> around;
    for (std::ptrdiff_t apart = own_bins; apart < own_bins + around_bins; ++apart) {
        for (const std::ptrdiff_t at : {bin - apart, bin + apart}) {
            around.push_back(power[static_cast<std::size_t>((at % size + size) % size)]);
        }
    }
    return median(std::move(around)) / median_over_mean;
}

// Difference of the turn of a window between the ends of a run, rad; a mean loses (turn)^2/24 of
// the amplitude. What a drift takes is in the model up to the second order.
double uneven_turn(const FittedMotion& motion) {
    constexpr double not_in_model = 0.3;
    const Eigen::VectorXd& shared = motion.shared;
    double most = 0;
    for (const FittedMotion::Run& run : motion.runs) {
        const double fallen = -std::expm1(-2 * shared[decay_at] * run.frame.duration_s);
        const double by_power =
            shared[cubic_at] * run.own.segment<4>(start_at).squaredNorm() * fallen;
        const double change_hz =
            not_in_model * std::abs(run.own[drift_at]) * run.frame.duration_s + std::abs(by_power);
        most = std::max(most, 2 * std::numbers::pi * change_hz * run.frame.window_s);
    }
    return most;
}

// Distance from the reference frequency, Hz, of the strongest line in the residual of the unmerged
// windows beyond the band of the merged ones, where it acts at its alias. Zero if no line exceeds
// the noise.
double line_beyond(const FittedMotion& motion, std::span<const PhasorRun> fine) {
    double best_hz = 0;
    double most = 0;
    for (std::size_t k = 0; k < fine.size(); ++k) {
        const PhasorRun& run = fine[k];
        const double band_hz = 0.5 / motion.runs[k].frame.window_s;
        if (run.time_s.size() < least_points || band_hz >= 0.49 / run.window_s) {
            continue;
        }
        const std::vector<double> power =
            residual_powers(run, predicted_phasors(motion, k, run.time_s));
        const auto size = std::ssize(power);
        for (std::ptrdiff_t bin = 0; bin < size; ++bin) {
            const double f_hz = static_cast<double>(std::min(bin, size - bin)) /
                                (static_cast<double>(size) * run.window_s);
            if (f_hz <= band_hz) {
                continue;
            }
            const double height = power[static_cast<std::size_t>(bin)] / noise_around(power, bin);
            if (height > stands_out && height > most) {
                most = height;
                best_hz = f_hz;
            }
        }
    }
    return best_hz;
}

constexpr double significant = 6;  // standard deviations
constexpr double most_correlation = 0.95;
constexpr std::size_t differences = 3;

Eigen::Matrix2d whitening(const PhasorRun& run, const std::vector<Phasors>& fitted) {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    double count = 0;
    for (std::size_t k = 0; k + differences < run.time_s.size(); ++k) {
        const double length = run.time_s[k + differences] - run.time_s[k];
        if (std::abs(length / run.window_s - static_cast<double>(differences)) > 0.01) {
            continue;
        }
        Eigen::Vector2cd difference = Eigen::Vector2cd::Zero();
        double factor = 1;
        for (std::size_t j = 0; j <= differences; ++j) {
            const std::size_t at = k + j;
            difference += factor / run.sd[at] *
                          Eigen::Vector2cd(run.c[at] - fitted[at].c, run.d[at] - fitted[at].d);
            factor *= -static_cast<double>(differences - j) / static_cast<double>(j + 1);
        }
        sum += (difference * difference.adjoint()).real();
        count += 1;
    }
    const double trace = sum.trace();
    if (!(trace > 0) || !std::isfinite(trace)) {
        return Eigen::Matrix2d::Identity();
    }
    const Eigen::Matrix2d covariance = 2 / trace * sum;
    // Neighbouring differences are not independent: a third of them counts.
    const double sd = std::sqrt(3 / count);
    const double correlation = covariance(0, 1) / std::sqrt(covariance(0, 0) * covariance(1, 1));
    const double unlike = std::log(covariance(1, 1) / covariance(0, 0)) / 2;
    const bool differs =
        std::abs(correlation) > significant * sd || std::abs(unlike) > significant * sd;
    // NaN of a silent channel is no noise to weight by.
    // The inverse of noise that is nearly the same in both rests on their small difference.
    if (!differs || !std::isfinite(correlation + unlike) ||
        std::abs(correlation) > most_correlation) {
        return Eigen::Matrix2d::Identity();
    }
    const Eigen::LLT<Eigen::Matrix2d> factor(covariance);
    if (factor.info() != Eigen::Success) {
        return Eigen::Matrix2d::Identity();
    }
    return factor.matrixL().solve(Eigen::Matrix2d::Identity());
}

}  // namespace

PhasorRun usable_windows(const PhasorRun& run) {
    return kept_windows(run, [&](std::size_t k) {
        const double sum = run.time_s[k] + std::abs(run.c[k]) + std::abs(run.d[k]) + run.sd[k];
        return std::isfinite(sum) && run.sd[k] > 0;
    });
}

PhasorRun seen_windows(const PhasorRun& run) {
    std::size_t end = 0;
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        end = run.power(k) > 100 * run.sd[k] * run.sd[k] ? k + 1 : end;
    }
    return kept_windows(run, 0, end);
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

NeededWindows needed_windows(const FittedMotion& motion, std::span<const PhasorRun> fine) {
    constexpr double even_turn = 0.003;  // rad
    constexpr double whole_turn = 0.02;
    constexpr double most_for_turn = 1000;
    constexpr double per_cycle = 4;
    // Lines that would need more windows are left aliased, because the time of the fit would grow
    // tenfold.
    constexpr double most_for_line = 700;
    const double beyond_hz = line_beyond(motion, fine);
    const double uneven = uneven_turn(motion) / even_turn;
    const double mode_hz =
        std::abs(SlowDynamics(motion.shared).half_difference().imag()) / (2 * std::numbers::pi);
    NeededWindows needed;
    for (const FittedMotion::Run& run : motion.runs) {
        const double now = run.frame.duration_s / run.frame.window_s;
        double for_turn = now * uneven;
        if (motion.shared[cubic_at] != 0) {
            // The spring depends on the whole amplitude of both modes, of which means lose a part.
            const double turn = 2 * std::numbers::pi * mode_hz * run.frame.window_s;
            for_turn = std::max(for_turn, now * turn / whole_turn);
        }
        const double mode_at_hz = std::abs(run.own[frequency_at]) + mode_hz;
        const double cycles = per_cycle * run.frame.duration_s;
        // NaN of a fit that failed asks for no more windows.
        for (const double windows : {std::min(for_turn, most_for_turn), cycles * mode_at_hz}) {
            needed.by_motion = windows > needed.by_motion ? windows : needed.by_motion;
        }
        if (cycles * beyond_hz < most_for_line) {
            needed.by_line = std::max(needed.by_line, cycles * beyond_hz);
        }
    }
    return needed;
}

std::vector<Eigen::Matrix2d> whitenings(const FittedMotion& motion,
                                        std::span<const PhasorRun> runs) {
    std::vector<Eigen::Matrix2d> all;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        all.push_back(whitening(runs[k], predicted_phasors(motion, k, runs[k].time_s)));
    }
    return all;
}

}  // namespace vybeg
