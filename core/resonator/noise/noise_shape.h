#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vybeg {

// Shape of a part of the noise about the carrier: a Lorentz line with a half width, 1/f, or white.
struct NoiseShape {
    double half_width_hz = 0;  // 0: 1/f; infinite: white
    bool of_phase = false;     // in the phase only, in proportion to the amplitude
};

// Parts of the residual besides white noise. Variances in units of the white noise of a window.
struct ResidualNoise {
    struct Part {
        NoiseShape shape;
        double variance = 0;
    };
    // Each part is the mean over widths and variances, weighted with their likelihood, because a
    // single recording does not determine them sharply. Empty for a white residual.
    std::vector<Part> parts;
    // The narrowest line of the grid fits best: narrower noise is one more phasor, constant over
    // the run, which no residual shows.
    bool narrowest = false;
    // Rise of the logarithm of the likelihood by all parts.
    double rise = 0;

    // Whether the residual is the noise of the windows only.
    bool as_expected() const { return parts.empty(); }
    // Whether all further parts are white.
    bool white() const {
        return std::ranges::all_of(
            parts, [](const Part& part) { return std::isinf(part.shape.half_width_hz); });
    }
};

// Covariances of the means over windows of `window_s` at the given instants. A line: variance 1,
// exp(-b |lag|), b = 2 pi half_width. 1/f: -ln |lag|, up to a constant, which is that of the phase.
Eigen::MatrixXd shape_covariance(const NoiseShape& shape, const std::vector<double>& time_s,
                                 double window_s);

}  // namespace vybeg
