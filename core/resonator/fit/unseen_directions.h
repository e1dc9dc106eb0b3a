#pragma once

#include "core/resonator/fit/posterior.h"

#include <Eigen/Core>

#include <vector>

namespace vybeg {

// Parameters about as likely as the fit's.
struct ProfilePoint {
    Eigen::VectorXd p;
    double rise = 1;  // of the cost, in units of the residual's scale, at least 1
};

// Points far along directions of split, damping or rotation that only seem to be seen (FIT section
// 3). A still wave sees the second component of the split only through a transverse motion that may
// be noise; there the information at the maximum claims to know it. Each such direction is moved by
// 2.5, 5, 10, ... standard deviations with the rest fitted again, until the cost has risen by 100
// or the prior's width is reached. `scale`: variance of the residual over that of its noise.
std::vector<ProfilePoint> unseen_directions(const FitProblem& problem, const MapFit& fit,
                                            const Posterior& posterior, double scale,
                                            const JobControl& job);

}  // namespace vybeg
