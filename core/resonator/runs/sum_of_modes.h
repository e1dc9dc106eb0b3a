#pragma once

#include "core/resonator/model/phasor_run.h"

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

namespace vybeg {

// One or two modes with an amplitude of their own in each channel, whatever the channels show:
//     z(t) = sum over modes of shape e^{rate t}        rate = 2 pi i (f - f_ref) - 1/tau
// Unlike the free model (METHOD section 8), whose M has the shapes as eigenvectors, this sum is
// regular where both channels show the same projection and the shapes are parallel.
struct ModeSum {
    std::vector<std::complex<double>> rates;  // by falling frequency
    std::vector<double> rate_sd;           // of the real and of the imaginary part, for the scatter
    std::vector<Eigen::Vector2cd> shapes;  // (c, d) at the first window
    std::vector<double> shape_sd;          // relative, of the larger part
    double beat_sd = 0;                    // of the difference of two rates, as rate_sd
    double chi2 = 0;
    double freedom = 0;
    double correlated_windows = 1;  // over which what it leaves keeps its sign
};

// The sum of `count` modes (1 or 2) of least squares: start values by linear prediction over
// several lags, then Gauss and Newton. Empty for fewer than 16 windows and where no lag has a
// solution.
std::optional<ModeSum> sum_of_modes(const PhasorRun& run, std::size_t count);

// Whether both channels of the recording show the same projection of its motion: two modes that
// beat, with shapes parallel within a tenth. A wave at rest is one mode and leaves this
// open; a pair of pick-offs at 45 degrees has shapes at right angles, or modes that decay before
// they beat. Where the two modes are a part of the motion only, as in a bell's first second, the
// channels must agree within 3 % throughout, a whole beat must be seen, and no third of it may be
// one mode, as it is before and after a drive.
bool shares_projection(const PhasorRun& run);

}  // namespace vybeg
