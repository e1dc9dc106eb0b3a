#include "core/resonator/results/power_fit.h"

#include "core/numerics/dense_solvers.h"
#include "core/resonator/fit/fit_start.h"
#include "core/resonator/results/describe_fit.h"
#include "core/resonator/results/reported_estimates.h"
#include "core/resonator/results/resonator_parameters.h"
#include "core/resonator/results/set_examination.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

namespace vybeg {
namespace {

using Eigen::Index;
using Eigen::Vector2cd;

// Rows of a run: a fit goes through all of them.
constexpr std::size_t most_power_rows = 1000;
constexpr std::size_t least_power_rows = 8;
constexpr int power_steps = 200;
constexpr Index rates = 6;

// Rows of the linear equations of one run, less their means: four for each instant.
void add_linear(const PowerRun& run, Eigen::MatrixXd& information, Eigen::VectorXd& moment) {
    std::vector<Eigen::Matrix<double, 4, rates + 1>> rows;
    Eigen::Matrix<double, 4, rates> sum = Eigen::Matrix<double, 4, rates>::Zero();
    Eigen::Matrix<double, 4, rates> before = Eigen::Matrix<double, 4, rates>::Zero();
    double time_s = 0;
    Eigen::Matrix<double, 4, rates + 1> mean = Eigen::Matrix<double, 4, rates + 1>::Zero();
    double scale = 0;
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        const double e = run.e[k];
        const double r = run.r[k];
        const double s = run.s[k];
        const double q = run.q[k];
        if (!std::isfinite(e + r + s + q)) {
            continue;
        }
        Eigen::Matrix<double, 4, rates> by;
        by << -e, -r, -s, 0, 0, 0,  //
            -r, -e, 0, q, 0, s,     //
            -s, 0, -e, 0, -q, -r,   //
            -q, 0, 0, -r, s, 0;
        if (!rows.empty()) {
            sum += 0.5 * (run.time_s[k] - time_s) * (before + by);
        }
        before = by;
        time_s = run.time_s[k];
        scale = std::max(scale, e);
        Eigen::Matrix<double, 4, rates + 1> row;
        row << sum, Eigen::Vector4d(e, r, s, q);
        mean += row;
        rows.push_back(row);
    }
    if (rows.empty() || !(scale > 0)) {
        return;
    }
    mean /= static_cast<double>(rows.size());
    for (Eigen::Matrix<double, 4, rates + 1>& row : rows) {
        row = (row - mean) / scale;
        information += row.leftCols<rates>().transpose() * row.leftCols<rates>();
        moment += row.leftCols<rates>().transpose() * row.col(rates);
    }
}

// The phasors turned to those of the motion.
void turn_to(const Eigen::VectorXd& p, FitProblem& problem) {
    for (std::size_t k = 0; k < problem.runs.size(); ++k) {
        const std::vector<Vector2cd> expected = expected_phasors(problem, p, k);
        for (std::size_t row = 0; row < expected.size(); ++row) {
            Vector2cd& z = problem.runs[k].z[row];
            const std::complex<double> along = expected[row].dot(z);
            z *= std::polar(1.0, -std::arg(along));
        }
    }
}

// Noise of the rows about the motion, by third differences of the residual: as large in the
// phasors at any amplitude, or in the powers, whichever is likelier.
void take_noise(const FitProblem& problem, const Eigen::VectorXd& p, std::vector<PhasorRun>& runs,
                double scale) {
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const ScaledRun& run = problem.runs[k];
        const std::vector<Vector2cd> expected = expected_phasors(problem, p, k);
        std::array<double, 2> square{};  // over those of the law
        std::array<double, 2> log_sd{};
        for (std::size_t row = 3; row < run.size(); ++row) {
            // In the frame of the wave, which turns.
            const auto left = [&](std::size_t at) {
                const Vector2cd unit = expected[at].normalized();
                const Vector2cd off = run.z[at] - expected[at];
                const std::complex<double> across = unit[0] * off[1] - unit[1] * off[0];
                return Eigen::Vector3d(unit.dot(off).real(), across.real(), across.imag());
            };
            const Eigen::Vector3d third =
                left(row) - 3 * left(row - 1) + 3 * left(row - 2) - left(row - 3);
            const double size = expected[row].norm();
            for (std::size_t law = 0; law < 2; ++law) {
                const double of_law = law == 0 ? 1 : 1 / size;
                square[law] += third.squaredNorm() / (of_law * of_law);
                log_sd[law] += 3 * std::log(of_law);
            }
        }
        const double count = 3 * (static_cast<double>(run.size()) - 3);
        const auto cost = [&](std::size_t law) {
            return 0.5 * count * std::log(square[law] / count) + log_sd[law];
        };
        const std::size_t law = cost(0) <= cost(1) ? 0 : 1;
        const double sd = std::sqrt(square[law] / count / 20);
        for (std::size_t row = 0; row < run.size(); ++row) {
            constexpr double least = 1e-15;
            const double size = expected[row].norm();
            runs[k].sd[row] =
                scale * std::max(law == 0 ? sd : sd / size, least * run.z[row].norm());
            runs[k].c[row] = scale * run.z[row][0];
            runs[k].d[row] = scale * run.z[row][1];
        }
    }
}

FitProblem power_problem(std::span<const PhasorRun> runs, double scale, const FitOptions& options) {
    FitProblem problem = problem_of(scaled_runs(runs, scale));
    problem.priors = structured_priors(problem.runs, problem.layout, options.tolerance);
    for (std::size_t k = 0; k < runs.size(); ++k) {
        for (const int own : {frequency_at, drift_at}) {
            problem.priors.sd[problem.layout.at(k, own)] = 0;
        }
        // One phase of the start is free: the larger phasor is real.
        constexpr double held = 1e-7;
        const Vector2cd& z = problem.runs[k].z[0];
        const bool c_larger = z[0].real() >= z[1].real();
        problem.priors.sd[problem.layout.at(k, start_at + (c_larger ? 1 : 3))] = held;
    }
    return problem;
}

// The parameters by linear_powers().
Eigen::VectorXd linear_start(const FitProblem& problem, const Eigen::VectorXd& linear) {
    Eigen::VectorXd p = problem.priors.mean;
    constexpr double turn = 2 * std::numbers::pi;
    p[decay_at] = linear[0] / 2;
    p[damping_cos_at] = linear[1];
    p[damping_sin_at] = linear[2];
    p[split_sin_at] = linear[3] / turn;
    p[split_cos_at] = linear[4] / turn;
    p[rotation_at] = linear[5] / 2;
    for (std::size_t k = 0; k < problem.runs.size(); ++k) {
        p.segment<4>(problem.layout.at(k, start_at)) = real_parts(problem.runs[k].z[0]);
    }
    return p;
}

void refuse_frequencies(ResonatorFit& fit) {
    const Estimate none{.reason = {ReasonCode::phase_lost, {}}};
    constexpr std::array of_phase{&ResonatorEstimate::f_mean_hz, &ResonatorEstimate::q,
                                  &ResonatorEstimate::delay_s,
                                  &ResonatorEstimate::frequency_per_power};
    for (std::size_t k = 0; k < resonator_parameters.size(); ++k) {
        const auto member = resonator_parameters[k].member;
        if (std::ranges::find(of_phase, member) != of_phase.end()) {
            fit.resonator.*member = none;
            fit.sensitivities[k] = fit.shares[k] = {};
        }
    }
    for (ModeEstimate& mode : fit.modes) {
        mode.f_hz = mode.q = none;
    }
    for (RunEstimate& run : fit.runs) {
        run.f_offset_hz = run.direction_f_hz = run.q_envelope = run.drift_hz_per_s = none;
    }
}

}  // namespace

Eigen::VectorXd linear_powers(std::span<const PowerRun> runs) {
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(rates, rates);
    Eigen::VectorXd moment = Eigen::VectorXd::Zero(rates);
    for (const PowerRun& run : runs) {
        add_linear(run, information, moment);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(information);
    // Directions that the motion does not show stay at zero.
    constexpr double unseen = 1e-10;
    const double least = unseen * eigen.eigenvalues()[rates - 1];
    Eigen::VectorXd along = eigen.eigenvectors().transpose() * moment;
    for (Index k = 0; k < rates; ++k) {
        along[k] = eigen.eigenvalues()[k] > least ? along[k] / eigen.eigenvalues()[k] : 0;
    }
    return eigen.eigenvectors() * along;
}

Result<PowerFit> fit_powers(std::span<const PowerRun> powers, const FitOptions& options,
                            const JobControl& job) {
    PowerFit found;
    double scale = 0;
    for (const PowerRun& run : powers) {
        found.runs.push_back(phasors_without_phase(run, most_power_rows));
        const std::size_t rows = found.runs.back().time_s.size();
        if (rows < least_power_rows) {
            return Error{ErrorCode::fit_too_few_windows,
                         "recording " + std::to_string(found.runs.size()),
                         {count_arg(static_cast<std::int64_t>(rows)),
                          count_arg(static_cast<std::int64_t>(least_power_rows)),
                          recording_arg(found.runs.size() - 1)}};
        }
        for (std::size_t k = 0; k < rows; ++k) {
            scale = std::max(scale, std::hypot(std::abs(found.runs.back().c[k]),
                                               std::abs(found.runs.back().d[k])));
        }
    }
    // The noise of the rows follows from what a first fit leaves.
    FitProblem problem = power_problem(found.runs, scale, options);
    Eigen::VectorXd p = linear_start(problem, linear_powers(powers));
    set_damping(problem.priors, std::max(p[decay_at], 1e-12));
    p = minimise(problem, p, power_steps, job).p;
    turn_to(p, problem);
    take_noise(problem, p, found.runs, scale);
    problem = power_problem(found.runs, scale, options);
    set_damping(problem.priors, std::max(p[decay_at], 1e-12));
    for (std::size_t k = 0; k < found.runs.size(); ++k) {
        for (const int own : {start_at + 1, start_at + 3}) {
            const Index at = problem.layout.at(k, own);
            if (problem.priors.sd[at] < 1) {
                problem.priors.mean[at] = p[at];
            }
        }
    }
    MapFit fit = minimise(problem, p, power_steps, job);
    if (!std::isfinite(fit.cost)) {
        return Error{ErrorCode::fit_failed, "the recordings", {Phrase::tr("there is no wave")}};
    }
    SetExamination examination = examine_set(problem, fit, options.spread, job);
    if (examination.verdict == SetVerdict::spread) {
        for (std::size_t k = 0; k < problem.runs.size(); ++k) {
            problem.runs[k].deviation = examination.spread.deviation[k];
        }
        fit = minimise(problem, examination.spread.p, power_steps, job);
    }
    turn_to(fit.p, problem);
    TRY(job.go_on());
    found.fit = describe({found.runs,
                          found.runs,
                          &problem,
                          fit,
                          ResonatorModel::structured,
                          scale,
                          {},
                          false,
                          examination.spread.sd,
                          with_assumed(options).tolerance},
                         job);
    conclude(examination, !options.spread, found.fit);
    refuse_frequencies(found.fit);
    return found;
}

}  // namespace vybeg
