#pragma once

#include "core/estimators/wave_state.h"
#include "core/resonator/slow_dynamics.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace vybeg {

// The motion that a fit found, to draw it, to compare it with the phasors, and to derive curves
// from M. Amplitudes in recording units.
struct FittedMotion {
    struct Run {
        double f_ref_hz = 0;  // as of the run's phasors
        double f_hz = 0;      // from f_ref_hz, at middle_s
        double drift_hz_per_s = 0;
        double middle_s = 0;
        double window_s = 0;
        Eigen::Vector2cd start;  // z at t = 0 with the gain ratio taken out, as a window sees it
        std::vector<double> time_s;  // of the windows; and the integral of |z|^2 up to them
        std::vector<double> power_integral;
    };

    SlowRates rates;  // M without the runs' frequencies; with a skew for the free model
    double kappa = 1;
    double frequency_per_power = 0;  // Hz per squared recording unit
    std::vector<Run> runs;
};

// What the fit expects of a window of the run at `time_s`: c and d as the pick-offs give them (d
// over kappa) relative to the run's f_ref_hz, drift included. Precondition: run < runs.size().
Phasors predicted_phasors(const FittedMotion& motion, std::size_t run, double time_s);

}  // namespace vybeg
