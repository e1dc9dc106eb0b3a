#include "core/resonator/fit/posterior.h"

#include "core/numerics/dense_solvers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace vybeg {
namespace {

// R with R R^T the inverse of a positive matrix. Where it is nearly singular, eigenvalues below
// 1e-14 of it are raised to that value, so that the inverse is huge, not infinite.
Eigen::MatrixXd inverse_root(const Eigen::MatrixXd& matrix) {
    constexpr double clear_pivot = 1e-5;  // its square is far above 1e-14
    const Eigen::VectorXd unit = to_unit_diagonal(matrix);
    const Eigen::MatrixXd scaled = unit.asDiagonal() * matrix * unit.asDiagonal();
    const Eigen::LLT<Eigen::MatrixXd> cholesky(scaled);
    if (cholesky.info() == Eigen::Success &&
        cholesky.matrixLLT().diagonal().minCoeff() > clear_pivot) {
        return unit.asDiagonal() * Eigen::MatrixXd(cholesky.matrixU().solve(
                                       Eigen::MatrixXd::Identity(unit.size(), unit.size())));
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
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

// Adds a run's symmetric matrix, shared parameters before its own, to one of all parameters.
void add_symmetric(const ParameterLayout& layout, std::size_t run, const Eigen::MatrixXd& square,
                   Eigen::MatrixXd& sum) {
    const Eigen::Index own = layout.own_size(run);
    const Eigen::Index first = layout.at(run, 0);
    sum.topLeftCorner(shared_count, shared_count) +=
        square.topLeftCorner(shared_count, shared_count);
    sum.block(first, 0, own, shared_count) += square.bottomLeftCorner(own, shared_count);
    sum.block(0, first, shared_count, own) += square.topRightCorner(shared_count, own);
    sum.block(first, first, own, own) += square.bottomRightCorner(own, own);
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

// Share of the prior's sd above which a direction is refused without a profile.
constexpr double seen_share = 0.1;
// A direction whose five deviations turn the wave by less than this, rad, is linear.
constexpr double linear_turn = 0.05;
constexpr double first_step = 2.5;  // standard deviations
// Depth beyond any local minimum due to noise.
constexpr double deep = 100;
// A single rise may be a refit without convergence.
constexpr int deep_twice = 2;
constexpr int refit_steps = 25;
// Share of the rise by the information, from which on it holds.
constexpr double seen_rise = 0.25;

}  // namespace

Eigen::Index Posterior::place_of(Eigen::Index parameter) const {
    const auto found = std::ranges::find(active, parameter);
    return found == active.end() ? -1 : found - active.begin();
}

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
    out.runs = linearised(problem, fit.p);
    std::vector<Eigen::Index> all(static_cast<std::size_t>(fit.p.size()));
    std::iota(all.begin(), all.end(), Eigen::Index{0});
    NormalEquations normal = normal_equations(problem, out.runs, all);
    out.information = std::move(normal.matrix);
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
    out.toward = out.root.transpose() * normal.right(out.active);
    out.covariance = out.root * out.root.transpose();
    const auto in_root = [&out](const Eigen::MatrixXd& precise) {
        return Eigen::MatrixXd(out.root.transpose() * precise * out.root);
    };
    out.data = in_root(score_covariance(problem, out)(out.active, out.active));
    out.known = in_root(told.asDiagonal());
    out.nothing = in_root(wide.asDiagonal());
    return out;
}

std::vector<ProfilePoint> unseen_directions(const FitProblem& problem, const MapFit& fit,
                                            const Posterior& posterior, double scale,
                                            const JobControl& job) {
    std::vector<ProfilePoint> points;
    const auto walk = [&](const Eigen::VectorXd& direction, double sd, double side,
                          double prior_sd) {
        // Response of all parameters to a step of one deviation.
        Eigen::VectorXd response = Eigen::VectorXd::Zero(fit.p.size());
        response(posterior.active) = posterior.covariance * direction(posterior.active) / sd;
        FitProblem moved = problem;
        Eigen::VectorXd p = fit.p;
        int in_a_row = 0;
        for (; std::abs(side) * sd <= prior_sd && !job.cancelled(); side *= 2) {
            p += response * (side - direction.dot(p - fit.p) / sd);
            moved.held = {{direction, direction.dot(fit.p) + side * sd, sd / 100}};
            const MapFit refit = minimise(moved, p, refit_steps, job);
            p = refit.p;
            const double rise = (refit.cost - fit.cost) / scale;
            in_a_row = rise <= deep ? 0 : in_a_row + 1;
            if (in_a_row == deep_twice) {
                return;
            }
            if (in_a_row == 0) {
                // Where the cost rises as the information says, the direction is seen, and a
                // quantity that moves by b side^2 has a variance of 2 b^2.
                const double squares = side * side;
                const bool seen = rise > seen_rise * squares;
                points.push_back({p, std::max(rise * (seen ? squares / 2 : 1), 1.0)});
            }
        }
    };
    struct Block {
        std::vector<Eigen::Index> parameters;
        double turn_per_unit;  // rad/s for a unit of the parameter
    };
    const std::array<Block, 3> blocks{{{{split_cos_at, split_sin_at}, 2 * std::numbers::pi},
                                       {{damping_cos_at, damping_sin_at}, 1},
                                       {{rotation_at}, 1}}};
    for (const auto& [parameters, turn_per_unit] : blocks) {
        std::vector<Eigen::Index> places;
        for (const Eigen::Index parameter : parameters) {
            places.push_back(posterior.place_of(parameter));
        }
        if (job.cancelled() || std::ranges::min(places) < 0) {
            continue;
        }
        const Eigen::MatrixXd part = posterior.covariance(places, places);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> principal(part);
        const double prior_sd = problem.priors.sd[parameters[0]];
        for (Eigen::Index k = principal.eigenvalues().size() - 1; k >= 0; --k) {
            const double sd = std::sqrt(std::max(principal.eigenvalues()[k], 0.0));
            if (!(sd <= seen_share * prior_sd &&
                  5 * sd * longest_s(problem) * turn_per_unit >= linear_turn)) {
                continue;
            }
            Eigen::VectorXd direction = Eigen::VectorXd::Zero(fit.p.size());
            direction(parameters) = principal.eigenvectors().col(k);
            for (const double side : {-first_step, first_step}) {
                walk(direction, sd, side, prior_sd);
            }
        }
    }
    return points;
}

}  // namespace vybeg
