#pragma once

#include "core/resonator/fit/posterior.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
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

// Residual of a run in the frame of its fitted wave, and its derivatives: four real series in units
// of the windows' noise. Along the wave: amplitude and phase, log(<z, y>/|z|^2) |z|; across it:
// <z_perp, y>, z_perp = (-conj d, conj c)/|z|, rotated back by the residual's phase. The axes of
// the ellipse are unsuitable, because noise of the phase leaks into them through the quadrature
// wave.
struct ResidualSeries {
    enum Series { amplitude, phase, across_real, across_imaginary };

    std::vector<double> time_s;
    double window_s = 0;
    Eigen::VectorXd size;         // |z|, in units of the noise
    Eigen::VectorXd noise;        // of the windows' noise: that of the median over it
    Eigen::MatrixXd correlation;  // of the windows' noise; empty: white
    std::array<Eigen::VectorXd, 4> residual;
    // Places in posterior.active of the shared parameters and the run's own: others do not change
    // the run.
    std::vector<Eigen::Index> places;
    std::array<Eigen::MatrixXd, 4> by_parameter;  // columns as `places`
};

// Noise of the residual by restricted maximum likelihood: the part absorbed by the fit is projected
// out (FIT section 4). A line of one of eight widths common to all series, and a line or 1/f in the
// phase only, are each included if they raise the logarithm of the likelihood by four.
struct NoiseEstimate : ResidualNoise {
    // A cancelled job ends it early, with white noise.
    NoiseEstimate(const FitProblem& problem, const Posterior& posterior, const JobControl& job);

    // The data's part of the covariance under this noise, in the basis of the posterior's root:
    // that of the windows' noise as in the posterior, and R' (sum X'VX) R.
    Eigen::MatrixXd covariance(const Posterior& posterior) const;

    // The covariances of the further parts in a run's series, in units of their white noise: in all
    // four, and in the phase alone.
    std::array<Eigen::MatrixXd, 2> part_sums(const ResidualSeries& run) const;

    std::vector<ResidualSeries> series;
};

// Largest factor by which the colour of a fit's residual widens the variances of its rates.
double widening(const FitProblem& problem, const Posterior& posterior, const JobControl& job);

}  // namespace vybeg
