#include "core/resonator/fit/refit_in_phase.h"

#include "core/resonator/fit/fit_start.h"
#include "core/resonator/fit/score_test.h"

#include <cmath>
#include <complex>
#include <vector>

namespace vybeg {

namespace {

constexpr int most_steps = 60;

struct Turned {
    std::vector<ScaledRun> runs;
    double mean_square = 0;  // mean square of the phases, in units of the windows' noise
};

// The runs with their phasors rotated to the phases predicted by a fit.
Turned turned_by(const FitProblem& problem, const MapFit& fit) {
    constexpr double clear = 0.2;  // largest residual share of a wave
    Turned turned{{problem.runs.begin(), problem.runs.end()}, 0};
    double count = 0;
    for (std::size_t k = 0; k < turned.runs.size(); ++k) {
        ScaledRun& run = turned.runs[k];
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

// Fit of the rotated runs, from p, with their chi2.
MapFit fit_turned(const FitProblem& problem, const Turned& turned, const Eigen::VectorXd& p,
                  const JobControl& job) {
    FitProblem in_phase = problem;
    in_phase.runs = turned.runs;
    return minimise(in_phase, p, most_steps, job);
}

}  // namespace

MapFit refit_in_phase(const FitProblem& problem, const MapFit& fit, const JobControl& job) {
    constexpr double large = 4;
    const Turned turned = turned_by(problem, fit);
    if (turned.mean_square < large) {
        return fit;
    }
    MapFit again = fit_turned(problem, turned, fit.p, job);
    again.chi2 = chi_square(problem, again.p);
    return again;
}

std::optional<MapFit> fit_still_in_phase(const FitProblem& problem, const MapFit& main,
                                         const JobControl& job) {
    const double dof = degrees_of_freedom(problem);
    const auto above_noise = [](double chi2, double freedom) {
        return chi2 > noise_bound(freedom) * freedom;
    };
    // Rates beyond those of gyros: half of what passivity allows, half a radian per second.
    const bool strange =
        std::hypot(main.p[damping_cos_at], main.p[damping_sin_at]) > 0.5 * main.p[decay_at] ||
        std::abs(main.p[rotation_at]) > 0.5;
    const bool fine = !above_noise(main.chi2, dof);
    if (fine && !strange) {
        return {};
    }
    FitProblem still = problem;
    still.priors = first_priors(problem.priors, problem.layout, FirstFit::drifting_wave);
    const MapFit wave = minimise(still, still_waves(problem), most_steps, job);
    MapFit fit = fit_turned(problem, turned_by(problem, wave), wave.p, job);
    // One of the four numbers of a window, the phase, is not used.
    if (above_noise(fit.chi2, 0.75 * dof)) {
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
