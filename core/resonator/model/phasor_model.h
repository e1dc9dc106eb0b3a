#pragma once

#include "core/resonator/model/parameters.h"
#include "core/resonator/model/scaled_run.h"
#include "core/resonator/model/slow_dynamics.h"

#include <Eigen/Core>

#include <bitset>
#include <limits>
#include <span>
#include <vector>

namespace vybeg {

// The model of a run's window phasors, in scaled units:
//
//     dz/dt = M z + i (2 pi b/3) (2 |z|^2 z + (z.z) conj z),  z(0) = z0
//     phi = 2 pi (f u + drift u^2/2) + phases of breaks,      u = t - reference_s
//     C = e^{gain_C + i phi} z_1
//     D = e^{gain_D + i phi} (g z_2 + (sin skew + i crosstalk) z_1)/kappa,
//     g = (1 + gain_drift x) e^{i (phase + phase_drift x)},    x = t/duration
//
// The parameters of breaks before t add up: a phase, gain_C and gain_D, or the change of z0 after a
// knock. The motion after a knock is a free motion, too, so that it has a start at t = 0.
//
// M without imaginary trace (slow_dynamics.h). In u+- = z_1 +- i z_2 the cubic term is a phase
// rate, (2 pi b/3)(|u+|^2 + 2 |u-|^2 - 3 P) for u+ and likewise for u-; P, the run's power, makes f
// nearly independent of b. With b = 0 the motion is exp(M t) z0; otherwise it takes Strang steps
// from window to window, half of the cubic phase on each side of exp(M h). The mean over a window
// commutes with exp(M t): z0 is the start averaged over a window, and the linear model allows any
// window length. What a drift of the frequency changes in that mean is in the phasors, but not in
// the derivatives, which it changes by some thousandths at most.

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Predicted phasors in the first `windows` windows of a run. `own`: the run's own parameters,
// own_count and those of each break.
std::vector<Eigen::Vector2cd> expected_phasors(const ScaledRun& run, const Eigen::VectorXd& shared,
                                               const Eigen::VectorXd& own, std::size_t windows);

// Where the phase of a run is lost, the measured phasors are turned to the predicted ones, and what
// a common phase of C and D would change is projected out of residuals and derivatives.

// Some of the shared parameters.
using SharedColumns = std::bitset<shared_count>;
inline constexpr SharedColumns all_shared{(1ULL << shared_count) - 1};

// Weighted residuals (measured less predicted) of the first `windows` windows, Re c, Im c, Re d, Im
// d of each, and derivatives of the predicted ones with the same weights: a row for each residual,
// the shared parameters before the own ones. Of the shared parameters beside the rates, those of
// `wanted` have derivatives, the others zeros. `before`: of the same arguments at another point,
// for its memory.
struct Linearised {
    Eigen::VectorXd residual;
    RowMajor by_parameter;
};
Linearised linearised(const ScaledRun& run, const Eigen::VectorXd& shared,
                      const Eigen::VectorXd& own, std::size_t windows,
                      SharedColumns wanted = all_shared, Linearised before = {});

// The residuals alone, a twentieth of the work.
Eigen::VectorXd residual_of(const ScaledRun& run, const Eigen::VectorXd& shared,
                            const Eigen::VectorXd& own, std::size_t windows);

// The sum of their squares; of some of them only where these exceed `most`.
double chi_square(const ScaledRun& run, const Eigen::VectorXd& shared, const Eigen::VectorXd& own,
                  std::size_t windows, double most = std::numeric_limits<double>::infinity());

}  // namespace vybeg
