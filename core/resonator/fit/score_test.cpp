#include "core/resonator/fit/score_test.h"

#include "core/estimators/wave/wave_state.h"
#include "core/numerics/dense_solvers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2cd;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr Complex i{0, 1};

constexpr std::array settling_shares{0.03, 0.05, 0.07, 0.1,
                                     0.14, 0.2,  0.28, 0.4};  // in units of the longest run

// A frequency that begins with an offset of `a` Hz in each run and settles with a common time
// constant.
Effect settling_effect(const FitProblem& problem, const Posterior& at, double settling_s) {
    return effect_by_window(
        problem, static_cast<Index>(problem.runs.size()),
        [&](std::size_t k, const ScaledRun& run, std::size_t window, MatrixXd& by) {
            const double phase =
                -2 * pi * settling_s * std::expm1(-run.time_s[window] / settling_s);
            put_effect(by, run, window, static_cast<Index>(k),
                       phase * i * expected_phasor(run, at.runs[k], window));
        });
}

using Pair = std::array<Vector2cd, 2>;

// Phasors moved by two small terms of dz/dt: `terms_at` has both at a wave. From window to window a
// deviation moves as the wave itself, which also shows the phase that the run's frequency adds.
template <class Terms>
Effect driven_effect(const FitProblem& problem, const Posterior& at, const Terms& terms_at) {
    const SlowDynamics dynamics(at.p);
    Pair moved{Vector2cd::Zero(), Vector2cd::Zero()};
    Pair last = moved;
    Vector2cd before = Vector2cd::Zero();
    return effect_by_window(
        problem, 2, [&](std::size_t k, const ScaledRun& run, std::size_t window, MatrixXd& by) {
            const Vector2cd z = expected_phasor(run, at.runs[k], window);
            const Pair terms = terms_at(run, z);
            if (window > 0) {
                const double step_s = run.time_s[window] - run.time_s[window - 1];
                Eigen::Matrix2cd step = dynamics.propagator(step_s);
                step *= std::polar(1.0, std::arg((step * before).dot(z)));
                for (std::size_t term = 0; term < terms.size(); ++term) {
                    moved[term] =
                        step * (moved[term] + step_s / 2 * last[term]) + step_s / 2 * terms[term];
                }
            } else {
                for (std::size_t term = 0; term < terms.size(); ++term) {
                    moved[term] = run.time_s[0] * terms[term];
                }
            }
            for (std::size_t term = 0; term < terms.size(); ++term) {
                put_effect(by, run, window, static_cast<Index>(term), moved[term]);
            }
            last = terms;
            before = z;
        });
}

// Two changes of the phasors of the recorded channels, wherever the angles count from.
template <class Changes>
Effect electrode_effect(const FitProblem& problem, const Posterior& at, const Changes& changes) {
    return effect_by_window(
        problem, 2, [&](std::size_t k, const ScaledRun& run, std::size_t window, MatrixXd& by) {
            Vector2cd z = expected_phasor(run, at.runs[k], window);
            turn_channels(-run.two_theta_zero, z[0], z[1]);
            Pair both = changes(run, window, z);
            for (Index column = 0; Vector2cd & change : both) {
                turn_channels(run.two_theta_zero, change[0], change[1]);
                put_effect(by, run, window, column++, change);
            }
        });
}

// Derivatives of the phasors, weighted, by the parameters along an effect's columns.
MatrixXd along_parameters(const FitProblem& problem, const Posterior& at, const Effect& effect) {
    MatrixXd along = MatrixXd::Zero(at.information.rows(), effect.front().cols());
    for (std::size_t k = 0; k < effect.size(); ++k) {
        const MatrixXd cross = at.runs[k].by_parameter.transpose() * effect[k];
        add_rows(problem.layout, k, cross, along);
    }
    return along;
}

}  // namespace

MatrixXd followed(const FitProblem& problem, const Posterior& at, const Effect& effect) {
    const MatrixXd along = along_parameters(problem, at, effect);
    return at.root * (at.root.transpose() * along(at.active, Eigen::all));
}

Effect damping_effect(const FitProblem& problem, const Posterior& at, int exponent) {
    constexpr double seen = 3;  // least size of a wave, deviations
    double integral = 0;
    double last_s = 0;
    return effect_by_window(
        problem, 1, [&](std::size_t k, const ScaledRun& run, std::size_t window, MatrixXd& by) {
            if (window == 0) {
                integral = last_s = 0;
            }
            const auto rate = [&](const Vector2cd& z) {
                const double least = seen / run.weight[window];
                const double power = std::max(z.squaredNorm(), least * least) / run.power_kept;
                return std::pow(power, 0.5 * exponent);
            };
            const Vector2cd z = expected_phasor(run, at.runs[k], window);
            const double before = rate(window > 0 ? run.z[window - 1] : z);
            integral += (run.time_s[window] - last_s) * (before + rate(z)) / 2;
            last_s = run.time_s[window];
            put_effect(by, run, window, 0, -integral * z);
        });
}

Effect pickoff_effect(const FitProblem& problem, const Posterior& at) {
    return electrode_effect(problem, at, [](const ScaledRun& run, std::size_t, const Vector2cd& z) {
        return Pair{Vector2cd(std::norm(z[0]) / run.power_kept * z[0], 0),
                    Vector2cd(0, std::norm(z[1]) / run.power_kept * z[1])};
    });
}

Effect drift_effect(const FitProblem& problem, const Posterior& at) {
    return electrode_effect(problem, at,
                            [](const ScaledRun& run, std::size_t window, const Vector2cd& z) {
                                const Complex drifted = run.time_s[window] / run.duration_s * z[0];
                                return Pair{Vector2cd(i * drifted, 0), Vector2cd(drifted, 0)};
                            });
}

Effect springs_effect(const FitProblem& problem, const Posterior& at) {
    return driven_effect(problem, at, [](const ScaledRun& run, const Vector2cd& z) {
        const Complex c = z[0];
        const Complex d = z[1];
        const double cc = std::norm(c);
        const double dd = std::norm(d);
        const Complex by = i * pi / run.power_kept;
        return Pair{by * Vector2cd(cc * c, -dd * d),
                    by * Vector2cd((cc + dd / 2) * d + c * c * std::conj(d) / 2.0,
                                   (dd + cc / 2) * c + d * d * std::conj(c) / 2.0)};
    });
}

Effect eighth_effect(const FitProblem& problem, const Posterior& at) {
    return driven_effect(problem, at, [](const ScaledRun&, const Vector2cd& z) {
        const double eight_theta = 4 * to_wave_state({z[0], z[1]}).two_theta_A;
        // An angle turns by a rate w as dz/dt = 2 w (-d, c).
        const Vector2cd turned(-2.0 * z[1], 2.0 * z[0]);
        return Pair{std::cos(eight_theta) * turned, std::sin(eight_theta) * turned};
    });
}

Score score(const FitProblem& problem, const Posterior& at, const Effect& effect) {
    const Index count = effect.front().cols();
    MatrixXd square = MatrixXd::Zero(count, count);
    VectorXd with_residual = VectorXd::Zero(count);
    for (std::size_t k = 0; k < effect.size(); ++k) {
        square += effect[k].transpose() * effect[k];
        with_residual += effect[k].transpose() * at.runs[k].residual;
    }
    const MatrixXd along = along_parameters(problem, at, effect);
    const MatrixXd seen = at.root.transpose() * along(at.active, Eigen::all);
    const VectorXd whole = square.diagonal();
    square -= seen.transpose() * seen;
    with_residual -= seen.transpose() * at.toward;
    for (Index k = 0; k < count; ++k) {
        if (square(k, k) <= own_share * whole[k]) {
            square.row(k).setZero();
            square.col(k).setZero();
            square(k, k) = 1;
            with_residual[k] = 0;
        }
    }
    Score out;
    out.inverse = square.ldlt().solve(MatrixXd::Identity(count, count));
    out.size = out.inverse * with_residual;
    out.fall = with_residual.dot(out.size);
    return out;
}

Vector2cd expected_phasor(const ScaledRun& run, const Linearised& at, std::size_t window) {
    const auto left = at.residual.segment<4>(4 * static_cast<Index>(window));
    return run.z[window] - run.unweighted(window, of_real_parts(left));
}

void put_effect(MatrixXd& effect, const ScaledRun& run, std::size_t window, Index column,
                const Vector2cd& change) {
    effect.block<4, 1>(4 * static_cast<Index>(window), column) =
        real_parts(run.weighted(window, change));
}

Score parameter_score(const FitProblem& problem, const Posterior& posterior,
                      SharedParameter parameter) {
    Effect effect;
    for (const Linearised& run : posterior.runs) {
        effect.emplace_back(run.by_parameter.col(parameter));
    }
    return score(problem, posterior, effect);
}

SettlingScore settling_score(const FitProblem& problem, const Posterior& posterior) {
    SettlingScore best;
    const auto consider = [&](double settling_s) {
        const Score found =
            score(problem, posterior, settling_effect(problem, posterior, settling_s));
        if (found.fall > best.fall) {
            best = {found.fall, found.size.cwiseAbs().maxCoeff(), settling_s};
        }
    };
    for (const double share : settling_shares) {
        consider(share * longest_s(problem));
    }
    for (const double closer : {1.2, 1.1, 1.05, 1.025, 1.0125}) {
        const double middle_s = best.time_s;
        consider(middle_s * closer);
        consider(middle_s / closer);
    }
    return best;
}

}  // namespace vybeg
