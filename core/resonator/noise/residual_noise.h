#pragma once

#include "core/resonator/noise/noise_shape.h"
#include "core/resonator/noise/residual_series.h"

#include <Eigen/Core>

#include <vector>

namespace vybeg {

// Noise of the residual by restricted maximum likelihood: the part absorbed by the fit is projected
// out (FIT section 4). A line of one of eight widths common to all series, and a line or 1/f in the
// phase only, are each included if they raise the logarithm of the likelihood by four.
class NoiseEstimate {
public:
    // A cancelled job ends it early, with white noise.
    NoiseEstimate(const FitProblem& problem, const Posterior& posterior, const JobControl& job);

    const ResidualNoise& noise() const { return noise_; }

    // The data's part of the covariance under this noise, in the basis of the posterior's root:
    // that of the windows' noise as in the posterior, and R' (sum X'VX) R.
    Eigen::MatrixXd covariance(const Posterior& posterior) const;

    const std::vector<ResidualSeries>& series() const { return series_; }

private:
    std::vector<ResidualSeries> series_;
    ResidualNoise noise_;
};

// Largest factor by which the colour of a fit's residual widens the variances of its rates.
double widening(const FitProblem& problem, const Posterior& posterior, const JobControl& job);

}  // namespace vybeg
