#include "core/resonator/resonator_estimates.h"

#include "core/base/number_text.h"
#include "core/resonator/axis_estimates.h"
#include "core/resonator/mode_estimates.h"
#include "core/resonator/run_estimates.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

using std::numbers::pi;

// 1/tau as tau, where it is seen.
Estimate tau_of(double decay, double sd) {
    if (decay < 3 * sd) {
        return {.reason = {ReasonCode::no_decay, {short_text(decay, 3), short_text(sd, 3)}}};
    }
    return {1 / decay, sd / (decay * decay), {}};
}

Estimate mean_frequency(const DeltaMethod& delta, const FitState& state,
                        std::span<const PhasorRun> runs, Eigen::VectorXd& by) {
    const double share = 1 / static_cast<double>(runs.size());
    double mean = 0;
    by = delta.gradient();
    for (std::size_t k = 0; k < runs.size(); ++k) {
        mean += share * (runs[k].f_ref_hz + state.runs[k][frequency_index]);
        by[DeltaMethod::place(k, frequency_index)] = share;
    }
    return delta.estimate(mean, by);
}

// What would show the rest: the start angle halfway between those that show the same.
Reason other_direction(ReasonCode code, const RunEstimate& first, const PhasorRun& run) {
    const double theta = first.two_theta_A_rad.given() ? first.two_theta_A_rad.value / 2 : 0;
    const double other = std::remainder(theta * 180 / pi + 22.5, 90.0);
    return {code,
            {short_text(std::round(10 * other) / 10, 4),
             short_text(std::ceil(run.time_s.back() + run.window_s / 2), 4)}};
}

RawParameters raw_parameters(const ModelChoice& choice, const DeltaMethod& delta,
                             std::span<const PhasorRun> runs, double scale) {
    static constexpr std::array<const char*, shared_count> shared_names{
        "split_cos4_hz",      "split_sin4_hz",  "damping_cos4_per_s",
        "damping_sin4_per_s", "rotation_per_s", "skew_per_s",
        "decay_per_s",        "kappa",          "frequency_per_power"};
    static constexpr std::array<const char*, own_count> own_names{"f_hz", "drift_hz_per_s", "c_re",
                                                                  "c_im", "d_re",           "d_im"};
    RawParameters raw;
    std::vector<Eigen::Index> places;
    std::vector<double> units;
    const auto add = [&](Eigen::Index place, std::string name, double value, double unit) {
        if (delta.covariance()(place, place) > 0) {
            places.push_back(place);
            units.push_back(unit);
            raw.names.push_back(std::move(name));
            raw.values.push_back(value * unit);
        }
    };
    for (int k = 0; k < shared_count; ++k) {
        add(k, shared_names[static_cast<std::size_t>(k)], choice.fit.state.shared[k],
            k == power_index ? 1 / (scale * scale) : 1);
    }
    for (std::size_t run = 0; run < runs.size(); ++run) {
        for (int k = 0; k < own_count; ++k) {
            const double origin = k == frequency_index ? runs[run].f_ref_hz : 0;
            add(DeltaMethod::place(run, k),
                "run" + std::to_string(run + 1) + "." + own_names[static_cast<std::size_t>(k)],
                origin + choice.fit.state.runs[run][k], k >= start_index ? scale : 1);
        }
    }
    for (std::size_t row = 0; row < places.size(); ++row) {
        for (std::size_t column = 0; column < places.size(); ++column) {
            raw.covariance.push_back(units[row] * units[column] *
                                     delta.covariance()(places[row], places[column]));
        }
    }
    return raw;
}

FittedMotion fitted_motion(const FitState& state, std::span<const PhasorRun> runs,
                           std::span<const ScaledRun> scaled, double scale) {
    FittedMotion motion{.rates = rates_of(state.shared),
                        .kappa = state.shared[kappa_index],
                        .frequency_per_power = state.shared[power_index] / (scale * scale),
                        .runs = {}};
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const Own& own = state.runs[k];
        FittedMotion::Run run{.f_ref_hz = runs[k].f_ref_hz,
                              .f_hz = own[frequency_index],
                              .drift_hz_per_s = own[drift_index],
                              .middle_s = scaled[k].middle_s,
                              .window_s = runs[k].window_s,
                              .start = scale * start_of(own),
                              .time_s = scaled[k].time_s,
                              .power_integral = scaled[k].power_integral};
        for (double& integral : run.power_integral) {
            integral *= scale * scale;
        }
        motion.runs.push_back(std::move(run));
    }
    return motion;
}

// Root of the mean square of the real and imaginary parts of what is left.
double residual_rms(std::span<const ScaledRun> runs, const FitState& state) {
    double sum = 0;
    double count = 0;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        std::vector<double> r(4 * runs[k].size());
        residuals(runs[k], state.shared, state.runs[k], r.data(), nullptr, nullptr);
        for (std::size_t j = 0; j < r.size(); ++j) {
            sum += std::pow(r[j] / runs[k].weight[j / 4], 2);
        }
        count += static_cast<double>(r.size());
    }
    return std::sqrt(sum / count);
}

Estimate scaled_by(Estimate estimate, double factor) {
    estimate.value *= factor;
    estimate.sd *= factor;
    return estimate;
}

void structured_estimates(ResonatorFit& fit, const ModelChoice& choice, const DeltaMethod& delta,
                          std::span<const PhasorRun> runs) {
    ResonatorEstimate& out = fit.resonator;
    const Shared& shared = choice.fit.state.shared;
    Eigen::VectorXd by;
    out.f_mean_hz = mean_frequency(delta, choice.fit.state, runs, by);
    const Reason one_direction = other_direction(ReasonCode::one_direction, fit.runs[0], runs[0]);
    const AxisEstimate split = axis_estimate(delta, shared, 0);
    const AxisEstimate damping = axis_estimate(delta, shared, 2);
    out.split_hz = choice.split_seen ? split.size : Estimate{.reason = one_direction};
    out.theta_w_rad = choice.split_seen ? split.axis : Estimate{.reason = one_direction};
    Reason unseen = one_direction;
    if (choice.equal_damping) {
        unseen = {ReasonCode::kappa_like_damping, {}};
    }
    out.damping_anisotropy_per_s = choice.damping_seen ? damping.size : Estimate{.reason = unseen};
    out.theta_tau_rad = choice.damping_seen ? damping.axis : Estimate{.reason = unseen};

    const double decay = shared[rate_count - 1];
    const double decay_sd = std::sqrt(delta.covariance()(rate_count - 1, rate_count - 1));
    out.tau_s = tau_of(decay, decay_sd);
    out.q = out.tau_s;
    if (out.q.given()) {
        // Q = pi f/(1/tau), f and tau being as good as independent beside tau's own deviation.
        by *= 1 / decay;
        by[rate_count - 1] = -out.f_mean_hz.value / (decay * decay);
        out.q = delta.estimate(pi * out.f_mean_hz.value / decay, pi * by);
    }
    out.angle_rate_rad_s = {-shared[4] / 2, std::sqrt(delta.covariance()(4, 4)) / 2, {}};
    if (!choice.rotation_seen) {
        out.angle_rate_rad_s = {
            .reason = other_direction(ReasonCode::confounded_rotation, fit.runs[0], runs[0])};
    }
}

void free_estimates(ResonatorFit& fit) {
    const Estimate none{.reason = {ReasonCode::free_model, {}}};
    ResonatorEstimate& out = fit.resonator;
    for (Estimate* estimate :
         {&out.f_mean_hz, &out.split_hz, &out.theta_w_rad, &out.tau_s, &out.q,
          &out.damping_anisotropy_per_s, &out.theta_tau_rad, &out.angle_rate_rad_s}) {
        *estimate = none;
    }
    for (RunEstimate& run : fit.runs) {
        run.split_sin_hz = none;
    }
}

}  // namespace

ResonatorFit estimates(const ModelChoice& choice, std::span<const PhasorRun> runs,
                       std::span<const ScaledRun> scaled, double scale) {
    const DeltaMethod delta(choice.covariance * choice.enlargement);
    const FitState& state = choice.fit.state;
    ResonatorFit fit;
    fit.model = choice.model;
    fit.warnings = choice.warnings;
    fit.residual_rms = scale * residual_rms(scaled, state);
    fit.chi2_per_dof = choice.fit.chi2 / choice.dof;
    fit.free_over_structured = choice.free_over_structured;
    if (choice.enlargement > 1) {
        fit.warnings.push_back(
            {DiagnosticKind::residual_above_noise, {short_text(fit.chi2_per_dof, 3)}});
    }

    Eigen::VectorXd mean_by;
    const Estimate mean = mean_frequency(delta, state, runs, mean_by);
    for (std::size_t k = 0; k < runs.size(); ++k) {
        RunEstimate run = run_estimate(delta, state, k, runs[k].window_s, scale);
        Eigen::VectorXd by = -mean_by;
        by[DeltaMethod::place(k, frequency_index)] += 1;
        run.f_offset_hz =
            delta.estimate(runs[k].f_ref_hz + state.runs[k][frequency_index] - mean.value, by);
        run.drift_hz_per_s = choice.drift_hz_per_s[k];
        envelope_estimate(run, scaled[k], state, k, mean.value + run.f_offset_hz.value,
                          choice.enlargement, fit.warnings);
        fit.runs.push_back(run);
    }
    if (choice.model == ResonatorModel::structured) {
        structured_estimates(fit, choice, delta, runs);
    } else {
        free_estimates(fit);
    }
    fit.resonator.kappa = choice.kappa;
    // M is eight numbers and a resonator seven: one is left for all errors of the channels.
    const Reason channels{choice.model == ResonatorModel::free ? ReasonCode::free_model
                                                               : ReasonCode::channels_one_number,
                          {}};
    fit.resonator.non_orthogonality_rad = fit.resonator.delay_s = Estimate{.reason = channels};
    fit.resonator.frequency_per_power = scaled_by(choice.frequency_per_power, 1 / (scale * scale));

    const bool told_apart =
        choice.model == ResonatorModel::free || choice.split_seen || choice.damping_seen;
    if (told_apart) {
        fit.modes = mode_estimates(delta, state.shared, mean.value, mean_by);
    }
    if (fit.modes.empty()) {
        fit.no_modes = {ReasonCode::modes_not_apart, {}};
    }
    const ResonatorEstimate& given = fit.resonator;
    fit.identifiable = {.split = given.split_hz.given(),
                        .theta_w = given.theta_w_rad.given(),
                        .tau = given.tau_s.given(),
                        .damping_anisotropy = given.damping_anisotropy_per_s.given(),
                        .theta_tau = given.theta_tau_rad.given(),
                        .rotation = given.angle_rate_rad_s.given(),
                        .kappa = given.kappa.given()};
    fit.raw = raw_parameters(choice, delta, runs, scale);
    fit.motion = fitted_motion(state, runs, scaled, scale);
    return fit;
}

}  // namespace vybeg
