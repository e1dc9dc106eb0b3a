#pragma once

#include <vector>

namespace vybeg {

// A wave as figures, for drawing (METHOD section 1). Amplitudes in recording units, angles in rad.
struct StandingWave {
    double a_A = 0;
    double a_B = 0;
    double two_theta_A = 0;
};

// A closed curve, its first point repeated at its end.
struct ClosedCurve {
    std::vector<double> x;
    std::vector<double> y;
};

// Amplitude (y) of the vibration against the angle on the rim (x, 0 to 2 pi):
// sqrt(a_A^2 cos^2 2(theta - theta_A) + a_B^2 sin^2 2(theta - theta_A)), from (6).
ClosedCurve polar_pattern(const StandingWave& wave, int steps);

// C (x) and D (y) of (6) over one period: an ellipse of semi-axes a_A and |a_B|, its major axis
// at the angle 2theta_A from C. It runs anticlockwise for a_B > 0.
ClosedCurve channel_ellipse(const StandingWave& wave, int steps);

}  // namespace vybeg
