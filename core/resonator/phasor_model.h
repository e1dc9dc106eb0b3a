#pragma once

#include "core/resonator/phasor_run.h"
#include "core/resonator/slow_dynamics.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace vybeg {

// The model of the window phasors of one run, in recording units divided by a common scale:
//     c_k = z_1(t_k), d_k = z_2(t_k) / kappa,  z(t) = e^{i phi(t)} exp(M t) y
//     phi = 2 pi (f t + drift (t^2/2 - t t_mid) + b P(t)),  P = integral of |z|^2 as measured
// so that f is the frequency at t_mid, where it is known best: in the middle of a run that hardly
// decays, one decay time from the start of one that decays away. exp(M t) and the mean over a
// window commute: y is the start as a window sees it, and no window is too long for the model.

// What all runs share, in this order: the rates, kappa, b.
inline constexpr int kappa_index = rate_count;
inline constexpr int power_index = rate_count + 1;
inline constexpr int shared_count = rate_count + 2;
using Shared = Eigen::Matrix<double, shared_count, 1>;

// What each run has of its own: f (Hz from f_ref), drift (Hz/s), Re and Im of y_1, y_2.
inline constexpr int frequency_index = 0;
inline constexpr int drift_index = 1;
inline constexpr int start_index = 2;
inline constexpr int own_count = 6;
using Own = Eigen::Matrix<double, own_count, 1>;

Shared to_shared(const SlowRates& rates);  // kappa = 1, b = 0
SlowRates rates_of(const Shared& shared);
Eigen::Vector2cd start_of(const Own& own);

struct FitState {
    Shared shared = to_shared({});
    std::vector<Own> runs;
};

// A run as the fit uses it.
struct ScaledRun {
    std::vector<double> time_s;
    std::vector<Eigen::Vector2cd> z;
    std::vector<double> weight;  // 1/sd
    std::vector<double> power_integral;
    double middle_s = 0;  // t_mid
    double step_s = 0;    // median distance of neighbours

    std::size_t size() const { return time_s.size(); }
};

// Precondition: at least two windows, all sd > 0.
ScaledRun scaled_run(const PhasorRun& run, double scale);

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Weighted residuals of a run, four for each window: Re, Im of c and of d, data less model. Where
// the pointers are not null, their derivatives, row by row: 4n x shared_count and 4n x own_count.
void residuals(const ScaledRun& run, const Shared& shared, const Own& own, double* residual,
               double* by_shared, double* by_own);

// J^T J and J^T r of all runs in the order shared, run 1, run 2, ..., and r^T r.
struct NormalEquations {
    Eigen::MatrixXd information;
    Eigen::VectorXd gradient;
    double chi2 = 0;
};
NormalEquations normal_equations(std::span<const ScaledRun> runs, const FitState& state);

double chi_square(std::span<const ScaledRun> runs, const FitState& state);

}  // namespace vybeg
