#pragma once

#include "core/resonator/fit/map_fit.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace vybeg {

// What each run of a set says of the set's shared parameters, its own parameters eliminated, and
// whether the runs agree (FIT section 10).

// The active ones among the shared parameters.
std::vector<Eigen::Index> active_shared(const FitProblem& problem);

// Derivatives of a run's weighted phasors by its deviations, at the set's parameters p.
Eigen::MatrixXd by_deviation(const ScaledRun& run, const Linearised& at, const Eigen::VectorXd& p);

// Whether the runs of the fit at p agree: gain of all runs by shared parameters of their own,
// T = sum b^T (A + L)^-1 b, as a deviate of the normal distribution (Wilson and Hilferty), of which
// small sets and unseen parameters leave none. `noise`, here and below: variance of each run's
// noise in units of that of its windows; empty: one.
bool runs_agree(const FitProblem& problem, const Eigen::VectorXd& p,
                std::span<const double> noise = {});

// By how much chi^2 falls if one run has shared parameters of its own, for small differences; of
// each run.
std::vector<double> falls_without(const FitProblem& problem, const Eigen::VectorXd& p,
                                  std::span<const double> noise);

// Runs whose 1/tau, split and gain ratio scatter: sd of the scatter by restricted maximum
// likelihood over a grid, up to the sizes of largest_spread().
struct Spread {
    Eigen::VectorXd p;                      // the set's parameters
    std::vector<RunDeviation> deviation{};  // of each run
    // Root mean square over the likelihood of the grid.
    RunDeviation sd = RunDeviation::Zero();
    // By the likelihood, deviates from no scatter.
    RunDeviation clear = RunDeviation::Zero();
    bool explains = false;  // small deviations, and the residual agrees
};

// Largest spread that counts as one resonator at unlike temperatures; relative.
inline RunDeviation largest_spread() {
    return {0.02, 0.05, 0.002};
}

// From p, in a few steps; without `follow` about p itself: for runs that agree.
Spread spread_of(const FitProblem& problem, const Eigen::VectorXd& p, std::span<const double> noise,
                 bool follow, const JobControl& job);

}  // namespace vybeg
