#pragma once

#include "core/resonator/map_fit.h"

#include <Eigen/Core>

#include <vector>

namespace vybeg {

// The Gaussian about the maximum of the posterior, in the parameters that are not held. With F the
// data's information, L the priors' precision and S = (F + L)^-1, the covariance S has three parts:
// what the data leave, what is known of the channels, and what rests on priors that state nothing.
struct Posterior {
    Eigen::VectorXd p;                 // all parameters, at the maximum
    std::vector<Eigen::Index> active;  // rows and columns of the matrices below
    std::vector<Linearised> runs;      // residuals and derivatives at p
    Eigen::MatrixXd information;       // F of all parameters, held ones too
    Eigen::MatrixXd covariance;        // S
    Eigen::MatrixXd root;              // R, S = R R^T
    Eigen::VectorXd alone_sd;          // of each parameter with all others known
    Eigen::MatrixXd data;              // S F S, or S (sum X' V X) S where the residual is coloured
    Eigen::MatrixXd known;             // S L S of the channels
    Eigen::MatrixXd nothing;           // S L S of the physical priors
};

// With white noise.
Posterior posterior(const FitProblem& problem, const MapFit& fit);

}  // namespace vybeg
