#include "core/resonator/fit/run_information.h"

#include "core/numerics/dense_solvers.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The limit of disagreement() for runs that agree: exceeded by chance in one of 1500 sets.
constexpr double most_disagreement = 3.2;

// Information of a run on the active shared parameters and, after them, on its deviations, at one
// point of the parameters; J^T r of its residual there. Both divided by the run's `noise`.
struct RunInformation {
    MatrixXd information;
    VectorXd toward;
};

VectorXd shared_precision(const FitProblem& problem, const std::vector<Index>& active) {
    return problem.priors.sd(active).cwiseAbs2().cwiseInverse();
}

// Inverse of a positive matrix; directions below `least` of the largest are left out.
MatrixXd positive_inverse(const MatrixXd& matrix, double least) {
    const VectorXd unit = to_unit_diagonal(matrix);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
        MatrixXd(unit.asDiagonal() * matrix * unit.asDiagonal()));
    const VectorXd& values = eigen.eigenvalues();
    const double limit = least * values.cwiseAbs().maxCoeff();
    VectorXd inverse(values.size());
    for (Index k = 0; k < values.size(); ++k) {
        inverse[k] = values[k] > limit ? 1 / values[k] : 0;
    }
    const MatrixXd vectors = unit.asDiagonal() * eigen.eigenvectors();
    return vectors * inverse.asDiagonal() * vectors.transpose();
}

// Own parameters of a run that are not held, with their priors as rows.
RunInformation reduced(const FitProblem& problem, std::size_t k, const VectorXd& p,
                       const std::vector<Index>& active, const VectorXd& own, double noise) {
    const ScaledRun& run = problem.runs[k];
    const Linearised at = linearised(run, p.head(shared_count), own, run.size());
    const Index rows = at.residual.size();
    const Index first = problem.layout.at(k, 0);
    std::vector<Index> free;
    for (Index j = 0; j < own.size(); ++j) {
        if (problem.priors.sd[first + j] > 0) {
            free.push_back(j);
        }
    }
    const auto count = static_cast<Index>(free.size());
    MatrixXd mine = MatrixXd::Zero(rows + count, count);
    VectorXd residual = VectorXd::Zero(rows + count);
    residual.head(rows) = at.residual;
    for (Index j = 0; j < count; ++j) {
        const Index place = free[static_cast<std::size_t>(j)];
        mine.col(j).head(rows) = at.by_parameter.col(shared_count + place);
        const double sd = problem.priors.sd[first + place];
        mine(rows + j, j) = 1 / sd;
        if (std::isfinite(sd)) {
            residual[rows + j] = (problem.priors.mean[first + place] - own[place]) / sd;
        }
    }
    const auto shared = static_cast<Index>(active.size());
    MatrixXd rest = MatrixXd::Zero(rows + count, shared + deviation_count);
    for (Index j = 0; j < shared; ++j) {
        rest.col(j).head(rows) = at.by_parameter.col(active[static_cast<std::size_t>(j)]);
    }
    rest.rightCols<deviation_count>().topRows(rows) = by_deviation(run, at, p);
    const VectorXd unit =
        mine.colwise().norm().cwiseMax(std::numeric_limits<double>::min()).cwiseInverse();
    const Eigen::HouseholderQR<MatrixXd> qr(mine * unit.asDiagonal());
    const MatrixXd q = qr.householderQ() * MatrixXd::Identity(rows + count, count);
    rest -= q * (q.transpose() * rest);
    return {rest.transpose() * rest / noise, rest.transpose() * residual / noise};
}

// Of each run at p.
std::vector<RunInformation> run_information(const FitProblem& problem, const VectorXd& p,
                                            std::span<const double> noise) {
    const std::vector<Index> active = active_shared(problem);
    std::vector<RunInformation> all;
    for (std::size_t k = 0; k < problem.runs.size(); ++k) {
        all.push_back(reduced(problem, k, p, active, own_of(problem.layout, p, k),
                              noise.empty() ? 1 : noise[k]));
    }
    return all;
}

// Sum over the runs of the information on the shared parameters and its right-hand side, priors
// included; the deviations of each run are free within `sd`, or zero.
struct SharedNormal {
    MatrixXd matrix;
    VectorXd right;
    double log_determinants = 0;  // of the deviations' matrices
    double gain = 0;              // of chi^2 by the deviations alone
};

SharedNormal shared_normal(const FitProblem& problem, const VectorXd& p,
                           const std::vector<Index>& active, std::span<const RunInformation> runs,
                           std::span<const RunDeviation> deviation, const RunDeviation* sd) {
    const VectorXd precision = shared_precision(problem, active);
    SharedNormal sum{precision.asDiagonal(),
                     precision.cwiseProduct((problem.priors.mean - p)(active)), 0, 0};
    const auto shared = static_cast<Index>(active.size());
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const RunInformation& run = runs[k];
        sum.matrix += run.information.topLeftCorner(shared, shared);
        sum.right += run.toward.head(shared);
        if (sd == nullptr) {
            continue;
        }
        const Eigen::Vector3d weight = sd->cwiseAbs2().cwiseInverse();
        const Eigen::Vector3d toward =
            run.toward.tail<deviation_count>() - weight.cwiseProduct(deviation[k]);
        Eigen::Matrix3d own = run.information.bottomRightCorner<3, 3>();
        own.diagonal() += weight;
        const MatrixXd cross = run.information.topRightCorner(shared, deviation_count);
        const Eigen::LDLT<Eigen::Matrix3d> solver(own);
        sum.matrix -= cross * solver.solve(MatrixXd(cross.transpose()));
        const Eigen::Vector3d solved = solver.solve(toward);
        sum.right -= cross * solved;
        sum.gain += toward.dot(solved) - weight.dot(deviation[k].cwiseAbs2());
        sum.log_determinants += solver.vectorD().array().abs().log().sum();
    }
    return sum;
}

// T as a normal deviate for the gradients b of the runs, their information A on the shared
// parameters, and the part B S B^T of the covariance of all b that the fit has taken.
double disagreement_of(const std::vector<VectorXd>& b, const std::vector<MatrixXd>& a,
                       const VectorXd& precision, const MatrixXd& taken) {
    const Index n = precision.size();
    const auto count = static_cast<Index>(b.size());
    MatrixXd covariance = -taken;
    MatrixXd product(n * count, n * count);
    double t = 0;
    for (Index k = 0; k < count; ++k) {
        const auto at = static_cast<std::size_t>(k);
        covariance.block(n * k, n * k, n, n) += a[at];
        const MatrixXd inverse = positive_inverse(a[at] + MatrixXd(precision.asDiagonal()), 1e-13);
        t += b[at].dot(inverse * b[at]);
        product.middleRows(n * k, n) = inverse * covariance.middleRows(n * k, n);
    }
    const double mean = product.trace();
    const double variance = 2 * product.cwiseProduct(product.transpose()).sum();
    constexpr double least_mean = 0.1;
    // Also for NaN: runs that say nothing of each other do not disagree.
    if (!(mean > least_mean) || !(variance > 0) || !std::isfinite(t)) {
        return 0;
    }
    const double freedom = 2 * mean * mean / variance;
    const double scatter = 2 / (9 * freedom);
    return (std::cbrt(t / mean) - 1 + scatter) / std::sqrt(scatter);
}

// T of all runs at p as a normal deviate; zero where they gain nothing.
double disagreement(const FitProblem& problem, const VectorXd& p,
                    std::span<const RunInformation> runs) {
    const std::vector<Index> active = active_shared(problem);
    const VectorXd precision = shared_precision(problem, active);
    const SharedNormal sum = shared_normal(problem, p, active, runs, {}, nullptr);
    const MatrixXd covariance = positive_inverse(sum.matrix, 1e-15);
    const VectorXd step = covariance * sum.right;
    const Index n = precision.size();
    std::vector<VectorXd> b;
    std::vector<MatrixXd> a;
    MatrixXd all(n * static_cast<Index>(runs.size()), n);
    for (const RunInformation& run : runs) {
        a.emplace_back(run.information.topLeftCorner(n, n));
        b.emplace_back(run.toward.head(n) - a.back() * step);
        all.middleRows(n * static_cast<Index>(a.size() - 1), n) = a.back();
    }
    return disagreement_of(b, a, precision, all * covariance * all.transpose());
}

}  // namespace

std::vector<Index> active_shared(const FitProblem& problem) {
    std::vector<Index> active = problem.priors.active();
    std::erase_if(active, [](Index k) { return k >= shared_count; });
    return active;
}

MatrixXd by_deviation(const ScaledRun& run, const Linearised& at, const VectorXd& p) {
    // linearised() is by the set's parameters; by a deviation it is the parameter times that, up to
    // the factor 1 + deviation.
    MatrixXd by(at.by_parameter.rows(), deviation_count);
    by << at.by_parameter.col(decay_at) * (p[decay_at] / (1 + run.deviation[decay_deviates])),
        at.by_parameter.middleCols<2>(split_cos_at) *
            (p.segment<2>(split_cos_at) / (1 + run.deviation[split_deviates])),
        at.by_parameter.col(kappa_at) * (p[kappa_at] / (1 + run.deviation[kappa_deviates]));
    return by;
}

bool runs_agree(const FitProblem& problem, const VectorXd& p, std::span<const double> noise) {
    return disagreement(problem, p, run_information(problem, p, noise)) < most_disagreement;
}

std::vector<double> falls_without(const FitProblem& problem, const VectorXd& p,
                                  std::span<const double> noise) {
    const std::vector<RunInformation> runs = run_information(problem, p, noise);
    const std::vector<Index> active = active_shared(problem);
    const SharedNormal sum = shared_normal(problem, p, active, runs, {}, nullptr);
    const MatrixXd covariance = positive_inverse(sum.matrix, 1e-15);
    const VectorXd step = covariance * sum.right;
    const auto n = static_cast<Index>(active.size());
    std::vector<double> falls;
    for (const RunInformation& run : runs) {
        const MatrixXd a = run.information.topLeftCorner(n, n);
        const VectorXd b = run.toward.head(n) - a * step;
        falls.push_back(b.dot(positive_inverse(a - a * covariance * a, 1e-10) * b));
    }
    return falls;
}

Spread spread_of(const FitProblem& start, const VectorXd& p, std::span<const double> noise,
                 bool follow, const JobControl& job) {
    constexpr double absurd = 30;  // deviations in units of the largest
    constexpr double plausible = 2.5;
    constexpr double none = 1e-6;  // relative scatter
    const RunDeviation largest = largest_spread();
    std::vector<RunDeviation> grid;
    for (int k = 0; k < 64; ++k) {
        const Eigen::Vector3d place = Eigen::Vector3i(k / 16, k / 4 % 4, k % 4).cast<double>();
        grid.emplace_back((place.array() == 0)
                              .select(none, largest.array() * Eigen::pow(4.0, place.array() - 3)));
    }
    FitProblem problem = start;
    const std::vector<Index> active = active_shared(problem);
    const auto shared = static_cast<Index>(active.size());
    std::vector<RunDeviation> deviation;
    std::ranges::transform(problem.runs, std::back_inserter(deviation), &ScaledRun::deviation);
    Spread found{.p = p};
    RunDeviation best = largest;
    const int steps = follow ? 6 : 1;
    for (int step = 0; step < steps && !job.cancelled(); ++step) {
        const bool last = step + 1 == steps;
        const std::vector<RunInformation> runs = run_information(problem, found.p, noise);
        const auto trial = [&](const RunDeviation& sd) {
            return shared_normal(problem, found.p, active, runs, deviation, &sd);
        };
        const auto likelihood = [&](const SharedNormal& sum, const RunDeviation& sd) {
            const VectorXd unit = to_unit_diagonal(sum.matrix);
            const Eigen::LDLT<MatrixXd> solver(unit.asDiagonal() * sum.matrix * unit.asDiagonal());
            const VectorXd right = unit.cwiseProduct(sum.right);
            const double log_determinant =
                solver.vectorD().array().abs().log().sum() - 2 * unit.array().log().sum();
            return (sum.gain + right.dot(solver.solve(right)) - log_determinant -
                    sum.log_determinants) /
                       2 -
                   static_cast<double>(runs.size()) * sd.array().log().sum();
        };
        double most = -std::numeric_limits<double>::infinity();
        std::vector<double> all;
        for (const RunDeviation& sd : grid) {
            all.push_back(likelihood(trial(sd), sd));
            if (all.back() > most) {
                most = all.back();
                best = sd;
            }
        }
        if (last) {
            double weight = 0;
            Eigen::Vector3d variance = Eigen::Vector3d::Zero();
            for (std::size_t k = 0; k < grid.size(); ++k) {
                const double each = std::exp(all[k] - most);
                if (each > 0) {  // not NaN
                    weight += each;
                    variance += each * grid[k].cwiseAbs2();
                }
            }
            found.sd = (variance / std::max(weight, 1e-300)).cwiseSqrt();
            // The likelihood without each scatter, whatever the others are.
            Eigen::Vector3d without =
                Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
            for (std::size_t k = 0; k < grid.size(); ++k) {
                for (Index of = 0; of < 3; ++of) {
                    if (grid[k][of] < none * 1.5 && all[k] > without[of]) {
                        without[of] = all[k];
                    }
                }
            }
            found.clear = (2 * (most - without.array())).max(0.0).sqrt();
        }
        const SharedNormal sum = trial(best);
        const MatrixXd covariance = positive_inverse(sum.matrix, 1e-15);
        const VectorXd move = covariance * sum.right;
        const Eigen::Vector3d weight = best.cwiseAbs2().cwiseInverse();
        std::vector<RunDeviation> to = deviation;
        for (std::size_t k = 0; k < runs.size(); ++k) {
            Eigen::Matrix3d own = runs[k].information.bottomRightCorner<3, 3>();
            own.diagonal() += weight;
            to[k] += own.ldlt().solve(
                Eigen::Vector3d(runs[k].toward.tail<3>() - weight.cwiseProduct(deviation[k]) -
                                runs[k].information.bottomLeftCorner(3, shared) * move));
        }
        if (last) {
            // Covariance of all b with the deviations fitted: of shared parameters and deviations.
            const auto count = static_cast<Index>(runs.size());
            const Index size = shared + deviation_count * count;
            MatrixXd whole = MatrixXd::Zero(size, size);
            MatrixXd by = MatrixXd::Zero(shared * count, size);
            whole.topLeftCorner(shared, shared) = shared_precision(problem, active).asDiagonal();
            std::vector<VectorXd> b;
            std::vector<MatrixXd> a;
            for (Index k = 0; k < count; ++k) {
                const RunInformation& run = runs[static_cast<std::size_t>(k)];
                const Index own = shared + deviation_count * k;
                const MatrixXd cross = run.information.topRightCorner(shared, deviation_count);
                a.emplace_back(run.information.topLeftCorner(shared, shared));
                whole.topLeftCorner(shared, shared) += a.back();
                whole.block(0, own, shared, deviation_count) = cross;
                whole.block(own, 0, deviation_count, shared) = cross.transpose();
                whole.block<3, 3>(own, own) = run.information.bottomRightCorner<3, 3>();
                whole.block<3, 3>(own, own).diagonal() += weight;
                by.block(shared * k, 0, shared, shared) = a.back();
                by.block(shared * k, own, shared, deviation_count) = cross;
                const auto at = static_cast<std::size_t>(k);
                b.emplace_back(run.toward.head(shared) - a.back() * move -
                               cross * (to[at] - deviation[at]));
            }
            const double left =
                disagreement_of(b, a, shared_precision(problem, active),
                                by * positive_inverse(whole, 1e-15) * by.transpose());
            found.explains = left < most_disagreement;
        }
        bool bounded = move.allFinite();
        for (std::size_t k = 0; k < to.size(); ++k) {
            const double size = (to[k].array() / largest.array()).abs().maxCoeff();
            bounded = bounded && size < absurd;
            found.explains = found.explains && size < plausible;  // not for NaN
        }
        if (!bounded) {
            found.explains = false;
            return found;
        }
        if (!follow) {
            break;
        }
        // Own parameters follow in a fit, with the deviations held.
        deviation = to;
        found.p(active) += move;
        for (std::size_t k = 0; k < problem.runs.size(); ++k) {
            problem.runs[k].deviation = deviation[k];
        }
        const MapFit fit = minimise(problem, found.p, 10, job);
        found.p = fit.p;
    }
    found.deviation = std::move(deviation);
    return found;
}

}  // namespace vybeg
