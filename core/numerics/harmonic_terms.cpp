#include "core/numerics/harmonic_terms.h"

#include "core/numerics/dense_solvers.h"

namespace vybeg {

bool separates_terms(const Eigen::MatrixXd& information) {
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
