#include "core/resonator/structured_test.h"

#include "core/base/number_text.h"
#include "core/resonator/fit_start.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vybeg {
namespace {

constexpr double kappa_width = 0.01;
constexpr double skew_width = 0.7 * std::numbers::pi / 180;
constexpr double damping_width = 0.1;   // of 1/tau
constexpr double rotation_width = 0.3;  // rad/s
// Of 300 gyros one has more, of 800 mixtures none has less (FIT section 6).
constexpr double most_penalty = 16;
// Of chi^2 over that of the free fit, in units of its chi^2/dof.
constexpr double most_rise = 25;
constexpr double fits_noise = 6;  // standard deviations of chi^2/dof

struct Term {
    Eigen::Index parameter;
    const char* symbol;
    double unit;  // of the printed value
    const char* unit_name;
};

constexpr std::array<Term, 5> terms{{{kappa_at, "kappa", 1, ""},
                                     {skew_at, "epsilon", 180 / std::numbers::pi, " deg"},
                                     {damping_cos_at, "g cos 4theta_tau", 1, " 1/s"},
                                     {damping_sin_at, "g sin 4theta_tau", 1, " 1/s"},
                                     {rotation_at, "r", 1, " rad/s"}}};

}  // namespace

StructuredVerdict test_structured(const FitProblem& problem, const MapFit& main, const MapFit& free,
                                  double free_dof, const ChannelTolerance& tolerance,
                                  const JobControl& job) {
    const double dof = degrees_of_freedom(problem);
    const bool fits = main.chi2 / dof < 1 + fits_noise * std::sqrt(2 / dof);
    const double decay = std::abs((fits ? main.p : still_waves(problem))[decay_at]);
    const double scale = std::max(1.0, free.chi2 / free_dof);
    FitProblem narrow = problem;
    narrow.damping_share = damping_width;
    Priors& priors = narrow.priors;
    priors.sd[kappa_at] = std::max(kappa_width, tolerance.kappa);
    priors.sd[skew_at] = std::max(skew_width, tolerance.skew_rad);
    set_damping(priors, damping_width * decay);
    priors.sd[rotation_at] = rotation_width;

    StructuredVerdict best;
    best.penalty = std::numeric_limits<double>::infinity();
    for (const bool from_nothing : {false, true}) {
        FitProblem trial = narrow;
        const MapFit fit =
            from_nothing ? fit_from_nothing(trial, job) : minimise(trial, main.p, 60, job);
        StructuredVerdict verdict;
        verdict.penalty = std::max(fit.chi2 - main.chi2, 0.0) / scale;
        verdict.free_over_structured = (fit.chi2 - free.chi2) / scale;
        double most = verdict.penalty;
        verdict.reason = "chi^2 + " + short_text(verdict.penalty, 3);
        for (const Term& term : terms) {
            const double value = fit.p[term.parameter];
            const double off = (value - priors.mean[term.parameter]) / priors.sd[term.parameter];
            verdict.penalty += off * off;
            if (off * off > most) {
                most = off * off;
                verdict.reason = std::string(term.symbol) + " = " +
                                 short_text(value * term.unit, 3) + term.unit_name;
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

}  // namespace vybeg
