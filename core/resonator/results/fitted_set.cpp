#include "core/resonator/results/fitted_set.h"

#include "core/estimators/wave/wave_state.h"
#include "core/resonator/fit/score_test.h"
#include "core/resonator/model/phasor_model.h"
#include "core/resonator/results/resonator_parameters.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace vybeg {
namespace {

using Eigen::Index;
using std::numbers::pi;

// Step of central differences, as a share of a parameter's deviation with all others known. Within
// its full deviation a parameter that depends on others would leave the linear range.
constexpr double difference_share = 0.03;

constexpr auto errors = static_cast<Index>(channel_errors.size());

// Share of a variance that a profile must add for the direction to count as undetermined.
constexpr double unseen_share = 0.25;

void add_modes(const Eigen::VectorXd& p, ModeOrder order, Eigen::VectorXd& q) {
    std::complex<double> s = std::sqrt(square_half_difference(p));
    if ((order == ModeOrder::frequency ? s.imag() : -s.real()) < 0) {
        s = -s;
    }
    for (const int mode : {0, 1}) {
        const double sign = mode == 0 ? 1 : -1;
        q[mode_f_of + mode] = q[f_mean_of] + sign * s.imag() / (2 * pi);
        q[mode_decay_of + mode] = p[decay_at] - sign * s.real();
    }
}

// Frequency of a run at the power of the wave. The fit has it at that of the recorded channels
// (phasor_model.h), which depends on the gain ratio.
double frequency_of(const Eigen::VectorXd& p, std::size_t run, const FittedSet& set) {
    const ScaledRun& of = set.problem->runs[run];
    const double more = of.power_sums.at(p[kappa_at]) - of.power_sums.at(1);
    return p[set.problem->layout.at(run, frequency_at)] + p[cubic_at] * more / of.power_kept;
}

void add_run(const Eigen::VectorXd& p, std::size_t run, const FittedSet& set, double f_ref_hz,
             Eigen::VectorXd& q) {
    const Eigen::VectorXd own = p.segment(set.problem->layout.at(run, 0), own_count);
    const double f = frequency_of(p, run, set);
    const SlowDynamics dynamics(p);
    const Eigen::Vector2cd start =
        dynamics.window_mean(set.problem->runs[run].window_s, own[frequency_at]).inverse() *
        of_real_parts(own.head<4>());
    const WaveState wave = to_wave_state({start[0], start[1]});
    const auto at = [&](RunQuantity quantity) -> double& {
        return q[quantity_of_run(run, quantity)];
    };
    at(a_A_of) = wave.a_A;
    at(a_B_of) = wave.a_B;
    at(two_theta_of) = wave.two_theta_A;
    at(f_of) = f;
    at(f_offset_of) = (set.runs[run].f_ref_hz - f_ref_hz) + (f - q[f_mean_of]);
    at(run_drift_of) = own[drift_at];
    const double c4 = std::cos(2 * wave.two_theta_A);
    const double s4 = std::sin(2 * wave.two_theta_A);
    at(split_sin_of) = p[split_cos_at] * s4 - p[split_sin_at] * c4;
    const double working = wave.a_A * wave.a_A;
    const double quadrature = wave.a_B * wave.a_B;
    const double share = (working - quadrature) / (working + quadrature) / 2;
    at(direction_f_of) = f + share * (p[split_cos_at] * c4 + p[split_sin_at] * s4);
    at(direction_decay_of) =
        p[decay_at] + share * (p[damping_cos_at] * c4 + p[damping_sin_at] * s4);
}

// Values at p. Amplitudes and angle of a wave are those at t = 0, corrected for the mean over a
// window.
Eigen::VectorXd quantities(const Eigen::VectorXd& p, const FittedSet& set) {
    const std::size_t runs = set.problem->layout.runs();
    Eigen::VectorXd q(quantity_of_run(runs, 0));
    const auto share = 1 / static_cast<double>(runs);
    // References are kept separate, so that differences of frequencies keep their digits.
    double f_mean = 0;
    for (std::size_t run = 0; run < runs; ++run) {
        f_mean += share * frequency_of(p, run, set);
    }
    q[f_mean_of] = f_mean;
    q[decay_of] = p[decay_at];
    q[split_of] = std::hypot(p[split_cos_at], p[split_sin_at]);
    q[theta_w_of] = std::atan2(p[split_sin_at], p[split_cos_at]) / 4;
    q[damping_of] = std::hypot(p[damping_cos_at], p[damping_sin_at]);
    q[theta_tau_of] = std::atan2(p[damping_sin_at], p[damping_cos_at]) / 4;
    q[angle_rate_of] = -p[rotation_at] / 2;
    q[kappa_of] = p[kappa_at];
    q[skew_of] = p[skew_at];
    q[phase_of] = p[phase_at];
    q[cubic_of] = p[cubic_at];
    add_modes(p, set.order, q);
    const double f_ref = set.mean_f_ref_hz();
    for (std::size_t run = 0; run < runs; ++run) {
        add_run(p, run, set, f_ref, q);
    }
    return q;
}

// The period of each quantity that is an angle, rad; 0 for the others.
Eigen::VectorXd quantity_periods(std::size_t runs) {
    Eigen::VectorXd period = Eigen::VectorXd::Zero(quantity_of_run(runs, 0));
    period[theta_w_of] = period[theta_tau_of] = pi / 2;
    for (std::size_t run = 0; run < runs; ++run) {
        period[quantity_of_run(run, two_theta_of)] = pi;
    }
    return period;
}

double by_shorter_way(double difference, double period) {
    return period > 0 ? std::remainder(difference, period) : difference;
}

// Parameters to both sides of the maximum along one of them.
struct Neighbours {
    Eigen::VectorXd up;
    Eigen::VectorXd down;
    double step = 0;  // between them, after rounding
};

Neighbours neighbours(const Posterior& posterior, Index k) {
    const Index at = posterior.active[static_cast<std::size_t>(k)];
    const double h = difference_share * posterior.alone_sd[k];
    Neighbours near{posterior.p, posterior.p, 0};
    near.up[at] += h;
    near.down[at] -= h;
    near.step = near.up[at] - near.down[at];
    return near;
}

// Error of the active parameters by a unit of a channel error or of the cubic spring.
Eigen::VectorXd wrong_by(const FittedSet& set, int error) {
    const Posterior& p = set.posterior;
    if (const Index place = p.place_of(error); place >= 0) {
        const double told = set.problem->priors.sd[error];
        return -p.covariance.col(place) / (told * told);
    }
    const Eigen::VectorXd cross = p.information.col(error)(p.active);
    return p.covariance * cross;
}

// Position of a parameter among the quantities, and the factor from one to the other.
struct Place {
    Index quantity;
    double factor;
};

// From a decay rate to its tau, and to Q.
std::array<Place, 2> decay_places(const ReportedVariances& at, Index decay, double f_hz) {
    const double by_decay = -1 / (at.value[decay] * at.value[decay]);
    return {{{decay, by_decay}, {decay, pi * f_hz * by_decay}}};
}

// In the order of resonator_parameters.
using Places = std::array<Place, resonator_parameters.size()>;
static_assert(resonator_parameters[3].member == &ResonatorEstimate::tau_s &&
              resonator_parameters[10].member == &ResonatorEstimate::delay_s);

Places places_of(const FittedSet& set) {
    const ReportedVariances& at = set.variances;
    const double f_ref_hz = set.mean_f_ref_hz();
    const auto [tau, q] = decay_places(at, decay_of, f_ref_hz + at.value[f_mean_of]);
    return {{{f_mean_of, 1},
             {split_of, 1},
             {theta_w_of, 1},
             tau,
             q,
             {damping_of, 1},
             {theta_tau_of, 1},
             {angle_rate_of, 1},
             {kappa_of, 1},
             {skew_of, 1},
             {phase_of, 1 / tolerated_errors[delay_error].per_unit(f_ref_hz)},
             {cubic_of, 1 / (set.scale * set.scale)}}};
}

}  // namespace

double FittedSet::mean_f_ref_hz() const {
    const double share = 1 / static_cast<double>(runs.size());
    double mean = 0;
    for (const PhasorRun& run : runs) {
        mean += share * run.f_ref_hz;
    }
    return mean;
}

std::complex<double> square_half_difference(const Eigen::VectorXd& p) {
    const std::complex<double> s = SlowDynamics(p).half_difference();
    return s * s;
}

Eigen::VectorXcd square_gradient(const Posterior& posterior) {
    Eigen::VectorXcd by(static_cast<Index>(posterior.active.size()));
    for (Index k = 0; k < by.size(); ++k) {
        const Neighbours near = neighbours(posterior, k);
        by[k] = (square_half_difference(near.up) - square_half_difference(near.down)) / near.step;
    }
    return by;
}

double ReportedVariances::sd(Index quantity) const {
    return std::sqrt(std::max(data[quantity] + nothing[quantity], 0.0));
}

double ReportedVariances::width(Index quantity) const {
    return std::sqrt(std::max(total(quantity), 0.0));
}

double ReportedVariances::u(Index quantity) const {
    return std::hypot(sd(quantity), shares.row(quantity).norm(), spread[quantity]);
}

ReportedVariances reported_variances(const FittedSet& set,
                                     const std::vector<ProfilePoint>& beside) {
    const Posterior& posterior = set.posterior;
    const Eigen::MatrixXd& moved = set.moved;
    ReportedVariances out;
    out.value = quantities(posterior.p, set);
    const Eigen::VectorXd period = quantity_periods(set.runs.size());
    const Index count = out.value.size();
    out.gradient.resize(count, static_cast<Index>(posterior.active.size()));
    for (Index k = 0; k < out.gradient.cols(); ++k) {
        const Neighbours near = neighbours(posterior, k);
        const Eigen::VectorXd difference = quantities(near.up, set) - quantities(near.down, set);
        for (Index q = 0; q < count; ++q) {
            out.gradient(q, k) = by_shorter_way(difference[q], period[q]) / near.step;
        }
    }
    const Eigen::MatrixXd in_root = out.gradient * posterior.root;
    const auto variances = [&](const Eigen::MatrixXd& part) {
        return Eigen::VectorXd((in_root * part).cwiseProduct(in_root).rowwise().sum());
    };
    out.data = variances(posterior.data);
    out.known = variances(posterior.known);
    out.nothing = variances(posterior.nothing);
    for (const ProfilePoint& point : beside) {
        const Eigen::VectorXd there = quantities(point.p, set);
        for (Index q = 0; q < count; ++q) {
            const double off = by_shorter_way(there[q] - out.value[q], period[q]);
            const double missing = off * off / point.rise - out.total(q);
            if (missing > 0) {
                // A small part is the curvature of the quantity along a determined direction.
                (missing > unseen_share * out.total(q) ? out.nothing : out.data)[q] += missing;
            }
        }
    }
    out.shares = Eigen::MatrixXd::Zero(count, moved.cols());
    for (Index k = 0; k < moved.cols(); ++k) {
        if (moved.col(k).isZero(0)) {
            continue;
        }
        for (const double sign : {1.0, -1.0}) {
            Eigen::VectorXd p = posterior.p;
            p(posterior.active) += sign * moved.col(k);
            const Eigen::VectorXd there = quantities(p, set);
            for (Index q = 0; q < count; ++q) {
                double off = by_shorter_way(there[q] - out.value[q], period[q]);
                if (!std::isfinite(off)) {
                    off = out.gradient.row(q).dot(moved.col(k));
                }
                out.shares(q, k) += off * off / 2;
            }
        }
    }
    out.shares = out.shares.cwiseSqrt();
    out.spread = (out.gradient * set.scattered).rowwise().norm();
    return out;
}

Eigen::MatrixXd moved_by(const FittedSet& set) {
    Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(static_cast<Index>(set.posterior.active.size()),
                                                  errors + std::ssize(drift_errors));
    for (std::size_t k = 0; k < channel_errors.size(); ++k) {
        const double size = set.tolerance[channel_errors[k].source];
        if (size > 0) {
            moved.col(static_cast<Index>(k)) = size * wrong_by(set, channel_errors[k].parameter);
        }
    }
    const Eigen::Vector2d drifts(set.tolerance[phase_drift_error], set.tolerance[gain_drift_error]);
    if (!drifts.isZero(0)) {
        moved.rightCols<2>() =
            followed(*set.problem, set.posterior, drift_effect(*set.problem, set.posterior)) *
            drifts.asDiagonal();
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
        for (std::size_t k = 0; k < drift_errors.size(); ++k) {
            double& share = all[of][drift_errors[k]];
            share = std::hypot(
                share, factor * set.variances.shares(quantity, errors + static_cast<Index>(k)));
        }
        all[of][spread_error] = std::abs(factor) * set.variances.spread[quantity];
    }
    return all;
}

namespace {

// Errors of the active parameters per unit of each error: one column, or two of which the worst
// direction counts.
using WrongBySource = std::array<Eigen::MatrixXd, error_sources>;

WrongBySource wrong_by_source(const FittedSet& set) {
    const ReportedVariances& at = set.variances;
    const FitProblem& problem = *set.problem;
    // In units of the largest power of a set.
    double most_power = 0;
    for (const ScaledRun& run : problem.runs) {
        for (const Eigen::Vector2cd& z : run.z) {
            most_power = std::max(most_power, z.squaredNorm() / run.power_kept);
        }
    }
    WrongBySource wrong;
    for (const ToleratedError& error : channel_errors) {
        wrong[error.source] = error.per_unit(set.mean_f_ref_hz()) * wrong_by(set, error.parameter);
    }
    const auto effect = [&](ErrorSource source, const Effect& of, double unit) {
        wrong[source] = unit * followed(problem, set.posterior, of);
    };
    wrong[cubic_error] = wrong_by(set, cubic_at) / most_power;
    effect(damping_error, damping_effect(problem, set.posterior), at.value[decay_of] / most_power);
    Effect both_pickoffs = pickoff_effect(problem, set.posterior);
    for (Eigen::MatrixXd& run : both_pickoffs) {
        run = run.rowwise().sum().eval();
    }
    effect(pickoff_error, both_pickoffs, 1 / most_power);
    effect(springs_error, springs_effect(problem, set.posterior), 1 / most_power);
    effect(eighth_error, eighth_effect(problem, set.posterior), 1);
    return wrong;
}

BySource sensitivity(const FittedSet& set, const WrongBySource& wrong, const Place& place) {
    BySource out{};
    const auto gradient = set.variances.gradient.row(place.quantity);
    for (std::size_t source = 0; source < wrong.size(); ++source) {
        const Eigen::MatrixXd& by = wrong[source];
        if (by.cols() == 1) {
            out[source] = place.factor * gradient.dot(by.col(0));
        } else if (by.cols() > 1) {
            out[source] = std::abs(place.factor) * (gradient * by).norm();
        }
    }
    return out;
}

}  // namespace

void add_sensitivities(const FittedSet& set, ResonatorFit& fit) {
    const WrongBySource wrong = wrong_by_source(set);
    const Places places = places_of(set);
    fit.sensitivities.assign(resonator_parameters.size(), BySource{});
    for (std::size_t of = 0; of < fit.sensitivities.size(); ++of) {
        if (!(fit.resonator.*resonator_parameters[of].member).given()) {
            fit.sensitivities[of].fill(std::numeric_limits<double>::quiet_NaN());
            continue;
        }
        fit.sensitivities[of] = sensitivity(set, wrong, places[of]);
    }
    Index k = 0;
    for (ModeEstimate& mode : fit.modes) {
        const auto [tau, q] = decay_places(set.variances, mode_decay_of + k, mode.f_hz.value);
        for (const Place& place : {Place{mode_f_of + k, 1}, tau, q}) {
            mode.sensitivities.push_back(sensitivity(set, wrong, place));
        }
        ++k;
    }
}

}  // namespace vybeg
