#include "core/resonator/fit/map_fit.h"

#include "core/numerics/dense_solvers.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace vybeg {
namespace {

constexpr double no_cost = std::numeric_limits<double>::infinity();
constexpr double first_damping = 1e-8;
constexpr double least_damping = 1e-12;
constexpr double most_damping = 1e6;
constexpr double least_gain = 1e-5;
// A fit of several runs that needs more steps follows a bent valley. That of one run leads to rates
// which only its phase asks for, as where the frequency settles.
constexpr int straight_steps = 12;
constexpr double probe = 0.1;  // share of a step at which its curvature is taken
// Windows of a run on which a fit begins, where there are twice as many or more: its steps cost as
// many times less, and lead to the same minimum but for the noise.
constexpr std::size_t first_of_many = 500;
constexpr int last_steps = 12;

struct Cost {
    double data = 0;
    double all = 0;
};

double prior_cost(const FitProblem& problem, const Eigen::VectorXd& p) {
    double sum = 0;
    for (Eigen::Index k = 0; k < p.size(); ++k) {
        if (problem.priors.sd[k] > 0) {
            const double off = (p[k] - problem.priors.mean[k]) / problem.priors.sd[k];
            sum += off * off;
        }
    }
    for (const HeldDirection& held : problem.held) {
        const double off = (held.direction.dot(p) - held.value) / held.sd;
        sum += off * off;
    }
    return sum;
}

// Where it exceeds `most`, of some of the windows.
Cost cost_of(const FitProblem& problem, const Eigen::VectorXd& p, std::size_t windows,
             double most = no_cost) {
    const double of_priors = prior_cost(problem, p);
    const double data = chi_square(problem, p, windows, most - of_priors);
    Cost cost{data, data + of_priors};
    // A motion that overflows is no candidate.
    if (!std::isfinite(cost.all)) {
        cost.all = no_cost;
    }
    return cost;
}

// Of the active parameters, with priors and held directions. `runs`: linearised at p.
NormalEquations normal_of(const FitProblem& problem, const std::vector<Eigen::Index>& active,
                          std::span<const Linearised> runs, const Eigen::VectorXd& p) {
    NormalEquations normal = normal_equations(problem, runs, active);
    for (std::size_t place = 0; place < active.size(); ++place) {
        const Eigen::Index k = active[place];
        const auto at = static_cast<Eigen::Index>(place);
        const double weight = 1 / (problem.priors.sd[k] * problem.priors.sd[k]);
        normal.matrix(at, at) += weight;
        if (weight > 0) {
            normal.right[at] += weight * (problem.priors.mean[k] - p[k]);
        }
    }
    for (const HeldDirection& held : problem.held) {
        const Eigen::VectorXd row = held.direction / held.sd;
        const double off = held.value / held.sd - row.dot(p);
        const Eigen::VectorXd of_active = row(active);
        normal.matrix += of_active * of_active.transpose();
        normal.right += of_active * off;
    }
    return normal;
}

// J^T of the second derivative of the predictions along a step. `runs`: linearised where it begins.
Eigen::VectorXd curvature_along(const FitProblem& problem, const std::vector<Eigen::Index>& active,
                                std::span<const Linearised> runs, const Eigen::VectorXd& p,
                                const Eigen::VectorXd& step) {
    const ParameterLayout& layout = problem.layout;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(p.size());
    const Eigen::VectorXd there = p + probe * step;
    for (std::size_t k = 0; k < problem.runs.size(); ++k) {
        const Linearised& at = runs[k];
        Eigen::VectorXd own_step(shared_count + layout.own_size(k));
        own_step << step.head(shared_count), own_of(layout, step, k);
        const auto windows = static_cast<std::size_t>(at.residual.size() / 4);
        const Eigen::VectorXd moved = residual_of(problem.runs[k], there.head(shared_count),
                                                  own_of(layout, there, k), windows);
        const Eigen::VectorXd second =
            (at.residual - moved - probe * (at.by_parameter * own_step)) * (2 / (probe * probe));
        const Eigen::VectorXd toward = at.by_parameter.transpose() * second;
        add_rows(layout, k, toward, sum);
    }
    return sum(active);
}

// Factor of the variances of the parameters by what a fit of all windows leaves: where that is no
// noise they are that much wider, and a fit that is as far from its minimum is at it.
double misfit(const FitProblem& problem, const Cost& cost, std::size_t windows) {
    constexpr double least = 4;
    double count = 0;
    for (const ScaledRun& run : problem.runs) {
        if (run.size() > windows) {
            return 1;
        }
        count += 4 * static_cast<double>(run.size());
    }
    return cost.data > least * count ? cost.data / count : 1;
}

MapFit descend(const FitProblem& problem, const Eigen::VectorXd& start, int steps,
               const JobControl& job, std::size_t windows) {
    const std::vector<Eigen::Index> active = problem.priors.active();
    SharedColumns wanted;
    for (const Eigen::Index k : active) {
        if (k < shared_count) {
            wanted.set(static_cast<std::size_t>(k));
        }
    }
    MapFit fit{start};
    Cost now = cost_of(problem, fit.p, windows);
    constexpr double rounding = 1e-9;  // of the cost
    // A cost above the present one only says that the step is none.
    const auto cost_at = [&](const Eigen::VectorXd& p) {
        return p.allFinite() ? cost_of(problem, p, windows, now.all * (1 + rounding))
                             : Cost{no_cost, no_cost};
    };
    double damping = first_damping;
    std::vector<Linearised> runs;
    for (int step = 0; step < steps && !fit.converged && !job.cancelled(); ++step) {
        runs = linearised(problem, fit.p, wanted, windows, std::move(runs));
        const NormalEquations normal = normal_of(problem, active, runs, fit.p);
        // Unit diagonal, because the units of the parameters differ by many powers of ten.
        const Eigen::VectorXd unit =
            normal.matrix.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt();
        const Eigen::VectorXd inverse = unit.cwiseInverse();
        const Eigen::MatrixXd scaled = inverse.asDiagonal() * normal.matrix * inverse.asDiagonal();
        const Eigen::VectorXd right = inverse.asDiagonal() * normal.right;
        double gain = 0;
        while (damping <= most_damping && !job.cancelled()) {
            Eigen::MatrixXd damped = scaled;
            damped.diagonal().array() += damping;
            const Eigen::LDLT<Eigen::MatrixXd> solver = damped.ldlt();
            Eigen::VectorXd move = Eigen::VectorXd::Zero(fit.p.size());
            move(active) = inverse.asDiagonal() * solver.solve(right);
            Eigen::VectorXd moved = fit.p + move;
            Cost then = cost_at(moved);
            if (step >= straight_steps && problem.runs.size() > 1 && std::isfinite(then.all)) {
                const Eigen::VectorXd bend =
                    -0.5 * solver.solve(inverse.asDiagonal() *
                                        curvature_along(problem, active, runs, fit.p, move));
                if (bend.norm() < (unit.asDiagonal() * move(active)).norm()) {
                    Eigen::VectorXd bent = moved;
                    bent(active) += inverse.asDiagonal() * bend;
                    if (const Cost there = cost_at(bent); there.all < then.all) {
                        moved = bent;
                        then = there;
                    }
                }
            }
            if (then.all <= now.all * (1 + rounding)) {
                gain = now.all - then.all;
                if (gain >= 0) {
                    fit.p = moved;
                    now = then;
                }
                break;
            }
            damping = std::max(10 * damping, 1e-7);
        }
        fit.last_gain = gain;
        fit.converged = std::abs(gain) <
                        least_gain * std::max(1 + 1e-6 * now.all, misfit(problem, now, windows));
        damping = std::max(damping / 30, least_damping);
    }
    fit.cost = now.all;
    fit.chi2 = now.data;
    return fit;
}

// Of the first `windows` windows of a run one block in `every`, and the last one, for the breaks:
// neighbours, between which no phase is ambiguous. Their weights make up for those that are left
// out.
ScaledRun thinned(const ScaledRun& run, std::size_t every, std::size_t windows) {
    constexpr std::size_t block = 4;
    ScaledRun thin = run;
    thin.time_s.clear();
    thin.z.clear();
    thin.weight.clear();
    const std::size_t end = std::min(run.size(), windows);
    for (std::size_t k = 0; k < end; ++k) {
        if (k / block % every == 0 || k + 1 == end) {
            thin.time_s.push_back(run.time_s[k]);
            thin.z.push_back(run.z[k]);
            thin.weight.push_back(run.weight[k]);
        }
    }
    const double share = static_cast<double>(thin.size()) / static_cast<double>(end);
    for (double& weight : thin.weight) {
        weight /= std::sqrt(share);
    }
    return thin;
}

}  // namespace

FitProblem problem_of(std::vector<ScaledRun> runs) {
    std::vector<std::size_t> breaks;
    std::ranges::transform(runs, std::back_inserter(breaks), &ScaledRun::break_parameters);
    return {std::move(runs), ParameterLayout(breaks), {}};
}

Eigen::VectorXd part_of(const ParameterLayout& layout, const Eigen::VectorXd& p,
                        std::span<const std::size_t> which) {
    Eigen::Index size = shared_count;
    for (const std::size_t k : which) {
        size += layout.own_size(k);
    }
    Eigen::VectorXd part(size);
    part.head(shared_count) = p.head(shared_count);
    Eigen::Index next = shared_count;
    for (const std::size_t k : which) {
        part.segment(next, layout.own_size(k)) = own_of(layout, p, k);
        next += layout.own_size(k);
    }
    return part;
}

FitProblem part_of(const FitProblem& problem, std::span<const std::size_t> which) {
    std::vector<ScaledRun> runs;
    for (const std::size_t k : which) {
        runs.push_back(problem.runs[k]);
    }
    FitProblem part = problem_of(std::move(runs));
    part.priors = {part_of(problem.layout, problem.priors.mean, which),
                   part_of(problem.layout, problem.priors.sd, which)};
    part.noise_ratio = problem.noise_ratio;
    part.damping_share = problem.damping_share;
    return part;
}

Eigen::VectorXd own_of(const ParameterLayout& layout, const Eigen::VectorXd& p, std::size_t run) {
    return p.segment(layout.at(run, 0), layout.own_size(run));
}

RunColumns columns_of(const ParameterLayout& layout, std::size_t run,
                      const std::vector<Eigen::Index>& parameters) {
    RunColumns found;
    for (std::size_t place = 0; place < parameters.size(); ++place) {
        const bool shared = parameters[place] < shared_count;
        const Eigen::Index own = parameters[place] - layout.at(run, 0);
        if (shared || (own >= 0 && own < layout.own_size(run))) {
            found.places.push_back(static_cast<Eigen::Index>(place));
            found.columns.push_back(shared ? parameters[place] : shared_count + own);
        }
    }
    return found;
}

std::vector<Eigen::Vector2cd> expected_phasors(const FitProblem& problem, const Eigen::VectorXd& p,
                                               std::size_t run) {
    return expected_phasors(problem.runs[run], p.head(shared_count), own_of(problem.layout, p, run),
                            problem.runs[run].size());
}

double chi_square(const FitProblem& problem, const Eigen::VectorXd& p, std::size_t windows,
                  double most) {
    double sum = 0;
    const Eigen::VectorXd shared = p.head(shared_count);
    for (std::size_t k = 0; k < problem.runs.size() && !(sum > most); ++k) {
        sum += chi_square(problem.runs[k], shared, own_of(problem.layout, p, k),
                          std::min(windows, problem.runs[k].size()), most - sum);
    }
    return sum;
}

std::vector<Linearised> linearised(const FitProblem& problem, const Eigen::VectorXd& p,
                                   SharedColumns wanted, std::size_t windows,
                                   std::vector<Linearised> before) {
    before.resize(problem.runs.size());
    const Eigen::VectorXd shared = p.head(shared_count);
    for (std::size_t k = 0; k < problem.runs.size(); ++k) {
        before[k] =
            linearised(problem.runs[k], shared, own_of(problem.layout, p, k),
                       std::min(windows, problem.runs[k].size()), wanted, std::move(before[k]));
    }
    return before;
}

NormalEquations normal_equations(const FitProblem& problem, std::span<const Linearised> runs,
                                 const std::vector<Eigen::Index>& parameters) {
    // Rows that fit into the processor's cache.
    constexpr Eigen::Index block = 256;
    const auto size = static_cast<Eigen::Index>(parameters.size());
    NormalEquations sum{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const auto [places, columns] = columns_of(problem.layout, k, parameters);
        const Linearised& at = runs[k];
        const auto count = static_cast<Eigen::Index>(columns.size());
        Eigen::MatrixXd square = Eigen::MatrixXd::Zero(count, count);
        Eigen::VectorXd toward = Eigen::VectorXd::Zero(count);
        for (Eigen::Index row = 0; row < at.residual.size(); row += block) {
            const Eigen::Index rows = std::min(block, at.residual.size() - row);
            const RowMajor part = at.by_parameter.middleRows(row, rows)(Eigen::all, columns);
            square.selfadjointView<Eigen::Lower>().rankUpdate(part.transpose());
            toward += part.transpose() * at.residual.segment(row, rows);
        }
        square.triangularView<Eigen::StrictlyUpper>() = square.transpose();
        sum.matrix(places, places) += square;
        sum.right(places) += toward;
    }
    return sum;
}

Eigen::VectorXd to_unit_diagonal(const Eigen::MatrixXd& matrix) {
    return matrix.diagonal()
        .cwiseMax(std::numeric_limits<double>::min())
        .cwiseSqrt()
        .cwiseInverse();
}

MapFit minimise(const FitProblem& problem, const Eigen::VectorXd& start, int steps,
                const JobControl& job, std::size_t windows) {
    std::size_t most = 0;
    for (const ScaledRun& run : problem.runs) {
        most = std::max(most, std::min(run.size(), windows));
    }
    const std::size_t every = most / first_of_many;
    if (every < 2) {
        return descend(problem, start, steps, job, windows);
    }
    FitProblem thin = problem;
    for (ScaledRun& run : thin.runs) {
        run = thinned(run, every, windows);
    }
    const MapFit near = descend(thin, start, steps, job, most);
    return descend(problem, near.p, near.converged ? steps : std::min(steps, last_steps), job,
                   windows);
}

double longest_s(const FitProblem& problem) {
    return std::ranges::max_element(problem.runs, {}, &ScaledRun::duration_s)->duration_s;
}

double degrees_of_freedom(const FitProblem& problem) {
    double degrees = 0;
    for (const ScaledRun& run : problem.runs) {
        degrees += (run.phase_lost ? 3 : 4) * static_cast<double>(run.size());
    }
    for (const Eigen::Index k : problem.priors.active()) {
        degrees -= prior_kind(problem.layout, k) == PriorKind::channel ? 0 : 1;
    }
    return degrees;
}

}  // namespace vybeg
