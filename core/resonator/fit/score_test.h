#pragma once

#include "core/resonator/fit/posterior.h"

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace vybeg {

// Rao's score test of effects that the model omits: fall of chi^2 and sizes of the effects if they
// were fitted together with the parameters. Exact for small effects.

// Derivatives of the weighted phasors by the sizes of an effect: a matrix for each run, rows as its
// residuals.
using Effect = std::vector<Eigen::MatrixXd>;

// Share of a column that the parameters do not absorb, below which the column is not distinct.
inline constexpr double own_share = 1e-6;

struct Score {
    double fall = 0;          // of chi^2
    Eigen::VectorXd size;     // size of each column
    Eigen::MatrixXd inverse;  // covariance of the sizes for the noise of the windows
};
Score score(const FitProblem& problem, const Posterior& posterior, const Effect& effect);

// Error of the active parameters by a unit of an effect that the fit does not know of, a column for
// each of the effect.
Eigen::MatrixXd followed(const FitProblem& problem, const Posterior& posterior,
                         const Effect& effect);

// A damping that follows the amplitude: log |z| falls by the integral of |z|^exponent. -1: dry
// friction, 1: the friction of air.
Effect damping_effect(const FitProblem& problem, const Posterior& posterior, int exponent = 2);

// Pick-offs whose gain follows the amplitude: of C by the power of C, of D by that of D.
Effect pickoff_effect(const FitProblem& problem, const Posterior& posterior);

// Phase and gain of C that drift, by their change over a run, as those of D among the parameters.
Effect drift_effect(const FitProblem& problem, const Posterior& posterior);

// Cubic springs unlike along the axes, of the potential c^4 - d^4 and of the same turned by 22.5
// degrees of theta: by Hz per |z|^2 between the axes.
Effect springs_effect(const FitProblem& problem, const Posterior& posterior);

// The eighth harmonic of d theta_A/dt, cosine and sine, rad/s.
Effect eighth_effect(const FitProblem& problem, const Posterior& posterior);

// Predicted phasors in a window of a run.
Eigen::Vector2cd expected_phasor(const ScaledRun& run, const Linearised& at, std::size_t window);

// Writes the change of a window's phasors into a column.
void put_effect(Eigen::MatrixXd& effect, const ScaledRun& run, std::size_t window,
                Eigen::Index column, const Eigen::Vector2cd& change);

// The effect of so many columns that put(index, run, window, matrix) writes by put_effect(), window
// after window of each run.
template <class Put>
Effect effect_by_window(const FitProblem& problem, Eigen::Index columns, const Put& put) {
    Effect effect;
    for (std::size_t k = 0; k < problem.runs.size(); ++k) {
        const ScaledRun& run = problem.runs[k];
        Eigen::MatrixXd by =
            Eigen::MatrixXd::Zero(4 * static_cast<Eigen::Index>(run.size()), columns);
        for (std::size_t window = 0; window < run.size(); ++window) {
            put(k, run, window, by);
        }
        effect.push_back(std::move(by));
    }
    return effect;
}

// A parameter, held or not, such as the cubic spring b.
Score parameter_score(const FitProblem& problem, const Posterior& posterior,
                      SharedParameter parameter);

// Frequencies that settle: one amplitude for each run, with the best common time constant.
struct SettlingScore {
    double fall = 0;
    double most_hz = 0;  // largest of the runs' amplitudes
    double time_s = 0;
};
SettlingScore settling_score(const FitProblem& problem, const Posterior& posterior);

}  // namespace vybeg
