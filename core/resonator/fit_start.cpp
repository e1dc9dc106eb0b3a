#include "core/resonator/fit_start.h"

#include "core/resonator/pencil_start.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

using std::numbers::pi;

constexpr std::size_t first_windows = 4;
constexpr int short_steps = 12;  // of a fit to the first windows
constexpr int all_steps = 200;

// 1/tau from the envelope: a straight line through log |z|, weighted with |z|.
double envelope_decay(const ScaledRun& run) {
    double weight = 0;
    double mean_t = 0;
    double mean = 0;
    for (std::size_t k = 0; k < run.size(); ++k) {
        const double size = run.z[k].norm();
        weight += size;
        mean_t += size * run.time_s[k];
        mean += size > 0 ? size * std::log(size) : 0;
    }
    mean_t /= weight;
    mean /= weight;
    double spread = 0;
    double moment = 0;
    for (std::size_t k = 0; k < run.size(); ++k) {
        const double size = run.z[k].norm();
        const double t = run.time_s[k] - mean_t;
        spread += size * t * t;
        moment += size > 0 ? size * t * (std::log(size) - mean) : 0;
    }
    return -moment / spread;
}

// A still wave: frequency and start from the first windows.
void set_still_wave(const FitProblem& problem, std::size_t index, Eigen::VectorXd& p) {
    const ScaledRun& run = problem.runs[index];
    const std::size_t count = std::min(first_windows, run.size());
    std::complex<double> step = 0;
    for (std::size_t k = 1; k < count; ++k) {
        step += run.z[k - 1].dot(run.z[k]);
    }
    const double f = std::arg(step) / (2 * pi * (run.time_s[1] - run.time_s[0]));
    Eigen::Vector2cd start = Eigen::Vector2cd::Zero();
    for (std::size_t k = 0; k < count; ++k) {
        start += std::polar(1.0 / static_cast<double>(count),
                            -2 * pi * f * (run.time_s[k] - run.reference_s)) *
                 run.z[k];
    }
    const Eigen::Index at = problem.layout.at(index, 0);
    p.segment<5>(at) << start[0].real(), start[0].imag(), start[1].real(), start[1].imag(), f;
}

std::size_t longest(const FitProblem& problem) {
    std::size_t most = 0;
    for (const ScaledRun& run : problem.runs) {
        most = std::max(most, run.size());
    }
    return most;
}

bool above_noise(const FitProblem& problem, const MapFit& fit) {
    double residuals = 0;
    for (const ScaledRun& run : problem.runs) {
        residuals += 4 * static_cast<double>(run.size());
    }
    return fit.cost > 2 * residuals;
}

// From the fit of each run alone: its shared parameters for all, everyone's own ones.
void try_alone(FitProblem& problem, const JobControl& job, MapFit& best) {
    struct Alone {
        double residual = 0;
        Eigen::VectorXd shared;
    };
    std::vector<Alone> alone;
    Eigen::VectorXd own = best.p;
    for (std::size_t k = 0; k < problem.runs.size(); ++k) {
        const std::array breaks{problem.runs[k].breaks_s.size()};
        FitProblem one{
            problem.runs.subspan(k, 1), ParameterLayout(breaks), {}, problem.damping_share};
        const auto part = [&](const Eigen::VectorXd& of_all) {
            Eigen::VectorXd of_one(one.layout.size());
            of_one << of_all.head(shared_count), own_of(problem.layout, of_all, k);
            return of_one;
        };
        one.priors = {part(problem.priors.mean), part(problem.priors.sd)};
        const MapFit fit = fit_from_nothing(one, job);
        own.segment(problem.layout.at(k, 0), problem.layout.own_size(k)) =
            own_of(one.layout, fit.p, 0);
        alone.push_back(
            {fit.cost / static_cast<double>(problem.runs[k].size()), fit.p.head(shared_count)});
    }
    std::ranges::sort(alone, {}, &Alone::residual);
    alone.resize(std::min<std::size_t>(alone.size(), 2));
    for (const Alone& candidate : alone) {
        own.head(shared_count) = candidate.shared;
        MapFit fit = minimise(problem, own, all_steps, job);
        if (fit.cost < best.cost) {
            best = std::move(fit);
        }
    }
}

}  // namespace

Eigen::VectorXd still_waves(const FitProblem& problem) {
    Eigen::VectorXd p = problem.priors.mean;
    double decay = 0;
    for (std::size_t k = 0; k < problem.runs.size(); ++k) {
        set_still_wave(problem, k, p);
        decay += envelope_decay(problem.runs[k]) / static_cast<double>(problem.runs.size());
    }
    p[decay_at] = decay;
    return p;
}

MapFit fit_from_nothing(FitProblem& problem, const JobControl& job) {
    Eigen::VectorXd p = still_waves(problem);
    const Priors all = problem.priors;
    const auto windows = longest(problem);
    for (std::size_t count = first_windows; count < windows; count += count / 2 + 1) {
        problem.priors = without_refinements(all, problem.layout);
        set_damping(problem.priors, problem.damping_share * p[decay_at]);
        p = minimise(problem, p, short_steps, job, count).p;
    }
    problem.priors = all;
    MapFit best = fit_from(problem, p, job);
    for (const Pencil kind : {Pencil::two_channels, Pencil::delayed}) {
        if (!above_noise(problem, best)) {
            break;
        }
        if (const std::optional<Eigen::VectorXd> start = pencil_start(problem, kind)) {
            MapFit fit = minimise(problem, *start, all_steps, job);
            if (fit.cost < best.cost) {
                best = std::move(fit);
            }
        }
    }
    if (problem.runs.size() > 1 && above_noise(problem, best)) {
        try_alone(problem, job, best);
    }
    return best;
}

MapFit fit_from(FitProblem& problem, const Eigen::VectorXd& p, const JobControl& job) {
    set_damping(problem.priors, problem.damping_share * p[decay_at]);
    return minimise(problem, p, all_steps, job);
}

}  // namespace vybeg
