#pragma once

#include "core/resonator/fit/posterior.h"

#include <Eigen/Core>

#include <vector>

namespace vybeg {

// Parameters about as likely as those of the fit.
struct ProfilePoint {
    Eigen::VectorXd p;
    // By which the square of a quantity's way there is its variance: the rise of the cost, in units
    // of the residual's scale, at least 1; along a direction that is seen for curved quantities.
    double rise = 1;
};

// Points far along directions of split, damping or rotation that are only apparently determined
// (FIT section 3). A still wave determines the second component of the split only through a
// transverse motion that may be noise, while the information at the maximum is too large. The
// profile moves by 2.5, 5, 10, ... standard deviations along each such direction, with all other
// parameters fitted again, until the cost has risen by 100 or the prior's width is reached.
// `scale`: variance of the residual over that of its noise.
std::vector<ProfilePoint> unseen_directions(const FitProblem& problem, const MapFit& fit,
                                            const Posterior& posterior, double scale,
                                            const JobControl& job);

}  // namespace vybeg
