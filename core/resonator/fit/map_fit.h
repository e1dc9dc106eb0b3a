#pragma once

#include "core/base/job_control.h"
#include "core/resonator/model/phasor_model.h"
#include "core/resonator/model/priors.h"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace vybeg {

// A row (direction . p - value)/sd in addition to the priors, which holds a direction of the
// parameters.
struct HeldDirection {
    Eigen::VectorXd direction;
    double value = 0;
    double sd = 1;
};

// Sum of squares whose minimum is the maximum of the posterior: weighted residuals of the windows,
// priors, and held directions.
struct FitProblem {
    std::vector<ScaledRun> runs;
    ParameterLayout layout;
    Priors priors;
    double noise_ratio =
        2;  // ratio of chi^2 to the number of residuals above which other starts are tried
    double damping_share = 1;  // width of the damping anisotropy's prior, in units of 1/tau
    std::vector<HeldDirection> held = {};
};

// The problem of these runs, without priors yet.
FitProblem problem_of(std::vector<ScaledRun> runs);

// The problem of some of its runs, `which`, with the same priors.
FitProblem part_of(const FitProblem& problem, std::span<const std::size_t> which);
// Their parameters among all.
Eigen::VectorXd part_of(const ParameterLayout& layout, const Eigen::VectorXd& p,
                        std::span<const std::size_t> which);

// A run's own parameters among all.
Eigen::VectorXd own_of(const ParameterLayout& layout, const Eigen::VectorXd& p, std::size_t run);

// Adds rows of a run, shared parameters before its own, to those of all parameters: of a vector, or
// of a matrix with its own columns.
template <class Rows, class Sum>
void add_rows(const ParameterLayout& layout, std::size_t run, const Rows& rows, Sum& sum) {
    const Eigen::Index own = layout.own_size(run);
    sum.topRows(shared_count) += rows.topRows(shared_count);
    sum.middleRows(layout.at(run, 0), own) += rows.bottomRows(own);
}

// The parameters of a list that change a run: their places in it, and their columns among the
// derivatives of the run.
struct RunColumns {
    std::vector<Eigen::Index> places;
    std::vector<Eigen::Index> columns;
};
RunColumns columns_of(const ParameterLayout& layout, std::size_t run,
                      const std::vector<Eigen::Index>& parameters);

// Predicted phasors in all windows of a run at p.
std::vector<Eigen::Vector2cd> expected_phasors(const FitProblem& problem, const Eigen::VectorXd& p,
                                               std::size_t run);

// chi^2 at p of the first `windows` windows of all runs; a part of it where that exceeds `most`.
double chi_square(const FitProblem& problem, const Eigen::VectorXd& p,
                  std::size_t windows = std::numeric_limits<std::size_t>::max(),
                  double most = std::numeric_limits<double>::infinity());

// Derivatives of every run's residuals at p, with `wanted` and `before` of phasor_model.h, of its
// first `windows` windows.
std::vector<Linearised> linearised(const FitProblem& problem, const Eigen::VectorXd& p,
                                   SharedColumns wanted = all_shared,
                                   std::size_t windows = std::numeric_limits<std::size_t>::max(),
                                   std::vector<Linearised> before = {});

// J^T J and J^T r of the windows for some parameters, in ascending order, from those derivatives.
struct NormalEquations {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd right;
};
NormalEquations normal_equations(const FitProblem& problem, std::span<const Linearised> runs,
                                 const std::vector<Eigen::Index>& parameters);

// Factors that give a positive matrix a unit diagonal: the units of its rows differ by many powers
// of ten.
Eigen::VectorXd to_unit_diagonal(const Eigen::MatrixXd& matrix);

struct MapFit {
    Eigen::VectorXd p;
    double cost = 0;       // of data, priors and held direction
    double chi2 = 0;       // of the data
    double last_gain = 0;  // fall of the cost in the last step
    bool converged = false;

    // Whether the last step gained at most a tenth of a standard deviation: undetermined parameters
    // continue to change in steps of smaller gain.
    bool finished() const { return converged || last_gain <= 0.01; }
};

// Levenberg and Marquardt from p, the normal matrix scaled to a unit diagonal, at most `steps` of
// them; later steps are bent by the second derivative along them where that lowers the cost
// (Transtrum and Sethna, arXiv:1201.5885). Ends when a step lowers the cost by less than 1e-5, a
// three-hundredth of a standard deviation. With many windows it begins on some of them, and ends on
// all. `windows`: uses only as many first windows of each run.
// One thread, reproducible bits. A cancelled job ends it early. Precondition: the cost at p is
// finite.
MapFit minimise(const FitProblem& problem, const Eigen::VectorXd& p, int steps,
                const JobControl& job,
                std::size_t windows = std::numeric_limits<std::size_t>::max());

// Length of the longest run.
double longest_s(const FitProblem& problem);

// Number of residuals less that of the parameters without a prior.
double degrees_of_freedom(const FitProblem& problem);

// Largest chi^2 of white noise, per degree of freedom and all of it: six deviations above the mean.
inline double noise_bound(double dof) {
    return 1 + 6 * std::sqrt(2 / dof);
}
inline double noise_limit(double dof) {
    return noise_bound(dof) * dof;
}

}  // namespace vybeg
