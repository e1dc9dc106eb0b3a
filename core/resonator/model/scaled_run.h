#pragma once

#include "core/resonator/model/phasor_run.h"

#include <Eigen/Core>

#include <cstddef>
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
struct RunDeviation {
    double decay = 0;
    double split = 0;
    double kappa = 0;
};

// A run for the fit: phasors divided by a scale common to the set.
struct ScaledRun {
    std::vector<double> time_s;  // centres of the windows
    std::vector<Eigen::Vector2cd> z;
    std::vector<double> weight;       // 1/sd of a real part
    std::vector<double> correlation;  // of the noise of windows 0, 1, 2, ... apart; empty: white
    std::vector<double> breaks_s;     // instants after which the phase is unknown
    double window_s = 0;
    double step_s = 0;       // median distance of neighbours
    double duration_s = 0;   // from t = 0 to the end of the last window
    double reference_s = 0;  // instant of the run's frequency: mean of t weighted with |z|^2
    // Share of the power kept by the windows' means, at the run's mean frequency.
    double power_kept = 1;
    double power = 0;  // power of the run's frequency in recorded channels
    PowerSums power_sums;
    RunDeviation deviation;  // zero unless the runs of the set differ

    std::size_t size() const { return time_s.size(); }
};

// Precondition: at least two windows, all sd > 0.
ScaledRun scaled_run(const PhasorRun& run, double scale);

}  // namespace vybeg
