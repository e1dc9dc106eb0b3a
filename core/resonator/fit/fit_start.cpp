#include "core/resonator/fit/fit_start.h"

#include "core/numerics/statistics.h"
#include "core/resonator/fit/pencil_start.h"
#include "core/resonator/fit/score_test.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

using std::numbers::pi;

constexpr std::size_t first_windows = 4;
constexpr int short_steps = 12;  // of a fit to the first windows
constexpr int all_steps = 60;
constexpr int polish_steps = 200;  // of the best fit, where it did not converge
constexpr double same_cost = 1e-6;
constexpr double close_behind = 1.2;
// Chi^2 over the number of residuals above which a fit is not polished.
constexpr double hopeless = 100;

// 1/tau from the envelope: a straight line through log |z|, weighted with |z|.
double envelope_decay(const ScaledRun& run) {
    const LineFit line = fit_line(run.size(), [&run](std::size_t k) {
        const double size = run.z[k].norm();
        return LinePoint{run.time_s[k], std::log(size), size};
    });
    return -line.slope;
}

// Sets a still wave: frequency and start from the first windows.
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
    p.segment<5>(problem.layout.at(index, 0)) << real_parts(start), f;
}

std::size_t longest(const FitProblem& problem) {
    return std::ranges::max_element(problem.runs, {}, &ScaledRun::size)->size();
}

// Number of residuals of the first `windows` windows of each run.
double residuals(const FitProblem& problem, std::size_t windows) {
    double count = 0;
    for (const ScaledRun& run : problem.runs) {
        count += 4 * static_cast<double>(std::min(windows, run.size()));
    }
    return count;
}

bool above_noise(const FitProblem& problem, const MapFit& fit) {
    return fit.cost > problem.noise_ratio * residuals(problem, longest(problem));
}

// Free parameters of the fit to the first windows of the runs. Channels and cubic term are held in
// both cases, because few windows cannot determine them.
enum class FirstFit {
    moving_wave,    // the rates; no drift
    drifting_wave,  // the drift; a still wave that decays
};
Priors first_priors(Priors priors, const ParameterLayout& layout, FirstFit kind) {
    for (Eigen::Index k = 0; k < layout.size(); ++k) {
        const bool physical = prior_kind(layout, k) == PriorKind::physical;
        const bool drift = physical && k >= shared_count;
        const bool held = kind == FirstFit::moving_wave ? drift : physical && !drift;
        if (prior_kind(layout, k) == PriorKind::channel || k == cubic_at || held) {
            priors.sd[k] = 0;
        }
    }
    return priors;
}

// Fit to the first windows, then to increasing numbers of windows.
struct Lengthened {
    Eigen::VectorXd p;
    bool at_noise = true;  // the residual of the last of those fits is at most twice the noise
};

Lengthened fit_lengthening(FitProblem problem, FirstFit kind, const JobControl& job) {
    Lengthened out{still_waves(problem)};
    const Priors all = problem.priors;
    const std::size_t windows = longest(problem);
    for (std::size_t count = first_windows; count < windows && !job.cancelled();
         count += count / 2 + 1) {
        problem.priors = all;
        set_damping(problem.priors, problem.damping_share * out.p[decay_at]);
        problem.priors = first_priors(problem.priors, problem.layout, kind);
        const MapFit fit = minimise(problem, out.p, short_steps, job, count);
        out.p = fit.p;
        if (kind == FirstFit::drifting_wave && count > 2 * first_windows &&
            fit.cost > hopeless * residuals(problem, count)) {
            return {out.p, false};
        }
        out.at_noise = fit.cost < problem.noise_ratio * residuals(problem, count);
    }
    return out;
}

constexpr double no_fit = std::numeric_limits<double>::infinity();

// Cost of the fit from `start`; a lower one replaces `best`.
double try_start(const FitProblem& problem, const Eigen::VectorXd& start, const JobControl& job,
                 MapFit& best) {
    MapFit fit = minimise(problem, start, all_steps, job);
    // Close to the best, not converged, and still on its way there.
    if (!fit.converged && fit.cost > best.cost && fit.cost < close_behind * best.cost &&
        fit.cost - polish_steps * fit.last_gain < best.cost) {
        fit = minimise(problem, fit.p, polish_steps, job);
    }
    const double cost = fit.cost;
    if (cost < best.cost) {
        best = std::move(fit);
    }
    return cost;
}

// Starts from the fit of each run alone: its shared parameters for all runs, the own parameters of
// each.
void try_alone(FitProblem& problem, const JobControl& job, MapFit& best) {
    struct Alone {
        double residual = 0;
        Eigen::VectorXd shared;
    };
    std::vector<Alone> alone;
    Eigen::VectorXd own = best.p;
    for (std::size_t k = 0; k < problem.runs.size() && !job.cancelled(); ++k) {
        FitProblem one = part_of(problem, std::array{k});
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

struct Turned {
    FitProblem problem;
    double mean_square = 0;  // mean square of the phases, in units of the windows' noise
};

// The problem with the runs' phasors rotated to the phases predicted by a fit.
Turned turned_by(const FitProblem& problem, const MapFit& fit) {
    constexpr double clear = 0.2;  // largest residual share of a wave
    Turned turned{problem};
    double count = 0;
    for (std::size_t k = 0; k < problem.runs.size(); ++k) {
        ScaledRun& run = turned.problem.runs[k];
        const std::vector<Eigen::Vector2cd> expected = expected_phasors(problem, fit.p, k);
        double left = 0;
        for (std::size_t window = 0; window < run.size(); ++window) {
            left += (run.z[window] - expected[window]).squaredNorm();
        }
        const double least = std::sqrt(left / static_cast<double>(run.size())) / clear;
        for (std::size_t window = 0; window < run.size(); ++window) {
            if (expected[window].norm() < least) {
                continue;
            }
            const double phase =
                std::arg((run.whitening * expected[window]).dot(run.whitening * run.z[window]));
            turned.mean_square +=
                std::pow(phase, 2) * run.weighted(window, run.z[window]).squaredNorm();
            run.z[window] *= std::polar(1.0, -phase);
        }
        count += static_cast<double>(run.size());
    }
    turned.mean_square /= count;
    return turned;
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

StillFit fit_waves(FitProblem& problem, const JobControl& job) {
    const Lengthened lengthened = fit_lengthening(problem, FirstFit::moving_wave, job);
    set_damping(problem.priors, problem.damping_share * lengthened.p[decay_at]);
    StillFit wave{{lengthened.p, no_fit, no_fit}, {}, {}};
    if (lengthened.at_noise) {
        try_start(problem, lengthened.p, job, wave.best);
    } else {
        wave.far = lengthened.p;
    }
    // Rates that a still wave does not show can imitate a drift, and the fit would not return from
    // there.
    const Lengthened drifting = fit_lengthening(problem, FirstFit::drifting_wave, job);
    if (drifting.at_noise) {
        try_start(problem, drifting.p, job, wave.best);
    } else {
        wave.drifting = drifting.p;
    }
    return wave;
}

MapFit fit_modes(FitProblem& problem, const StillFit& wave, const JobControl& job, Starts starts) {
    MapFit best = wave.best;
    // A small split also keeps the residual of the drifting start above the noise.
    const double count = residuals(problem, longest(problem));
    if (wave.drifting.size() > 0 && best.cost > noise_limit(count)) {
        try_start(problem, wave.drifting, job, best);
    }
    // Noise that is not white keeps the best start above the windows' noise. A minimum reached from
    // two independent starts is accepted.
    bool confirmed = false;
    for (const Pencil kind : {Pencil::two_channels, Pencil::delayed}) {
        if (confirmed || !above_noise(problem, best)) {
            break;
        }
        if (const std::optional<Eigen::VectorXd> start = pencil_start(problem, kind, job)) {
            const double before = best.cost;
            const double found = try_start(problem, *start, job, best);
            confirmed = std::abs(found - before) < same_cost * before;
        }
    }
    // A lengthening that never reached the noise is the last resort, because it ends far from a
    // minimum.
    if (!confirmed && wave.far.size() > 0 && above_noise(problem, best)) {
        try_start(problem, wave.far, job, best);
    }
    if (!confirmed && starts == Starts::all && problem.runs.size() > 1 &&
        above_noise(problem, best)) {
        try_alone(problem, job, best);
    }
    if (!best.converged && best.cost < hopeless * count) {
        best = minimise(problem, best.p, polish_steps, job);
    }
    return best;
}

MapFit fit_from_nothing(FitProblem& problem, const JobControl& job) {
    const StillFit wave = fit_waves(problem, job);
    return fit_modes(problem, wave, job);
}

MapFit fit_from(FitProblem& problem, const Eigen::VectorXd& p, const JobControl& job) {
    set_damping(problem.priors, problem.damping_share * p[decay_at]);
    return minimise(problem, p, all_steps, job);
}

MapFit refit_in_phase(const FitProblem& problem, const MapFit& fit, const JobControl& job) {
    constexpr double large = 4;
    const Turned turned = turned_by(problem, fit);
    if (turned.mean_square < large) {
        return fit;
    }
    MapFit again = minimise(turned.problem, fit.p, all_steps, job);
    again.chi2 = chi_square(problem, again.p);
    return again;
}

std::optional<MapFit> fit_still_in_phase(const FitProblem& problem, const MapFit& main,
                                         const JobControl& job) {
    const double dof = degrees_of_freedom(problem);
    // Rates beyond those of gyros: half of what passivity allows, half a radian per second.
    const bool strange =
        std::hypot(main.p[damping_cos_at], main.p[damping_sin_at]) > 0.5 * main.p[decay_at] ||
        std::abs(main.p[rotation_at]) > 0.5;
    const bool fine = !(main.chi2 > noise_limit(dof));
    if (fine && !strange) {
        return {};
    }
    FitProblem still = problem;
    still.priors = first_priors(problem.priors, problem.layout, FirstFit::drifting_wave);
    const MapFit wave = minimise(still, still_waves(problem), all_steps, job);
    MapFit fit = minimise(turned_by(problem, wave).problem, wave.p, all_steps, job);
    // One of the four numbers of a window, the phase, is not used.
    if (fit.chi2 > noise_limit(0.75 * dof)) {
        return {};
    }
    fit.chi2 = chi_square(problem, fit.p);
    // Rates that leave only noise are replaced only by a settling that fits as well.
    constexpr double as_well = 25;
    if (fine) {
        const double left =
            fit.chi2 - settling_score(problem, posterior(problem, fit)).fall - main.chi2;
        const bool settles = fit.chi2 - main.chi2 > as_well && left < as_well;
        return settles ? std::optional(fit) : std::nullopt;
    }
    return fit;
}

}  // namespace vybeg
