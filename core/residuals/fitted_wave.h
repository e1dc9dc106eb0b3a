#pragma once

#include "core/analysis/analysis.h"

#include <vector>

namespace vybeg {

// A curve of both channels over time: seconds, recording units. NaN where no window, or one without
// a wave, has the time.
struct SignalCurve {
    std::vector<double> time_s;
    std::vector<double> c;
    std::vector<double> d;
};

// The wave (6) of the windows at `count` times at equal distances from from_s to to_s, also between
// samples; each time has the wave of the sample nearest to it (window_wave.h). Preconditions: the
// track has all rows of its plan; count >= 2.
SignalCurve wave_curve(const Analysis& analysis, double rate_hz, double from_s, double to_s,
                       int count);

// Amplitudes of C and D, sqrt(a_A^2 cos^2 2theta_A + a_B^2 sin^2 2theta_A) and its like by (6), in
// columns of equal width: the mean of eight windows at most in each. Columns begin at whole
// multiples of their width, so that a curve that is panned does not flicker; one lies beyond each
// end. Preconditions: as above; count >= 1, from_s < to_s.
SignalCurve amplitude_curve(const Analysis& analysis, double rate_hz, double from_s, double to_s,
                            int count);

}  // namespace vybeg
