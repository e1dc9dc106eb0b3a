#pragma once

#include "core/resonator/fit/map_fit.h"

#include <Eigen/Core>

#include <vector>

namespace vybeg {

// Gaussian approximation about the maximum of the posterior, in the parameters that are not held.
// With F the information of the data, L the precision of the priors and S = (F + L)^-1, the
// covariance S has three parts: from the data, from known channels, and from priors without
// information.
struct Posterior {
    Eigen::VectorXd p;                 // all parameters, at the maximum
    std::vector<Eigen::Index> active;  // rows and columns of the matrices below
    std::vector<Linearised> runs;      // residuals and derivatives at p
    Eigen::MatrixXd information;       // F of all parameters, held ones too
    Eigen::MatrixXd covariance;        // S
    Eigen::MatrixXd root;              // R, S = R R^T
    Eigen::VectorXd toward;            // R^T J^T r, r the residuals
    Eigen::VectorXd alone_sd;          // of each parameter with all others known
    // The parts in the basis of R, a part P meaning R P R^T, because nearly degenerate parameters
    // leave no digit of P R^T.
    Eigen::MatrixXd data;     // S F S, or S (sum X' V X) S where the residual is coloured
    Eigen::MatrixXd known;    // S L S of the channels
    Eigen::MatrixXd nothing;  // S L S of the physical priors

    // The place of a parameter among the active ones; -1: it is held.
    Eigen::Index place_of(Eigen::Index parameter) const;

    // chi^2 of the data.
    double chi2() const;

    // The covariance of quantities by their gradients (a row each) in the active parameters.
    Eigen::MatrixXd covariance_of(const Eigen::MatrixXd& gradient) const;
    // That of the active parameters from `first` on.
    Eigen::MatrixXd covariance_of(Eigen::Index first, Eigen::Index count) const;
    // A square root of the block of S at some places among the active parameters, which keeps the
    // digits of nearly degenerate ones.
    Eigen::MatrixXd root_of(const std::vector<Eigen::Index>& places) const;
};

// With white noise.
Posterior posterior(const FitProblem& problem, const MapFit& fit);

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
