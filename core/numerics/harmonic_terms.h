#pragma once

#include "core/numerics/dense_solvers.h"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// A rate as a function of an angle, by its harmonics: 1, then cos k theta and sin k theta of each
// k. Its coefficients are found from angles, through integrals of these terms along the motion.
template <class Terms = Eigen::VectorXd>
Terms harmonic_terms(std::span<const int> harmonics, double theta) {
    Terms terms(1 + 2 * static_cast<Eigen::Index>(harmonics.size()));
    terms[0] = 1;
    for (std::size_t i = 0; i < harmonics.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(2 * i);
        terms[at + 1] = std::cos(harmonics[i] * theta);
        terms[at + 2] = std::sin(harmonics[i] * theta);
    }
    return terms;
}

// The integrals of the terms from the first instant to each, by trapezoids. `theta`: the angle at
// each instant, unwrapped.
template <class Terms = Eigen::VectorXd>
std::vector<Terms> term_integrals(std::span<const int> harmonics, std::span<const double> time_s,
                                  std::span<const double> theta) {
    std::vector<Terms> sums;
    sums.reserve(time_s.size());
    Terms before = harmonic_terms<Terms>(harmonics, theta.empty() ? 0 : theta.front());
    for (std::size_t k = 0; k < time_s.size(); ++k) {
        if (k == 0) {
            sums.push_back(Terms::Zero(before.size()));
            continue;
        }
        const Terms here = harmonic_terms<Terms>(harmonics, theta[k]);
        sums.push_back(sums.back() + 0.5 * (time_s[k] - time_s[k - 1]) * (before + here));
        before = here;
    }
    return sums;
}

// Whether an information matrix separates all terms: its least eigenvalue in units of the
// information on the first one, a constant. Of a drift function six starts 15 degrees apart have
// more; four starts 22.5 degrees apart do not show the eighth harmonic.
inline bool separates_terms(const Eigen::MatrixXd& information) {
    constexpr double least_information = 0.02;
    const double unit = information(0, 0);
    if (!(unit > 0)) {
        return false;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(Eigen::MatrixXd(information / unit),
                                                               Eigen::EigenvaluesOnly);
    return eigen.eigenvalues()[0] >= least_information;
}

}  // namespace vybeg
