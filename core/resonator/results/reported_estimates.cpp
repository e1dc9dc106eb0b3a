#include "core/resonator/results/reported_estimates.h"

#include "core/base/number_text.h"
#include "core/numerics/phase.h"
#include "core/resonator/results/fitted_set.h"
#include "core/resonator/results/resonator_parameters.h"
#include "core/resonator/runs/decay.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace vybeg {
namespace {

using Eigen::Index;
using std::numbers::pi;

// Largest shares of a variance due to priors without information: of a parameter (its deviation is
// then a tenth of the prior's), and of a derived quantity.
constexpr double own_share = 0.01;
constexpr double derived_share = 0.5;
constexpr double axis_needs = 5;  // standard deviations of the vector
constexpr double modes_need = 5;  // of the modes' difference
constexpr double grows_by = 3;    // of a mode that refuses all
constexpr double narrowed = 0.1;  // of a channel's tolerance
constexpr double limit_sd = 2;
// Least size of a dependence on the amplitude, in its uncertainties.
constexpr double claimed_u = 3;
constexpr double vector_needs_in_u = 5;  // of its errors by tolerances and spread
constexpr double any_axis_rad =
    pi / 4 / std::numbers::sqrt3;  // deviation of any axis in 90 degrees
constexpr double much_turned_deg = 22.5;
constexpr double clear_value = 20;    // standard deviations
constexpr double circular_below = 5;  // standard deviations of the smaller travelling wave

class Estimates {
public:
    Estimates(const FittedSet& set, ResonatorFit& fit)
        : set_(set), p_(set.posterior), runs_(set.runs), at_(set.variances), fit_(fit) {}

    void add() {
        add_runs();
        if (set_.model == ResonatorModel::structured) {
            add_resonator();
        } else {
            add_free();
        }
        add_modes();
        if (set_.model == ResonatorModel::structured) {
            add_sensitivities(set_, fit_);
        }
        if (grown_) {
            fit_.warnings.push_back({DiagnosticKind::mode_grows, grown_->args});
            refuse_all(*grown_, fit_);
        }
        refuse_mean_frequency();
    }

private:
    bool unseen(Index quantity, double share) const {
        return at_.nothing[quantity] > share * at_.total(quantity);
    }

    // Whether the value exceeds its uncertainty many times: no anisotropy that keeps the resonator
    // passive imitates such a rotation.
    bool known_against_itself(Index quantity) const {
        return std::abs(at_.value[quantity]) > clear_value * at_.width(quantity);
    }

    Estimate number(Index quantity, double factor = 1, double origin = 0) const {
        const double u = at_.shares.row(quantity).any() || at_.spread[quantity] > 0
                             ? at_.u(quantity) * std::abs(factor)
                             : std::numeric_limits<double>::quiet_NaN();
        return {origin + factor * at_.value[quantity], at_.sd(quantity) * std::abs(factor), {}, u};
    }

    Estimate derived(Index quantity, const Reason& reason, double factor = 1,
                     double origin = 0) const {
        return unseen(quantity, derived_share) ? Estimate{.reason = reason}
                                               : number(quantity, factor, origin);
    }

    Index of_run(std::size_t run, RunQuantity quantity) const {
        return quantity_of_run(run, quantity);
    }

    // Covariance of two parameters side by side, with all its parts.
    Eigen::Matrix2d pair_covariance(int first) const {
        return p_.covariance_of(p_.place_of(first), 2);
    }

    // Largest turn of the wave of any run, degrees of theta_A.
    double turned_deg() const {
        double most = 0;
        for (std::size_t run = 0; run < runs_.size(); ++run) {
            std::vector<double> two_theta;
            for (const Phasors& wave :
                 predicted_waves(fit_.motion, run, set_.problem->runs[run].time_s)) {
                const double angle = to_wave_state(wave).two_theta_A;
                two_theta.push_back(
                    two_theta.empty() ? angle : nearest_branch(angle, two_theta.back(), pi));
            }
            const auto [low, high] = std::ranges::minmax(two_theta);
            most = std::max(most, (high - low) / 2 * 180 / pi);
        }
        return most;
    }

    // Start angle of a recording that would show the rest: halfway between equivalent ones.
    Reason other_direction(ReasonCode code) const {
        const double theta = at_.value[of_run(0, two_theta_of)] / 2;
        const double other = std::remainder(theta * 180 / pi + 22.5, 90.0);
        return {code,
                {number_arg(std::round(10 * other) / 10, 4),
                 number_arg(std::ceil(runs_[0].time_s.back() + runs_[0].window_s / 2), 4)}};
    }

    // Size and axis of the vector that begins at `first` among the parameters.
    void add_vector(int first, SharedQuantity size, SharedQuantity axis, const char* unit,
                    const Reason& reason, Estimate& size_out, Estimate& axis_out) const {
        if (unseen(size, own_share) || unseen(axis, own_share)) {
            size_out = axis_out = Estimate{.reason = reason};
            return;
        }
        const double length = at_.value[size];
        const double most =
            std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(pair_covariance(first))
                          .eigenvalues()[1]);
        const double by_errors = set_.moved.middleRows(p_.place_of(first), 2).norm();
        const double by_spread = set_.scattered.middleRows(p_.place_of(first), 2).norm();
        const double unseen_errors = std::hypot(by_errors, by_spread);
        const Reason within{
            ReasonCode::within_noise,
            {number_arg(length + limit_sd * std::hypot(most, unseen_errors), 3), unit_arg(unit)}};
        size_out = length < set_.split_needs * most ? Estimate{.reason = within} : number(size);
        axis_out = length < std::max(axis_needs, set_.split_needs) * most
                       ? Estimate{.reason = within}
                       : number(axis);
        // Errors as large as the vector leave any axis.
        if (axis_out.given() && length < vector_needs_in_u * unseen_errors) {
            axis_out.u = std::hypot(axis_out.sd, any_axis_rad);
        }
    }

    Estimate channel(SharedQuantity quantity, int parameter, double factor) const {
        const double told = set_.problem->priors.sd[parameter];
        if (told == 0) {
            const bool ratio = parameter == kappa_at;
            return {.reason = {ratio ? ReasonCode::as_given : ReasonCode::held, {}}};
        }
        if (at_.width(quantity) > narrowed * told) {
            return {.reason = {ReasonCode::as_given, {}}};
        }
        return number(quantity, factor);
    }

    // pi f / decay for a frequency and a decay rate among the quantities.
    Estimate quality(Index decay, double f_hz, const Estimate& tau) const {
        if (!tau.given()) {
            return tau;
        }
        // The contribution of the frequency is below 1e-9 of Q for any determined decay.
        const double q = pi * f_hz / at_.value[decay];
        return {q, q * tau.sd / tau.value, {}, q * tau.u / tau.value};
    }

    Estimate decay_time_of(Index decay, const Reason& reason) const {
        return unseen(decay, derived_share) ? Estimate{.reason = reason}
                                            : decay_time(number(decay));
    }

    // Whether the decay only reflects an undetermined anisotropy: no run shows the anisotropy, and
    // the decay is far less precise than that of a run's own direction. Its apparent precision is
    // noise of the second order.
    bool leans_on_unseen_damping() const {
        constexpr double far_less = 300;
        double own = std::numeric_limits<double>::infinity();
        for (std::size_t run = 0; run < runs_.size(); ++run) {
            own = std::min(own, at_.width(of_run(run, direction_decay_of)));
        }
        return unseen(damping_of, own_share) && at_.width(decay_of) > far_less * own;
    }

    void add_resonator() {
        ResonatorEstimate& out = fit_.resonator;
        const Reason one_direction = other_direction(ReasonCode::one_direction);
        const bool turned = turned_deg() > much_turned_deg;
        const Reason damping = turned ? Reason{ReasonCode::kappa_like_damping, {}} : one_direction;
        out.f_mean_hz = derived(f_mean_of, one_direction, 1, f_ref_hz_);
        add_vector(split_cos_at, split_of, theta_w_of, "Hz", one_direction, out.split_hz,
                   out.theta_w_rad);
        add_vector(damping_cos_at, damping_of, theta_tau_of, "1/s", damping,
                   out.damping_anisotropy_per_s, out.theta_tau_rad);
        out.tau_s = leans_on_unseen_damping() ? Estimate{.reason = one_direction}
                                              : decay_time_of(decay_of, one_direction);
        out.q = quality(decay_of, f_ref_hz_ + at_.value[f_mean_of], out.tau_s);
        out.angle_rate_rad_s =
            unseen(angle_rate_of, own_share) && !known_against_itself(angle_rate_of)
                ? Estimate{.reason = other_direction(ReasonCode::confounded_rotation)}
                : number(angle_rate_of);
        out.kappa = channel(kappa_of, kappa_at, 1);
        out.non_orthogonality_rad = channel(skew_of, skew_at, 1);
        out.delay_s =
            channel(phase_of, phase_at, 1 / tolerated_errors[delay_error].per_unit(f_ref_hz_));
        const double power_unit = 1 / (set_.scale * set_.scale);
        // An open term may lose its support to what the fit found after it.
        const bool open = set_.problem->priors.sd[cubic_at] > 0;
        const Estimate power = open ? number(cubic_of) : set_.cubic_limit;
        if (open && set_.amplitude_or_time) {
            out.frequency_per_power.reason = {ReasonCode::amplitude_or_time, {}};
        } else if (open && unseen(cubic_of, own_share)) {
            out.frequency_per_power.reason = {ReasonCode::drift_not_seen, {}};
        } else if (open && std::abs(power.value) > claimed_u * power.uncertainty()) {
            out.frequency_per_power = number(cubic_of, power_unit);
        } else {
            const double most = std::abs(power.value) + limit_sd * power.uncertainty();
            out.frequency_per_power.reason = {ReasonCode::not_nonlinear,
                                              {number_arg(most * power_unit, 3)}};
        }
        if (!out.tau_s.given() && out.tau_s.reason.code == ReasonCode::one_direction) {
            fit_.warnings.push_back({DiagnosticKind::decay_of_one_direction, {}});
        }
        fit_.shares = tolerance_shares(set_, out);
        add_drift_terms();
    }

    void add_free() {
        const Reason reason{ReasonCode::free_model, {}};
        refuse_resonator(reason, fit_);
        for (RunEstimate& run : fit_.runs) {
            run.split_sin_hz = run.direction_f_hz = run.direction_tau_s =
                Estimate{.reason = reason};
        }
    }

    // Whether one of the decay rates is negative by more than its noise.
    void look_for_growth(const std::vector<Index>& decays) {
        for (const Index k : decays) {
            const Estimate decay = number(k);
            if (!unseen(k, derived_share) && decay.value < -grows_by * decay.uncertainty()) {
                const Index f = k == mode_decay_of || k == mode_decay_of + 1
                                    ? k - mode_decay_of + mode_f_of
                                    : Index{f_mean_of};
                grown_ = Reason{ReasonCode::mode_grows,
                                {number_arg(f_ref_hz_ + at_.value[f], 7),
                                 number_arg(-decay.value, 3), number_arg(decay.uncertainty(), 2)}};
            }
        }
    }

    void add_modes() {
        fit_.mode_order = set_.order;
        // |s^2| against the largest deviation of its two parts.
        const Eigen::VectorXcd gradient = square_gradient(p_);
        Eigen::MatrixXd by(2, gradient.size());
        by << gradient.real().transpose(), gradient.imag().transpose();
        const Eigen::Matrix2d spread = p_.covariance_of(by);
        const double most =
            std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvalues()[1]);
        const bool apart = std::abs(square_half_difference(p_.p)) > modes_need * most;
        const bool seen =
            !unseen(mode_f_of, derived_share) && !unseen(mode_f_of + 1, derived_share);
        if (!apart || !seen) {
            // Where the modes are one, or a direction alone is seen, its decay is that of the wave.
            std::vector<Index> decays{decay_of};
            for (std::size_t run = 0; run < runs_.size(); ++run) {
                decays.push_back(of_run(run, direction_decay_of));
            }
            look_for_growth(decays);
            fit_.no_modes = {apart ? ReasonCode::rests_on_unseen : ReasonCode::modes_not_apart, {}};
            return;
        }
        look_for_growth({mode_decay_of, mode_decay_of + 1});
        for (const int k : {0, 1}) {
            ModeEstimate mode;
            mode.f_hz = number(mode_f_of + k, 1, f_ref_hz_);
            mode.tau_s = decay_time_of(mode_decay_of + k, {ReasonCode::rests_on_unseen, {}});
            mode.q = quality(mode_decay_of + k, mode.f_hz.value, mode.tau_s);
            fit_.modes.push_back(mode);
        }
    }

    // Largest statistical deviations of the travelling waves u+ and u-, c +- i d, of a run's start,
    // without the phase common to both, which depends on undetermined frequencies.
    std::pair<double, double> travelling_sd(std::size_t run) const {
        const Index start = set_.problem->layout.at(run, start_at);
        const Eigen::Vector4d wave = p_.p.segment<4>(start);
        const Eigen::Vector4d turned =
            Eigen::Vector4d(-wave[1], wave[0], -wave[3], wave[2]).normalized();
        const Eigen::Matrix4d rest = Eigen::Matrix4d::Identity() - turned * turned.transpose();
        const Eigen::MatrixXd rows = rest * p_.root.middleRows<4>(p_.place_of(start));
        const Eigen::Matrix4d covariance = rows * (p_.data + p_.nothing) * rows.transpose();
        const auto largest = [&](double sign) {
            Eigen::Matrix<double, 2, 4> of_start;
            of_start << 1, 0, 0, -sign, 0, 1, sign, 0;
            const Eigen::Matrix2d spread = of_start * covariance * of_start.transpose();
            return std::sqrt(
                Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvalues()[1]);
        };
        return {largest(1), largest(-1)};
    }

    void add_runs() {
        const Reason rests{ReasonCode::rests_on_unseen, {}};
        for (std::size_t k = 0; k < runs_.size(); ++k) {
            const auto at = [&](RunQuantity quantity) { return of_run(k, quantity); };
            RunEstimate run;
            run.f_offset_hz = derived(at(f_offset_of), rests);
            run.a_A = derived(at(a_A_of), rests, set_.scale);
            run.a_B = derived(at(a_B_of), rests, set_.scale);
            run.drift_hz_per_s = derived(at(run_drift_of), {ReasonCode::drift_not_seen, {}});
            const auto [sd_plus, sd_minus] = travelling_sd(k);
            const double smaller = at_.value[at(a_A_of)] - std::abs(at_.value[at(a_B_of)]);
            if (smaller < circular_below * std::min(sd_plus, sd_minus)) {
                const Estimate circular{.reason = {ReasonCode::circular_wave, {}}};
                // Both amplitudes have a cusp where a travelling wave vanishes.
                run.a_A.sd = run.a_B.sd = set_.scale * std::hypot(sd_plus, sd_minus) / 2;
                for (const auto& [number, quantity] :
                     {std::pair(&run.a_A, a_A_of), {&run.a_B, a_B_of}}) {
                    number->u =
                        std::hypot(number->sd, set_.scale * at_.shares.row(at(quantity)).norm(),
                                   set_.scale * at_.spread[at(quantity)]);
                }
                run.two_theta_A_rad = run.split_sin_hz = circular;
                run.direction_f_hz = run.direction_tau_s = circular;
            } else {
                run.two_theta_A_rad = derived(at(two_theta_of), rests);
                run.split_sin_hz = derived(at(split_sin_of), rests);
                run.direction_f_hz = derived(at(direction_f_of), rests, 1, runs_[k].f_ref_hz);
                run.direction_tau_s = decay_time_of(at(direction_decay_of), rests);
            }
            fit_.runs.push_back(run);
        }
    }

    // No frequency is common to recordings that lie further apart than a temperature explains.
    void refuse_mean_frequency() {
        constexpr double most_apart = 300e-6;
        std::size_t low = 0;
        std::size_t high = 0;
        const auto f_hz = [&](std::size_t run) {
            return runs_[run].f_ref_hz + at_.value[of_run(run, f_of)];
        };
        for (std::size_t k = 1; k < runs_.size(); ++k) {
            low = f_hz(k) < f_hz(low) ? k : low;
            high = f_hz(k) > f_hz(high) ? k : high;
        }
        const double apart = (f_hz(high) - f_hz(low)) / f_hz(low);
        // A spring has another frequency at each amplitude.
        if (set_.problem->priors.sd[cubic_at] > 0 || !(apart > most_apart)) {
            return;
        }
        const MessageArg ppm = number_arg(1e6 * apart, 3);
        const Reason reason{ReasonCode::frequencies_apart, {ppm}};
        fit_.resonator.f_mean_hz = fit_.resonator.q = Estimate{.reason = reason};
        for (RunEstimate& run : fit_.runs) {
            run.f_offset_hz = Estimate{.reason = reason};
        }
        fit_.modes.clear();
        fit_.no_modes = reason;
        fit_.warnings.push_back({DiagnosticKind::frequencies_apart,
                                 {ppm, recording_arg(low), number_arg(f_hz(low), 7),
                                  recording_arg(high), number_arg(f_hz(high), 7)}});
    }

    void add_drift_terms() {
        const ResonatorEstimate& out = fit_.resonator;
        DriftTerms& terms = fit_.drift_terms;
        // An anisotropy within its noise still bounds the drift.
        const auto seen = [](const Estimate& estimate) {
            return estimate.given() || estimate.reason.code == ReasonCode::within_noise;
        };
        terms.given = seen(out.damping_anisotropy_per_s) && out.angle_rate_rad_s.given();
        const std::array<Index, 3> parameters{rotation_at, damping_cos_at, damping_sin_at};
        std::array<Index, 3> rows{};
        std::ranges::transform(parameters, rows.begin(),
                               [this](Index k) { return p_.place_of(k); });
        terms.value = p_.p(parameters);
        const Eigen::MatrixXd root = p_.root(rows, Eigen::all);
        terms.covariance = root * (p_.data + p_.nothing) * root.transpose();
        const Eigen::MatrixXd scattered = set_.scattered(rows, Eigen::all);
        const Eigen::MatrixXd drifted = set_.moved(rows, Eigen::lastN(std::ssize(drift_errors)));
        terms.spread = scattered * scattered.transpose() + drifted * drifted.transpose();
        for (std::size_t k = 0; k < channel_errors.size(); ++k) {
            const ToleratedError& error = channel_errors[k];
            const double size = set_.tolerance[error.source];
            if (size > 0) {
                const Eigen::VectorXd moved = set_.moved.col(static_cast<Index>(k));
                terms.tolerated.push_back({moved(rows), motion_with(error.parameter, size, moved)});
            }
        }
    }

    // The motion of which an error that the fit does not know makes the fitted one.
    FittedMotion motion_with(SharedParameter error, double size,
                             const Eigen::VectorXd& moved) const {
        Eigen::VectorXd at = p_.p;
        at(p_.active) -= moved;
        if (set_.problem->priors.sd[error] == 0) {
            at[error] += size;
        }
        FittedMotion motion = fit_.motion;
        motion.shared = at.head(shared_count);
        for (std::size_t k = 0; k < motion.runs.size(); ++k) {
            motion.runs[k].own = own_of(set_.problem->layout, at, k);
        }
        return motion;
    }

    const FittedSet& set_;
    const Posterior& p_;
    std::span<const PhasorRun> runs_;
    const ReportedVariances& at_;
    ResonatorFit& fit_;
    const double f_ref_hz_ = set_.mean_f_ref_hz();
    std::optional<Reason> grown_;  // a mode that grows
};

}  // namespace

void add_estimates(const FittedSet& set, ResonatorFit& fit) {
    Estimates(set, fit).add();
}

void refuse_resonator(const Reason& reason, ResonatorFit& fit) {
    refuse(resonator_parameters, reason, fit.resonator);
    fit.sensitivities.assign(resonator_parameters.size(), {});
    fit.shares.assign(resonator_parameters.size(), {});
}

void refuse_all(const Reason& reason, ResonatorFit& fit) {
    refuse_resonator(reason, fit);
    for (RunEstimate& run : fit.runs) {
        Estimate of_power = std::move(run.q_envelope);
        refuse(run_parameters, reason, run);
        run.q_envelope = std::move(of_power);
    }
    fit.modes.clear();
    fit.no_modes = reason;
    fit.drift_terms.given = false;
}

}  // namespace vybeg
