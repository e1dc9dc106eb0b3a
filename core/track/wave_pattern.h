#pragma once

#include "core/estimators/wave/wave_state.h"

#include <vector>

namespace vybeg {

// A wave as figures, for drawing (METHOD section 1), whatever its phase.

// A closed curve, its first point repeated at its end.
struct ClosedCurve {
    std::vector<double> x;
    std::vector<double> y;
};

// Amplitude (y) of the vibration against the angle on the rim (x, 0 to 2 pi):
// sqrt(a_A^2 cos^2 2(theta - theta_A) + a_B^2 sin^2 2(theta - theta_A)), from (6).
ClosedCurve polar_pattern(const WaveState& wave, int steps);

// C (x) and D (y) of (6) over one period: an ellipse of semi-axes a_A and |a_B|, its major axis
// at the angle 2theta_A from C. It runs anticlockwise for a_B > 0.
ClosedCurve channel_ellipse(const WaveState& wave, int steps);

}  // namespace vybeg
