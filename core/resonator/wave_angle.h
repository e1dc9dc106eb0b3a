#pragma once

#include "core/resonator/phasor_model.h"

#include <vector>

namespace vybeg {

// The wave angle over a run, unwrapped modulo pi, up to where the power has fallen to 1 % of its
// largest: behind it noise turns the angle.
struct WaveAngle {
    std::vector<double> time_s;
    std::vector<double> two_theta;  // rad
};

WaveAngle wave_angle(const ScaledRun& run);

}  // namespace vybeg
