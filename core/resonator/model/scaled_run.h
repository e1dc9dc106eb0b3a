#pragma once

#include "core/resonator/model/phasor_run.h"

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// The power of a run's frequency, sum |z|^4 / sum |z|^2, as a function of the gain ratio: |z|^2 is
// |c|^2 + kappa^2 |d|^2 of the recorded channels.
struct PowerSums {
    double cc = 0;  // sum |c|^4
    double cd = 0;  // sum |c|^2 |d|^2
    double dd = 0;
    double c = 0;  // sum |c|^2
    double d = 0;

    double at(double kappa) const {
        const double k2 = kappa * kappa;
        const double power = c + k2 * d;
        return power > 0 ? (cc + 2 * k2 * cd + k2 * k2 * dd) / power : 0;
    }
};

// How much 1/tau, split and gain ratio of one run differ from those of its set, relative.
enum Deviating : int { decay_deviates, split_deviates, kappa_deviates, deviation_count };
using RunDeviation = Eigen::Matrix<double, deviation_count, 1>;

// A run for the fit: phasors divided by a scale common to the set.
struct ScaledRun {
    std::vector<double> time_s;  // centres of the windows
    std::vector<Eigen::Vector2cd> z;
    std::vector<double> weight;       // 1/sd of a real part
    std::vector<double> correlation;  // of the noise of windows 0, 1, 2, ... apart; empty: white
    std::vector<RunBreak> breaks;     // between the first and the last window
    double window_s = 0;
    double step_s = 0;       // median distance of neighbours
    double duration_s = 0;   // from t = 0 to the end of the last window
    double reference_s = 0;  // instant of the run's frequency: mean of t weighted with |z|^2
    // Share of the power kept by the windows' means, at the run's mean frequency.
    double power_kept = 1;
    double power = 0;         // power of the run's frequency in recorded channels
    bool phase_lost = false;  // as PhasorRun, like the next
    double two_theta_zero = 0;
    PowerSums power_sums;
    RunDeviation deviation = RunDeviation::Zero();  // zero unless the runs of the set differ
    // Makes the noise of C and D equal and independent, in units of the windows' sd.
    Eigen::Matrix2d whitening = Eigen::Matrix2d::Identity();

    std::size_t size() const { return time_s.size(); }
    // Turns the recorded channels by the angle zero.
    Eigen::Matrix2d turn() const {
        Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
        turn_channels(two_theta_zero, turn(0, 0), turn(1, 0));
        turn_channels(two_theta_zero, turn(0, 1), turn(1, 1));
        return turn;
    }
    // Phasors of a window in deviations of its noise, and back.
    Eigen::Vector2cd weighted(std::size_t window, const Eigen::Vector2cd& phasor) const {
        return weight[window] * (whitening * phasor);
    }
    Eigen::Vector2cd unweighted(std::size_t window, const Eigen::Vector2cd& phasor) const {
        return whitening.triangularView<Eigen::Lower>().solve(phasor) / weight[window];
    }
    // Number of the parameters of all breaks.
    std::size_t break_parameters() const {
        std::size_t count = 0;
        for (const RunBreak& each : breaks) {
            count += static_cast<std::size_t>(break_size(each.kind));
        }
        return count;
    }
};

// Re c, Im c, Re d, Im d of a phasor, the order of residuals and starts, and back.
inline Eigen::Vector4d real_parts(const Eigen::Vector2cd& z) {
    return {z[0].real(), z[0].imag(), z[1].real(), z[1].imag()};
}
inline Eigen::Vector2cd of_real_parts(const Eigen::Vector4d& parts) {
    return {std::complex(parts[0], parts[1]), std::complex(parts[2], parts[3])};
}

// Precondition: at least two windows, all sd > 0.
ScaledRun scaled_run(const PhasorRun& run, double scale);
std::vector<ScaledRun> scaled_runs(std::span<const PhasorRun> runs, double scale);

}  // namespace vybeg
