#include "core/resonator/results/sensitivities.h"

#include "core/resonator/fit/score_test.h"
#include "core/resonator/results/resonator_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

using Eigen::Index;
using std::numbers::pi;

// Error of the active parameters by a unit of a channel error or of the cubic spring.
Eigen::VectorXd wrong_by(const FitProblem& problem, const Posterior& p, int error) {
    if (const Index place = p.place_of(error); place >= 0) {
        const double told = problem.priors.sd[error];
        return -p.covariance.col(place) / (told * told);
    }
    const Eigen::VectorXd cross = p.information.col(error)(p.active);
    return p.covariance * cross;
}

// Position of a parameter among the quantities, and the factor from one to the other.
struct Place {
    SharedQuantity quantity;
    double factor;
};

// In the order of resonator_parameters.
using Places = std::array<Place, resonator_parameters.size()>;
static_assert(resonator_parameters[3].member == &ResonatorEstimate::tau_s &&
              resonator_parameters[10].member == &ResonatorEstimate::delay_s);

Places places_of(const FittedSet& set) {
    const ReportedVariances& at = set.variances;
    const double f_ref_hz = set.context.mean_f_ref_hz();
    const double by_decay = -1 / (at.value[decay_of] * at.value[decay_of]);
    const double by_q = pi * (f_ref_hz + at.value[f_mean_of]) * by_decay;
    return {{{f_mean_of, 1},
             {split_of, 1},
             {theta_w_of, 1},
             {decay_of, by_decay},
             {decay_of, by_q},
             {damping_of, 1},
             {theta_tau_of, 1},
             {angle_rate_of, 1},
             {kappa_of, 1},
             {skew_of, 1},
             {phase_of, -1 / (2 * pi * f_ref_hz)},
             {cubic_of, 1 / (set.scale * set.scale)}}};
}

}  // namespace

Eigen::MatrixXd moved_by(const FitProblem& problem, const Posterior& posterior,
                         const ChannelTolerance& tolerance) {
    Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(static_cast<Index>(posterior.active.size()),
                                                  static_cast<Index>(channel_errors.size()));
    for (std::size_t k = 0; k < channel_errors.size(); ++k) {
        const double size = tolerance.*channel_errors[k].tolerance;
        if (size > 0) {
            moved.col(static_cast<Index>(k)) =
                size * wrong_by(problem, posterior, channel_errors[k].parameter);
        }
    }
    return moved;
}

std::vector<BySource> tolerance_shares(const FittedSet& set, const ResonatorEstimate& out) {
    std::vector<BySource> all(resonator_parameters.size(), BySource{});
    const Places places = places_of(set);
    for (std::size_t of = 0; of < all.size(); ++of) {
        if (!(out.*resonator_parameters[of].member).given()) {
            continue;
        }
        const auto& [quantity, factor] = places[of];
        for (std::size_t k = 0; k < channel_errors.size(); ++k) {
            all[of][channel_errors[k].source] =
                std::abs(factor) * set.variances.shares(quantity, static_cast<Index>(k));
        }
        all[of][spread_error] = std::abs(factor) * set.variances.spread[quantity];
    }
    return all;
}

std::vector<BySource> sensitivities(const FittedSet& set, const ResonatorEstimate& out) {
    const ReportedVariances& at = set.variances;
    const FitProblem& problem = *set.problem;
    // In units of the largest power of a set.
    double most_power = 0;
    for (const ScaledRun& run : problem.runs) {
        for (const Eigen::Vector2cd& z : run.z) {
            most_power = std::max(most_power, z.squaredNorm() / run.power_kept);
        }
    }
    std::array<Eigen::MatrixXd, error_sources> wrong;
    for (const ChannelError& error : channel_errors) {
        wrong[error.source] = wrong_by(problem, set.posterior, error.parameter);
    }
    wrong[skew_error] *= pi / 180;
    wrong[delay_error] *= -2 * pi * set.context.mean_f_ref_hz();
    const auto effect = [&](ErrorSource source, const Effect& of, double unit) {
        wrong[source] = unit * followed(problem, set.posterior, of);
    };
    wrong[cubic_error] = wrong_by(problem, set.posterior, cubic_at) / most_power;
    effect(damping_error, damping_effect(problem, set.posterior), at.value[decay_of] / most_power);
    Effect both_pickoffs = pickoff_effect(problem, set.posterior);
    for (Eigen::MatrixXd& run : both_pickoffs) {
        run = run.rowwise().sum().eval();
    }
    effect(pickoff_error, both_pickoffs, 1 / most_power);
    effect(springs_error, springs_effect(problem, set.posterior), 1 / most_power);
    effect(eighth_error, eighth_effect(problem, set.posterior), 1);
    std::vector<BySource> all(resonator_parameters.size(), BySource{});
    const Places places = places_of(set);
    for (std::size_t of = 0; of < all.size(); ++of) {
        if (!(out.*resonator_parameters[of].member).given()) {
            all[of].fill(std::numeric_limits<double>::quiet_NaN());
            continue;
        }
        const auto& [quantity, factor] = places[of];
        for (std::size_t source = 0; source < wrong.size(); ++source) {
            const Eigen::MatrixXd& by = wrong[source];
            if (by.cols() == 1) {
                all[of][source] = factor * at.gradient.row(quantity).dot(by.col(0));
            } else if (by.cols() > 1) {
                all[of][source] = std::abs(factor) * (at.gradient.row(quantity) * by).norm();
            }
        }
    }
    return all;
}

}  // namespace vybeg
