#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vybeg {

// The shape of a part of the noise about the carrier: a line of Lorentz with a half width, 1/f, or
// white.
struct NoiseShape {
    double half_width_hz = 0;  // 0: 1/f; infinite: white
    bool of_phase = false;     // in the phase alone, in proportion to the amplitude
};

// What the residual holds beside white noise. Variances in units of the white noise of a window.
struct ResidualNoise {
    struct Part {
        NoiseShape shape;
        double variance = 0;
    };
    // Each part as the mean over widths and variances, weighted with their likelihood: no single
    // recording tells them sharply. Empty where the residual is white.
    std::vector<Part> parts;
    // The narrowest line of the grid fits best: noise narrower than that is one more phasor,
    // constant over the run, which no residual shows.
    bool narrowest = false;

    // Nothing beside the noise of the windows.
    bool as_expected() const { return parts.empty(); }
    // Beside it, more white noise at most.
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
