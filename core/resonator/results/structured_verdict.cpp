#include "core/resonator/results/structured_verdict.h"

#include "core/resonator/fit/fit_start.h"
#include "core/resonator/fit/score_test.h"
#include "core/resonator/noise/residual_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

constexpr double kappa_width = 0.01;
constexpr double skew_width = 0.7 * std::numbers::pi / 180;
constexpr double damping_width = 0.1;   // of 1/tau
constexpr double rotation_width = 0.3;  // rad/s
// Most that a rotation weighs: a fast turn of the table is that of a gyro if all else is small.
constexpr double most_by_rotation = 9;
// One of 300 gyros exceeds this, none of 800 mixtures is below it (FIT section 6).
constexpr double most_penalty = 16;
// Largest rise of chi^2 over that of the free fit, in units of its chi^2/dof.
constexpr double most_rise = 25;
constexpr double fits_noise = 6;  // standard deviations of chi^2/dof

struct Term {
    Eigen::Index parameter;
    const char* symbol;
    double unit;  // of the printed value
    const char* unit_name;
};

constexpr std::array<Term, 5> terms{{{kappa_at, "kappa", 1, ""},
                                     {skew_at, "epsilon", 180 / std::numbers::pi, "deg"},
                                     {damping_cos_at, "g cos 4theta_tau", 1, "1/s"},
                                     {damping_sin_at, "g sin 4theta_tau", 1, "1/s"},
                                     {rotation_at, "r", 1, "rad/s"}}};

// `scale`: variance of the noise in units of that of the windows.
StructuredVerdict judge(const FitProblem& problem, const MapFit& main, const MapFit& free,
                        double scale, const ChannelTolerance& tolerance, const JobControl& job) {
    const double dof = degrees_of_freedom(problem);
    const bool fits = main.chi2 / dof < scale * (1 + fits_noise * std::sqrt(2 / dof));
    const double decay = std::abs((fits ? main.p : still_waves(problem))[decay_at]);
    FitProblem narrow = problem;
    for (ScaledRun& run : narrow.runs) {
        for (double& weight : run.weight) {
            weight /= std::sqrt(scale);
        }
    }
    narrow.damping_share = damping_width;
    Priors& priors = narrow.priors;
    priors.sd[kappa_at] = std::max(kappa_width, tolerance[kappa_error]);
    priors.sd[skew_at] = std::max(skew_width, tolerance[skew_error]);
    set_damping(priors, damping_width * decay);
    priors.sd[rotation_at] = rotation_width;

    StructuredVerdict best;
    best.penalty = std::numeric_limits<double>::infinity();
    enum class Candidate { from_main, from_nothing, as_is };
    for (const Candidate candidate :
         {Candidate::from_main, Candidate::from_nothing, Candidate::as_is}) {
        FitProblem trial = narrow;
        MapFit fit = main;
        fit.chi2 /= scale;
        // The main fit may lie away from the minimum if a settling phase remains.
        if (candidate == Candidate::from_main) {
            fit = minimise(trial, main.p, 60, job);
        } else if (candidate == Candidate::from_nothing) {
            fit = fit_from_nothing(trial, job);
        }
        StructuredVerdict verdict;
        verdict.penalty = std::max(fit.chi2 - main.chi2 / scale, 0.0);
        verdict.free_over_structured = fit.chi2 - free.chi2 / scale;
        if (verdict.penalty >= most_penalty || verdict.free_over_structured >= most_rise) {
            // A settling frequency does not characterise the channels, but the free model and
            // unbounded rates follow it better.
            const double settling = settling_score(trial, posterior(trial, fit)).fall;
            verdict.free_over_structured -= settling;
            verdict.penalty =
                std::max(verdict.penalty - settling +
                             settling_score(problem, posterior(problem, main)).fall / scale,
                         0.0);
        }
        const bool residual = verdict.free_over_structured >= most_rise;
        double most = verdict.penalty;
        verdict.reason = Phrase::tr("chi^2 + %1", {number_arg(verdict.penalty, 3)});
        if (residual) {
            verdict.reason = Phrase::tr("chi^2 of the free model - %1",
                                        {number_arg(verdict.free_over_structured, 3)});
        }
        for (const Term& term : terms) {
            const double value = fit.p[term.parameter];
            const double off = (value - priors.mean[term.parameter]) / priors.sd[term.parameter];
            const double weight =
                term.parameter == rotation_at ? std::min(off * off, most_by_rotation) : off * off;
            verdict.penalty += weight;
            if (weight > most && !residual) {
                most = weight;
                verdict.reason = words(
                    "%1 = %2", {term.symbol, number_arg(value * term.unit, 3, term.unit_name)});
            }
        }
        verdict.structured =
            verdict.penalty < most_penalty && verdict.free_over_structured < most_rise;
        if (verdict.penalty < best.penalty || verdict.structured) {
            best = verdict;
        }
        if (best.structured) {
            break;
        }
    }
    return best;
}

}  // namespace

StructuredVerdict test_structured(const FitProblem& problem, const MapFit& main,
                                  const FitProblem& free_problem, const MapFit& free,
                                  const ChannelTolerance& tolerance, const JobControl& job) {
    const double ratio = std::max(1.0, free.chi2 / degrees_of_freedom(free_problem));
    StructuredVerdict verdict = judge(problem, main, free, ratio, tolerance, job);
    if (!verdict.structured) {
        const double scale =
            std::max(ratio, widening(free_problem, posterior(free_problem, free), job));
        if (scale > ratio) {
            verdict = judge(problem, main, free, scale, tolerance, job);
        }
    }
    return verdict;
}

}  // namespace vybeg
