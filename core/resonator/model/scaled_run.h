#pragma once

#include "core/resonator/model/phasor_run.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace vybeg {

// A run as the fit uses it: phasors divided by a scale common to the set.
struct ScaledRun {
    std::vector<double> time_s;  // centres of the windows
    std::vector<Eigen::Vector2cd> z;
    std::vector<double> weight;       // 1/sd of a real part
    std::vector<double> correlation;  // of the noise of windows 0, 1, 2, ... apart; empty: white
    std::vector<double> breaks_s;     // instants after which the phase is not known
    double window_s = 0;
    double step_s = 0;       // median distance of neighbours
    double duration_s = 0;   // from t = 0 to the end of the last window
    double reference_s = 0;  // instant of the run's frequency: mean of t weighted with |z|^2
    double power_kept = 1;   // by the windows' means at the run's mean frequency
    double power = 0;        // power of the run's frequency: sum |z|^4 / sum |z|^2

    std::size_t size() const { return time_s.size(); }
};

// Precondition: at least two windows, all sd > 0.
ScaledRun scaled_run(const PhasorRun& run, double scale);

}  // namespace vybeg
