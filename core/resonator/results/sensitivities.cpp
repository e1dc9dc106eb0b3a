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
    const auto found = std::ranges::find(p.active, Index{error});
    if (found != p.active.end()) {
        const double told = problem.priors.sd[error];
        return -p.covariance.col(found - p.active.begin()) / (told * told);
    }
    const Eigen::VectorXd cross = p.information.col(error)(p.active);
    return p.covariance * cross;
}

// Position of a parameter among the quantities, and the factor from one to the other.
struct Place {
    Estimate ResonatorEstimate::*member;
    SharedQuantity quantity;
    double factor;
};

std::array<Place, 12> places_of(const FittedSet& set, double f_ref_hz) {
    const ReportedVariances& at = set.variances;
    const double by_decay = -1 / (at.value[decay_of] * at.value[decay_of]);
    const double by_q = pi * (f_ref_hz + at.value[f_mean_of]) * by_decay;
    return {{{&ResonatorEstimate::f_mean_hz, f_mean_of, 1},
             {&ResonatorEstimate::split_hz, split_of, 1},
             {&ResonatorEstimate::theta_w_rad, theta_w_of, 1},
             {&ResonatorEstimate::tau_s, decay_of, by_decay},
             {&ResonatorEstimate::q, decay_of, by_q},
             {&ResonatorEstimate::damping_anisotropy_per_s, damping_of, 1},
             {&ResonatorEstimate::theta_tau_rad, theta_tau_of, 1},
             {&ResonatorEstimate::angle_rate_rad_s, angle_rate_of, 1},
             {&ResonatorEstimate::kappa, kappa_of, 1},
             {&ResonatorEstimate::non_orthogonality_rad, skew_of, 1},
             {&ResonatorEstimate::delay_s, phase_of, -1 / (2 * pi * f_ref_hz)},
             {&ResonatorEstimate::frequency_per_power, cubic_of, 1 / (set.scale * set.scale)}}};
}

const Place& place_of(const std::array<Place, 12>& places, const ResonatorParameter& parameter) {
    return *std::ranges::find(places, parameter.member, &Place::member);
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

std::vector<BySource> tolerance_shares(const FittedSet& set, const ResonatorEstimate& out,
                                       double f_ref_hz) {
    const auto places = places_of(set, f_ref_hz);
    std::vector<BySource> all;
    for (const ResonatorParameter& parameter : resonator_parameters) {
        const Place& place = place_of(places, parameter);
        BySource shares{};
        for (std::size_t k = 0; k < channel_errors.size() && (out.*parameter.member).given(); ++k) {
            shares[channel_errors[k].source] =
                std::abs(place.factor) *
                set.variances.shares(place.quantity, static_cast<Index>(k));
        }
        if ((out.*parameter.member).given()) {
            shares[spread_error] = std::abs(place.factor) * set.variances.spread[place.quantity];
        }
        all.push_back(shares);
    }
    return all;
}

std::vector<BySource> sensitivities(const FittedSet& set, const ResonatorEstimate& out,
                                    double f_ref_hz) {
    const ReportedVariances& at = set.variances;
    const FitProblem& problem = *set.problem;
    const auto places = places_of(set, f_ref_hz);
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
    wrong[delay_error] *= -2 * pi * f_ref_hz;
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
    std::vector<BySource> all;
    for (const ResonatorParameter& parameter : resonator_parameters) {
        const Place& place = place_of(places, parameter);
        BySource sensitivity{};
        for (int source = 0; source < error_sources; ++source) {
            const Eigen::MatrixXd& by = wrong[static_cast<std::size_t>(source)];
            if (by.cols() == 1) {
                sensitivity[source] = place.factor * at.gradient.row(place.quantity).dot(by.col(0));
            } else if (by.cols() > 1) {
                sensitivity[source] =
                    std::abs(place.factor) * (at.gradient.row(place.quantity) * by).norm();
            }
        }
        if (!(out.*parameter.member).given()) {
            sensitivity.fill(std::numeric_limits<double>::quiet_NaN());
        }
        all.push_back(sensitivity);
    }
    return all;
}

}  // namespace vybeg
