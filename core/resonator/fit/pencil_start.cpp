#include "core/resonator/fit/pencil_start.h"

#include "core/numerics/phase.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace vybeg {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::Matrix2cd;
using Eigen::Vector2cd;
using std::numbers::pi;

// Phasors in one stacked vector, enough to average the noise.
constexpr std::size_t stack = 8;
using Stacked = Eigen::Matrix<Complex, 2 * stack, 1>;

// Index of the window at each step from the start; -1 in a gap.
std::vector<std::ptrdiff_t> windows_by_step(const ScaledRun& run) {
    std::vector<std::ptrdiff_t> window;
    for (std::size_t k = 0; k < run.size(); ++k) {
        const auto step = static_cast<std::size_t>(
            std::lround((run.time_s[k] - run.time_s.front()) / run.step_s));
        window.resize(std::max(window.size(), step + 1), -1);
        window[step] = static_cast<std::ptrdiff_t>(k);
    }
    return window;
}

// z(t) = v1 e^{l1 t} + v2 e^{l2 t} in least squares; the columns are v1 and v2.
Matrix shapes(const ScaledRun& run, const std::vector<Vector2cd>& z, const Vector2cd& rates) {
    Matrix normal = Matrix::Zero();
    Matrix right = Matrix::Zero();
    for (std::size_t k = 0; k < run.size(); ++k) {
        const Vector2cd mode = (rates * run.time_s[k]).array().exp();
        normal += mode.conjugate() * mode.transpose();
        right += mode.conjugate() * z[k].transpose();
    }
    return (normal.inverse() * right).transpose();
}

// Calls use(k, l) for windows whose distance in time is `lag` steps, gaps or not.
template <class Use>
void for_pairs(const ScaledRun& run, std::size_t lag, const Use& use) {
    const double wanted = static_cast<double>(lag) * run.step_s;
    for (std::size_t k = 0, l = 0; k < run.size(); ++k) {
        while (l < run.size() && run.time_s[l] - run.time_s[k] < wanted - run.step_s / 4) {
            ++l;
        }
        if (l < run.size() && run.time_s[l] - run.time_s[k] < wanted + run.step_s / 4) {
            use(k, l);
        }
    }
}

// Steps between the ends of a run.
std::size_t steps_of(const ScaledRun& run) {
    return static_cast<std::size_t>(
        std::lround((run.time_s.back() - run.time_s.front()) / run.step_s));
}

// Mean frequency of vectors w_k, Hz: from the rotation over one step, then over increasing lags,
// each of which resolves the whole turns of the next.
double mean_frequency(const ScaledRun& run, const std::vector<Vector2cd>& w) {
    double f = 0;
    for (std::size_t lag = 1; lag <= std::max<std::size_t>(1, steps_of(run) / 2); lag *= 2) {
        Complex sum = 0;
        for_pairs(run, lag, [&](std::size_t k, std::size_t l) { sum += w[k].dot(w[l]); });
        if (sum != Complex{}) {
            const double seconds = static_cast<double>(lag) * run.step_s;
            f += wrap(std::arg(sum) - 2 * pi * f * seconds) / (2 * pi * seconds);
        }
    }
    return f;
}

// z without the run's own frequency.
std::vector<Vector2cd> aligned(const ScaledRun& run, double f) {
    std::vector<Vector2cd> z(run.size());
    for (std::size_t k = 0; k < run.size(); ++k) {
        z[k] = std::polar(1.0, -2 * pi * f * run.time_s[k]) * run.z[k];
    }
    return z;
}

// Sums of z(t + lag) z(t)^H and z(t) z(t)^H.
struct PencilSums {
    Matrix late = Matrix::Zero();
    Matrix early = Matrix::Zero();
    double noise = 0;  // contribution of noise to each diagonal entry of `early`
};

void add(PencilSums& pencil, const ScaledRun& run, const std::vector<Vector2cd>& z,
         std::size_t lag) {
    for_pairs(run, lag, [&](std::size_t k, std::size_t l) {
        pencil.late += z[l] * z[k].adjoint();
        pencil.early += z[k] * z[k].adjoint();
        pencil.noise += 2 / (run.weight[k] * run.weight[k]);
    });
}

// log(E)/lag; empty if the phasors show one direction only, or a mode grows or turns too far.
std::optional<SlowRates> rates_of(const PencilSums& pencil, double seconds) {
    const double least_power = eigenvalues_of(pencil.early)[1].real();
    if (!(least_power > 4 * pencil.noise)) {
        return std::nullopt;
    }
    const Matrix step = pencil.late * pencil.early.inverse();
    if (eigenvalues_of(step).cwiseAbs().minCoeff() < 1e-6) {
        return std::nullopt;
    }
    return vybeg::rates_of(Matrix(logarithm(step) / seconds));
}

}  // namespace

Eigen::VectorXd parameters_under(const FitProblem& problem, const SlowRates& rates) {
    Eigen::VectorXd p = problem.priors.mean;
    for (int k = 0; k < rate_count; ++k) {
        if (problem.priors.sd[k] > 0) {
            p[k] = rates[k];
        }
    }
    SlowRates no_decay = rates;
    no_decay[decay_at] = 0;
    const SlowDynamics turning(no_decay);
    const SlowDynamics motion(rates);
    for (std::size_t index = 0; index < problem.runs.size(); ++index) {
        const ScaledRun& run = problem.runs[index];
        std::vector<Vector2cd> back(run.size());
        const Matrix back_step = turning.propagator(-run.step_s);
        Matrix by = Matrix::Identity();
        Walk walk;
        for (std::size_t k = 0; k < run.size(); ++k) {
            const double t = run.time_s[k];
            by = walk.step_to(t, run.step_s) ? Matrix(back_step * by) : turning.propagator(-t);
            back[k] = by * run.z[k];
        }
        const double f = mean_frequency(run, back);
        Matrix normal = Matrix::Zero();
        Vector2cd right = Vector2cd::Zero();
        const Matrix step =
            std::polar(1.0, 2 * pi * f * run.step_s) * motion.propagator(run.step_s);
        walk = {};
        for (std::size_t k = 0; k < run.size(); ++k) {
            const double t = run.time_s[k];
            by = walk.step_to(t, run.step_s)
                     ? Matrix(step * by)
                     : std::polar(1.0, 2 * pi * f * (t - run.reference_s)) * motion.propagator(t);
            const Matrix basis = run.weight[k] * by;
            normal += basis.adjoint() * basis;
            right += basis.adjoint() * (run.weight[k] * run.z[k]);
        }
        const Vector2cd start = normal.inverse() * right;
        p.segment<5>(problem.layout.at(index, 0)) << real_parts(start), f;
    }
    return p;
}

std::optional<SlowRates> delayed_pencil(const ScaledRun& run, const std::vector<Vector2cd>& z,
                                        std::size_t delay) {
    const std::vector<std::ptrdiff_t> window = windows_by_step(run);
    const std::size_t reach = (stack - 1) * delay + 1;
    std::vector<Stacked> vectors;
    std::vector<std::size_t> steps;
    for (std::size_t step = 0; step + reach <= window.size(); ++step) {
        Stacked vector;
        bool whole = true;
        for (std::size_t k = 0; k < stack && whole; ++k) {
            const std::ptrdiff_t at = window[step + k * delay];
            whole = at >= 0;
            if (whole) {
                vector.segment<2>(static_cast<Eigen::Index>(2 * k)) =
                    z[static_cast<std::size_t>(at)];
            }
        }
        if (whole) {
            vectors.push_back(vector);
            steps.push_back(step);
        }
    }
    if (vectors.size() < 2 * stack) {
        return std::nullopt;
    }
    Eigen::Matrix<Complex, 2 * stack, 2 * stack> power;
    power.setZero();
    for (const Stacked& vector : vectors) {
        power += vector * vector.adjoint();
    }
    const Eigen::SelfAdjointEigenSolver<decltype(power)> principal(power);
    const Eigen::Matrix<Complex, 2, 2 * stack> plane =
        principal.eigenvectors().rightCols<2>().adjoint();
    Matrix late = Matrix::Zero();
    Matrix early = Matrix::Zero();
    for (std::size_t k = 0; k + 1 < vectors.size(); ++k) {
        if (steps[k + 1] == steps[k] + 1) {
            const Vector2cd now = plane * vectors[k];
            late += plane * vectors[k + 1] * now.adjoint();
            early += now * now.adjoint();
        }
    }
    const Vector2cd rates = eigenvalues_of(late * early.inverse()).array().log() / run.step_s;
    if (!rates.allFinite()) {
        return std::nullopt;
    }
    return rates_of_modes(rates, shapes(run, z, rates));
}

std::optional<Eigen::VectorXd> pencil_start(const FitProblem& problem, Pencil kind,
                                            const JobControl& job) {
    const std::span<const ScaledRun> runs = problem.runs;
    std::optional<Eigen::VectorXd> best;
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](const std::optional<SlowRates>& rates) {
        if (!rates) {
            return;
        }
        Eigen::VectorXd p = parameters_under(problem, *rates);
        const double chi2 = chi_square(problem, p);
        if (chi2 < least) {
            least = chi2;
            best = std::move(p);
        }
    };
    std::vector<std::vector<Vector2cd>> z;
    std::size_t longest = 0;
    for (const ScaledRun& run : runs) {
        z.push_back(aligned(run, mean_frequency(run, run.z)));
        longest = std::max(longest, steps_of(run));
    }
    for (std::size_t lag = 1; lag <= std::max<std::size_t>(1, longest / 3); lag *= 4) {
        PencilSums all;
        for (std::size_t k = 0; k < runs.size() && !job.cancelled(); ++k) {
            if (kind == Pencil::delayed) {
                consider(delayed_pencil(runs[k], z[k], lag));
                continue;
            }
            PencilSums one;
            add(one, runs[k], z[k], lag);
            consider(rates_of(one, static_cast<double>(lag) * runs[k].step_s));
            if (std::abs(runs[k].step_s / runs[0].step_s - 1) < 1e-3) {
                all.late += one.late;
                all.early += one.early;
                all.noise += one.noise;
            }
        }
        if (runs.size() > 1 && kind == Pencil::two_channels) {
            consider(rates_of(all, static_cast<double>(lag) * runs[0].step_s));
        }
    }
    return best;
}

}  // namespace vybeg
