#pragma once

#include "core/resonator/fit/map_fit.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace vybeg {

// What each run of a set says of the set's shared parameters, its own parameters eliminated, and
// whether the runs agree (FIT section 9).

// Relative deviations of a run: 1/tau, split, gain ratio (RunDeviation).
inline constexpr int deviation_count = 3;

// Information of a run on the active shared parameters and, after them, on its deviations, at one
// point of the parameters; J^T r of its residual there. Both divided by the variance of the run's
// noise in units of that of its windows.
struct RunInformation {
    Eigen::MatrixXd information;
    Eigen::VectorXd toward;
};

// The active ones among the shared parameters.
std::vector<Eigen::Index> active_shared(const FitProblem& problem);

// Derivatives of a run's weighted phasors by its deviations, at the set's parameters p.
Eigen::MatrixXd by_deviation(const ScaledRun& run, const Linearised& at, const Eigen::VectorXd& p);

// `noise`: variance of each run's noise in units of that of its windows.
std::vector<RunInformation> run_information(const FitProblem& problem, const Eigen::VectorXd& p,
                                            std::span<const double> noise);

// The limit of disagreement() for runs that agree: exceeded by chance in one of 1500 sets.
inline constexpr double most_disagreement = 3.2;

// Gain of all runs by shared parameters of their own, T = sum b^T (A + L)^-1 b, as a deviate of the
// normal distribution (Wilson and Hilferty). Small sets and unseen parameters leave no gain: zero.
double disagreement(const FitProblem& problem, const Eigen::VectorXd& p,
                    std::span<const RunInformation> runs);

// By how much chi^2 falls if one run has shared parameters of its own, for small differences; of
// each run.
std::vector<double> falls_without(const FitProblem& problem, const Eigen::VectorXd& p,
                                  std::span<const RunInformation> runs);

// Runs whose 1/tau, split and gain ratio scatter: sd of the scatter by restricted maximum
// likelihood over a grid, up to the sizes of `largest_spread`.
struct Spread {
    Eigen::VectorXd p;                    // the set's parameters
    std::vector<RunDeviation> deviation;  // of each run
    RunDeviation sd;                      // root mean square over the likelihood of the grid
    bool explains = false;                // small deviations, and what is left agrees
};

// Largest spread that counts as one resonator at unlike temperatures; relative.
inline constexpr RunDeviation largest_spread{0.02, 0.05, 0.002};

// From p, in a few steps; without `follow` about p itself: for runs that agree.
Spread spread_of(const FitProblem& problem, const Eigen::VectorXd& p, std::span<const double> noise,
                 bool follow, const JobControl& job);

}  // namespace vybeg
