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

// Response of the parameters to a unit of a channel error, others unchanged: -S F_re for a held
// error, or the regression on a fitted one.
Eigen::VectorXd follow(const Posterior& p, int error) {
    const auto found = std::ranges::find(p.active, Index{error});
    if (found != p.active.end()) {
        const Index k = found - p.active.begin();
        return p.covariance.col(k) / p.covariance(k, k);
    }
    const Eigen::VectorXd cross = p.information.col(error)(p.active);
    return -(p.covariance * cross);
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

std::vector<ToleranceShares> tolerance_shares(const FittedSet& set, const ResonatorEstimate& out,
                                              double f_ref_hz) {
    static constexpr std::array channels{kappa_at,     skew_at,        phase_at,
                                         crosstalk_at, phase_drift_at, gain_drift_at};
    static constexpr std::array members{
        &ToleranceShares::kappa,     &ToleranceShares::skew,        &ToleranceShares::delay,
        &ToleranceShares::crosstalk, &ToleranceShares::phase_drift, &ToleranceShares::gain_drift};
    const Posterior& posterior = set.posterior;
    const auto places = places_of(set, f_ref_hz);
    std::vector<ToleranceShares> all;
    for (const ResonatorParameter& parameter : resonator_parameters) {
        const Place& place = place_of(places, parameter);
        ToleranceShares shares;
        for (std::size_t k = 0; k < channels.size() && (out.*parameter.member).given(); ++k) {
            const auto found = std::ranges::find(posterior.active, Index{channels[k]});
            if (found != posterior.active.end()) {
                const Eigen::VectorXd moved =
                    posterior.covariance.col(found - posterior.active.begin());
                shares.*members[k] =
                    std::abs(place.factor * set.variances.gradient.row(place.quantity).dot(moved)) /
                    set.problem->priors.sd[channels[k]];
            }
        }
        all.push_back(shares);
    }
    return all;
}

std::vector<ChannelSensitivity> sensitivities(const FittedSet& set, const ResonatorEstimate& out,
                                              double f_ref_hz) {
    const ReportedVariances& at = set.variances;
    const auto places = places_of(set, f_ref_hz);
    struct ChannelError {
        int parameter;
        double ChannelSensitivity::*member;
        double unit;
    };
    const std::array<ChannelError, 6> errors{
        {{kappa_at, &ChannelSensitivity::kappa, 1},
         {skew_at, &ChannelSensitivity::skew_deg, pi / 180},
         {phase_at, &ChannelSensitivity::delay_s, -2 * pi * f_ref_hz},
         {crosstalk_at, &ChannelSensitivity::crosstalk, 1},
         {phase_drift_at, &ChannelSensitivity::phase_drift_rad, 1},
         {gain_drift_at, &ChannelSensitivity::gain_drift, 1}}};
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    // In units of the largest power of a set.
    double most_power = 0;
    for (const ScaledRun& run : set.problem->runs) {
        for (const Eigen::Vector2cd& z : run.z) {
            most_power = std::max(most_power, z.squaredNorm() / run.power_kept);
        }
    }
    const double most_hz = 1 / most_power;
    const Eigen::VectorXd by_damping =
        at.value[decay_of] / most_power *
        followed(*set.problem, set.posterior, damping_effect(*set.problem, set.posterior));
    Effect both_pickoffs = pickoff_effect(*set.problem, set.posterior);
    for (Eigen::MatrixXd& run : both_pickoffs) {
        run = run.rowwise().sum().eval();
    }
    const Eigen::VectorXd by_pickoffs =
        followed(*set.problem, set.posterior, both_pickoffs) / most_power;
    std::vector<ChannelSensitivity> all;
    for (const ResonatorParameter& parameter : resonator_parameters) {
        const Place& place = place_of(places, parameter);
        ChannelSensitivity sensitivity{nan, nan, nan, nan, nan, nan, nan, nan, nan};
        if ((out.*parameter.member).given()) {
            for (const ChannelError& error : errors) {
                sensitivity.*error.member =
                    place.factor * error.unit *
                    at.gradient.row(place.quantity).dot(follow(set.posterior, error.parameter));
            }
            sensitivity.cubic_hz =
                place.factor * most_hz *
                at.gradient.row(place.quantity).dot(follow(set.posterior, cubic_at));
            sensitivity.pickoff_share =
                place.factor * at.gradient.row(place.quantity).dot(by_pickoffs);
            sensitivity.damping_share =
                place.factor * at.gradient.row(place.quantity).dot(by_damping);
        }
        all.push_back(sensitivity);
    }
    return all;
}

}  // namespace vybeg
