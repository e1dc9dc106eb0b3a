#include "core/resonator/model_fit.h"

#include <Eigen/Eigenvalues>

#include <ceres/ceres.h>
#include <cmath>
#include <memory>
#include <utility>

namespace vybeg {
namespace {

// The residuals of one run as Ceres wants them: parameter blocks are the coordinates in the basis
// of the space, and the run's own.
class RunCost : public ceres::CostFunction {
public:
    RunCost(const ScaledRun& run, const Shared& origin, const Eigen::MatrixXd& basis)
        : run_(run), origin_(origin), basis_(basis) {
        set_num_residuals(static_cast<int>(4 * run.size()));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(basis.cols()));
        mutable_parameter_block_sizes()->push_back(own_count);
    }

    bool Evaluate(double const* const* parameters, double* residual,
                  double** jacobians) const override {
        const Eigen::Map<const Eigen::VectorXd> x(parameters[0], basis_.cols());
        const Shared shared = origin_ + basis_ * x;
        const Eigen::Map<const Own> own(parameters[1]);
        double* by_x = jacobians != nullptr ? jacobians[0] : nullptr;
        double* by_own = jacobians != nullptr ? jacobians[1] : nullptr;
        RowMajor by_shared(by_x != nullptr ? num_residuals() : 0, shared_count);
        residuals(run_, shared, own, residual, by_x != nullptr ? by_shared.data() : nullptr,
                  by_own);
        if (by_x != nullptr) {
            Eigen::Map<RowMajor>(by_x, num_residuals(), basis_.cols()) = by_shared * basis_;
        }
        // A step into a motion that grows beyond all numbers is refused, and a shorter one tried.
        return Eigen::Map<const Eigen::VectorXd>(residual, num_residuals()).allFinite();
    }

private:
    const ScaledRun& run_;
    const Shared& origin_;
    const Eigen::MatrixXd& basis_;
};

class StopWhenCancelled : public ceres::IterationCallback {
public:
    explicit StopWhenCancelled(const JobControl& job) : job_(job) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
        return job_.cancelled() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
    }

private:
    const JobControl& job_;
};

}  // namespace

ModelSpace space_of(std::initializer_list<int> shared, bool drift) {
    ModelSpace space{Eigen::MatrixXd::Zero(shared_count, static_cast<Eigen::Index>(shared.size())),
                     drift};
    Eigen::Index column = 0;
    for (const int index : shared) {
        space.basis(index, column++) = 1;
    }
    return space;
}

Eigen::Index dimension(const ModelSpace& space, std::size_t runs) {
    return space.basis.cols() +
           static_cast<Eigen::Index>(runs) * (space.drift ? own_count : own_count - 1);
}

double degrees(std::span<const ScaledRun> runs, const ModelSpace& space) {
    double residuals = 0;
    for (const ScaledRun& run : runs) {
        residuals += 4 * static_cast<double>(run.size());
    }
    return residuals - static_cast<double>(dimension(space, runs.size()));
}

double enlargement_of(double chi2, double dof) {
    const double ratio = chi2 / dof;
    return ratio > 1 + 4 * std::sqrt(2 / dof) ? ratio : 1;
}

Result<ModelFit> fit_model(std::span<const ScaledRun> runs, const ModelSpace& space,
                           const FitState& start, const JobControl& job) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(space.basis.cols());
    std::vector<Own> own = start.runs;
    auto order = std::make_shared<ceres::ParameterBlockOrdering>();
    ceres::Problem problem;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        problem.AddResidualBlock(new RunCost(runs[k], start.shared, space.basis), nullptr, x.data(),
                                 own[k].data());
        order->AddElementToGroup(own[k].data(), 0);
        if (!space.drift) {
            problem.SetManifold(own[k].data(), new ceres::SubsetManifold(own_count, {drift_index}));
        }
    }
    order->AddElementToGroup(x.data(), 1);
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR;
    options.linear_solver_ordering = std::move(order);
    options.num_threads = 1;
    options.max_num_iterations = 100;
    // It ends with a step that lowers chi^2 by less than 1e-4, for 10^4 residuals: a hundredth of a
    // standard deviation before that step, far below it behind it.
    options.function_tolerance = 1e-8;
    options.parameter_tolerance = 1e-14;
    options.gradient_tolerance = 0;
    // What the data hardly see stays damped, by 1e-10 of the information of its coordinates:
    // without it the factorisation fails, and Ceres says so on standard error.
    options.max_trust_region_radius = 1e8;
    options.min_lm_diagonal = 1e-2;
    options.logging_type = ceres::SILENT;
    StopWhenCancelled stop(job);
    options.callbacks.push_back(&stop);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (job.cancelled()) {
        return Error{ErrorCode::interrupted, {}, {}};
    }
    if (!summary.IsSolutionUsable()) {
        return Error{ErrorCode::fit_failed, {}, {"the phasors do not follow any slow motion"}};
    }
    return ModelFit{{start.shared + space.basis * x, std::move(own)},
                    2 * summary.final_cost,
                    summary.termination_type == ceres::CONVERGENCE};
}

Eigen::MatrixXd covariance(std::span<const ScaledRun> runs, const ModelSpace& space,
                           const FitState& state) {
    const Eigen::MatrixXd full = normal_equations(runs, state).information;
    // Columns of P are the directions of the space in the full coordinates.
    Eigen::MatrixXd p = Eigen::MatrixXd::Zero(full.rows(), dimension(space, runs.size()));
    p.topLeftCorner(shared_count, space.basis.cols()) = space.basis;
    Eigen::Index column = space.basis.cols();
    for (std::size_t k = 0; k < runs.size(); ++k) {
        for (int own = 0; own < own_count; ++own) {
            if (own != drift_index || space.drift) {
                p(shared_count + own_count * static_cast<Eigen::Index>(k) + own, column++) = 1;
            }
        }
    }
    const Eigen::MatrixXd information = p.transpose() * full * p;
    // Unit diagonal: the coordinates have units that differ by many powers of ten.
    Eigen::VectorXd unit = information.diagonal();
    for (double& entry : unit) {
        entry = entry > 0 ? 1 / std::sqrt(entry) : 1;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(unit.asDiagonal() * information *
                                                               unit.asDiagonal());
    const Eigen::VectorXd inverse = eigen.eigenvalues().cwiseMax(1e-14).cwiseInverse();
    const Eigen::MatrixXd half = p * unit.asDiagonal() * eigen.eigenvectors();
    return half * inverse.asDiagonal() * half.transpose();
}

}  // namespace vybeg
