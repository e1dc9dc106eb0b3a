#pragma once

#include "core/estimators/wave/wave_state.h"
#include "core/resonator/model/scaled_run.h"
#include "core/resonator/model/slow_dynamics.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace vybeg {

// Fitted motion, for drawing, for comparison with the phasors, and for curves derived from M.
struct FittedMotion {
    struct Run {
        double f_ref_hz = 0;  // as of the run's phasors
        ScaledRun frame;      // without windows: reference, power, duration, breaks
        Eigen::VectorXd own;  // parameters.h
    };

    double scale = 1;        // recording units of a scaled unit
    Eigen::VectorXd shared;  // parameters.h
    std::vector<Run> runs;
};

// Predicted phasors of the run at the given instants, ascending, or of short windows about them: c
// and d of the pick-offs relative to the run's f_ref_hz, recording units. Precondition: run <
// runs.size().
std::vector<Phasors> predicted_phasors(const FittedMotion& motion, std::size_t run,
                                       const std::vector<double>& time_s);

// Wave at those instants, without the errors of the channels.
std::vector<Phasors> predicted_waves(const FittedMotion& motion, std::size_t run,
                                     const std::vector<double>& time_s);

}  // namespace vybeg
