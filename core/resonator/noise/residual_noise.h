#pragma once

#include "core/resonator/noise/noise_shape.h"
#include "core/resonator/noise/residual_series.h"

#include <Eigen/Core>

#include <vector>

namespace vybeg {

// The noise of the residual by restricted maximum likelihood: what the fit has absorbed is taken
// out of the likelihood (FIT section 4). A line of one of eight widths common to all series, and a
// line or 1/f in the phase alone, each taken in where it raises the logarithm of the likelihood by
// four.
class NoiseEstimate {
public:
    NoiseEstimate(const FitProblem& problem, const Posterior& posterior);

    const ResidualNoise& noise() const { return noise_; }

    // The data's part of the covariance under this noise, in the basis of the posterior's root:
    // that of the windows' own noise as it stands there, and R' (sum X'VX) R.
    Eigen::MatrixXd covariance(const Posterior& posterior) const;

private:
    std::vector<ResidualSeries> series_;
    ResidualNoise noise_;
};

}  // namespace vybeg
