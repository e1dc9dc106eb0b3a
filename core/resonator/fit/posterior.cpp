#include "core/resonator/fit/posterior.h"

#include "core/numerics/dense_solvers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vybeg {
namespace {

// R with R R^T the inverse of a positive matrix whose rows have units that differ by many powers of
// ten. Eigenvalues below 1e-14 of the matrix are raised to that value, so that the inverse is huge,
// not infinite.
Eigen::MatrixXd inverse_root(const Eigen::MatrixXd& matrix) {
    const Eigen::VectorXd unit =
        matrix.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
        Eigen::MatrixXd(unit.asDiagonal() * matrix * unit.asDiagonal()));
    return unit.asDiagonal() * eigen.eigenvectors() *
           eigen.eigenvalues().cwiseMax(1e-14).cwiseSqrt().cwiseInverse().asDiagonal();
}

// Contribution of one run to J^T J by the noise correlation of neighbouring windows, neighbours by
// their order.
Eigen::MatrixXd correlated_part(const ScaledRun& run, const RowMajor& by_parameter) {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(by_parameter.cols(), by_parameter.cols());
    for (std::size_t lag = 1; lag < std::min(run.correlation.size(), run.size()); ++lag) {
        const Eigen::Index rows = by_parameter.rows() - 4 * static_cast<Eigen::Index>(lag);
        const Eigen::MatrixXd cross =
            by_parameter.topRows(rows).transpose() * by_parameter.bottomRows(rows);
        sum += run.correlation[lag] * (cross + cross.transpose());
    }
    return sum;
}

// J^T V J of all parameters, V the noise correlation of the windows.
Eigen::MatrixXd score_covariance(const FitProblem& problem, const Posterior& posterior) {
    Eigen::MatrixXd sum = posterior.information;
    for (std::size_t k = 0; k < problem.runs.size(); ++k) {
        if (!problem.runs[k].correlation.empty()) {
            add_symmetric(problem.layout, k,
                          correlated_part(problem.runs[k], posterior.runs[k].by_parameter), sum);
        }
    }
    return sum;
}

// J^T r of all parameters.
Eigen::VectorXd toward_residual(const FitProblem& problem, std::span<const Linearised> runs) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(problem.layout.size());
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const Eigen::Index own = problem.layout.own_size(k);
        const Eigen::VectorXd toward = runs[k].by_parameter.transpose() * runs[k].residual;
        sum.head(shared_count) += toward.head(shared_count);
        sum.segment(problem.layout.at(k, 0), own) += toward.tail(own);
    }
    return sum;
}

}  // namespace

double Posterior::chi2() const {
    double sum = 0;
    for (const Linearised& run : runs) {
        sum += run.residual.squaredNorm();
    }
    return sum;
}

Eigen::MatrixXd Posterior::covariance_of(const Eigen::MatrixXd& gradient) const {
    const Eigen::MatrixXd in_root = gradient * root;
    return in_root * (data + known + nothing) * in_root.transpose();
}

Eigen::MatrixXd Posterior::covariance_of(Eigen::Index first, Eigen::Index count) const {
    const Eigen::MatrixXd rows = root.middleRows(first, count);
    return rows * (data + known + nothing) * rows.transpose();
}

Eigen::MatrixXd Posterior::root_of(const std::vector<Eigen::Index>& places) const {
    const auto count = static_cast<Eigen::Index>(places.size());
    if (count == root.rows()) {
        return root(places, Eigen::all);
    }
    const Eigen::HouseholderQR<Eigen::MatrixXd> factor(
        Eigen::MatrixXd(root(places, Eigen::all).transpose()));
    return factor.matrixQR()
        .topRows(count)
        .triangularView<Eigen::Upper>()
        .toDenseMatrix()
        .transpose();
}

Posterior posterior(const FitProblem& problem, const MapFit& fit) {
    Posterior out;
    out.p = fit.p;
    out.active = problem.priors.active();
    out.runs = linearised(problem, fit.p, true);
    out.information = information(problem, out.runs);
    const auto count = static_cast<Eigen::Index>(out.active.size());
    Eigen::VectorXd wide = Eigen::VectorXd::Zero(count);
    Eigen::VectorXd told = Eigen::VectorXd::Zero(count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const Eigen::Index at = out.active[static_cast<std::size_t>(k)];
        const double precision = std::pow(problem.priors.sd[at], -2);
        switch (prior_kind(problem.layout, at)) {
            case PriorKind::physical: wide[k] = precision; break;
            case PriorKind::channel: told[k] = precision; break;
            case PriorKind::none: break;
        }
    }
    const Eigen::MatrixXd seen = out.information(out.active, out.active);
    Eigen::MatrixXd precision = seen;
    precision.diagonal() += wide + told;
    out.alone_sd = precision.diagonal().cwiseSqrt().cwiseInverse();
    out.root = inverse_root(precision);
    out.toward = out.root.transpose() * toward_residual(problem, out.runs)(out.active);
    out.covariance = out.root * out.root.transpose();
    const auto in_root = [&out](const Eigen::MatrixXd& precise) {
        return Eigen::MatrixXd(out.root.transpose() * precise * out.root);
    };
    out.data = in_root(score_covariance(problem, out)(out.active, out.active));
    out.known = in_root(told.asDiagonal());
    out.nothing = in_root(wide.asDiagonal());
    return out;
}

}  // namespace vybeg
