#include "core/resonator/results/describe_fit.h"

#include "core/resonator/fit/posterior.h"
#include "core/resonator/fit/run_information.h"
#include "core/resonator/noise/noise_claim.h"
#include "core/resonator/noise/residual_noise.h"
#include "core/resonator/results/channel_findings.h"
#include "core/resonator/results/fitted_set.h"
#include "core/resonator/results/misfit_cause.h"
#include "core/resonator/results/reported_estimates.h"
#include "core/resonator/runs/decay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>
#include <utility>

namespace vybeg {
namespace {

constexpr std::array<const char*, own_count> own_names{"c_re", "c_im", "d_re",
                                                       "d_im", "f_hz", "drift_hz_per_s"};

// The fitted parameters that are not held, in recording units, with their covariance of all parts.
RawParameters raw_parameters(const FittedSet& set) {
    const ParameterLayout& layout = set.problem->layout;
    const Posterior& at = set.posterior;
    // Name, unit in recording units, origin of each parameter.
    const auto count = static_cast<std::size_t>(layout.size());
    std::vector<std::string> names(count);
    Eigen::VectorXd unit = Eigen::VectorXd::Ones(layout.size());
    Eigen::VectorXd origin = Eigen::VectorXd::Zero(layout.size());
    for (std::size_t k = 0; k < shared_names.size(); ++k) {
        names[k] = shared_names[k];
    }
    unit[cubic_at] = 1 / (set.scale * set.scale);
    for (std::size_t run = 0; run < set.runs.size(); ++run) {
        for (Eigen::Index k = 0; k < layout.own_size(run); ++k) {
            const Eigen::Index place = layout.at(run, 0) + k;
            names[static_cast<std::size_t>(place)] =
                "run" + std::to_string(run + 1) + "." +
                (k < own_count ? own_names[static_cast<std::size_t>(k)]
                               : "break" + std::to_string(k - own_count + 1) + "_rad");
            if (k < frequency_at) {
                unit[place] = set.scale;
            }
        }
        origin[layout.at(run, frequency_at)] = set.runs[run].f_ref_hz;
    }
    const Eigen::MatrixXd covariance = at.covariance_of(0, at.root.rows());
    RawParameters raw;
    for (std::size_t row = 0; row < at.active.size(); ++row) {
        const Eigen::Index parameter = at.active[row];
        raw.names.push_back(names[static_cast<std::size_t>(parameter)]);
        raw.values.push_back(origin[parameter] + unit[parameter] * at.p[parameter]);
        for (std::size_t column = 0; column < at.active.size(); ++column) {
            raw.covariance.push_back(
                unit[parameter] * unit[at.active[column]] *
                covariance(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)));
        }
    }
    return raw;
}

// Least size of a given split or anisotropy, standard deviations.
constexpr double vector_needs = 3;
constexpr double vector_needs_coloured = 5;
// Scatter of chi^2 per degree of freedom that noise makes, standard deviations.
constexpr double residual_scatter = 4;
// Least rise of the log likelihood for a warning of coloured noise. A part enters the deviations
// from a rise of four on, which white noise reaches in one of a hundred sets.
constexpr double evident_rise = 6;

class Description {
public:
    Description(const FittedSet& solved, const JobControl& job)
        : set_(solved), problem_(*solved.problem), job_(job) {}

    ResonatorFit made() {
        const double dof = degrees_of_freedom(problem_);
        const double ratio = set_.fit.chi2 / dof;
        const bool structured = set_.model == ResonatorModel::structured;
        fit_.model = set_.model;
        fit_.chi2_per_dof = ratio;
        set_.posterior = posterior(problem_, set_.fit);
        set_.split_needs = vector_needs;
        set_covariance(ratio, dof);
        std::vector<ProfilePoint> beside;
        if (structured) {
            beside =
                unseen_directions(problem_, set_.fit, set_.posterior, std::max(1.0, ratio), job_);
        }
        set_.order = mode_order();
        set_.scattered = scattered();
        const auto take_variances = [&] {
            set_.moved = moved_by(set_);
            set_.variances = reported_variances(set_, beside);
        };
        take_variances();
        if (!structured) {
            // The channels of the free model are any two projections; only their drifts falsify it.
            // But the amplitudes and the angle of a wave are those of calibrated channels.
            const ReportedVariances calibrated = std::move(set_.variances);
            const ChannelTolerance all = std::exchange(set_.tolerance, {});
            for (const ErrorSource drift : drift_errors) {
                set_.tolerance[drift] = all[drift];
            }
            take_variances();
            for (std::size_t run = 0; run < set_.runs.size(); ++run) {
                for (const int of : {a_A_of, a_B_of, two_theta_of}) {
                    const Eigen::Index at = quantity_of_run(run, of);
                    set_.variances.shares.row(at) = calibrated.shares.row(at);
                }
            }
        }
        fit_.motion = motion_of(set_);
        add_estimates(set_, fit_);
        fit_.raw = raw_parameters(set_);
        add_envelopes();
        if (structured) {
            const bool white =
                fit_.noise.white() && ratio < 1 + residual_scatter * std::sqrt(2 / dof);
            std::ranges::copy(channel_findings(set_, fit_, white),
                              std::back_inserter(fit_.warnings));
        }
        warn();
        return std::move(fit_);
    }

private:
    void set_covariance(double ratio, double dof) {
        Posterior& at = set_.posterior;
        const double scatter = residual_scatter * std::sqrt(2 / dof);
        std::optional<MisfitCause> cause;
        if (ratio > 1 + scatter) {
            cause = misfit_cause(set_, at, Causes::all, job_);
            if (cause) {
                fit_.warnings.push_back(cause->diagnostic);
            }
        }
        const NoiseEstimate noise(problem_, at, job_);
        fit_.noise = noise;
        const NoiseClaim claim = noise_claim(noise, at, job_);
        if (!noise.white()) {
            at.data = noise.covariance(at);
            set_.split_needs = vector_needs_coloured;
        } else if (ratio > 1 + scatter) {
            at.data *= ratio;
        }
        if (!claim.holds) {
            at.data += claim.difference * claim.difference.transpose();
            if (!cause) {
                fit_.warnings.push_back({DiagnosticKind::motion_not_model, {}});
            }
        } else if (!noise.white()) {
            const bool evident = noise.rise > evident_rise;
            if (evident) {
                fit_.warnings.push_back(
                    {DiagnosticKind::residual_coloured, {number_arg(ratio, 3)}});
            }
            if (evident && noise.narrowest) {
                fit_.warnings.push_back(
                    {DiagnosticKind::noise_too_narrow, {number_arg(0.2 / longest_s(problem_), 2)}});
            }
        } else if (ratio > 1 + scatter) {
            fit_.warnings.push_back({DiagnosticKind::residual_above_noise, {number_arg(ratio, 3)}});
        } else if (ratio < 1 - 2 * scatter) {
            fit_.warnings.push_back({DiagnosticKind::residual_below_noise, {number_arg(ratio, 3)}});
        }
    }

    // Changes of the active parameters by one deviation of each run from the set.
    Eigen::MatrixXd scattered() const {
        const Posterior& at = set_.posterior;
        Eigen::MatrixXd along = Eigen::MatrixXd::Zero(
            at.p.size(), deviation_count * static_cast<Eigen::Index>(at.runs.size()));
        for (std::size_t k = 0; k < at.runs.size(); ++k) {
            const Eigen::MatrixXd cross = at.runs[k].by_parameter.transpose() *
                                          by_deviation(problem_.runs[k], at.runs[k], at.p) *
                                          set_.spread.asDiagonal();
            auto of_run =
                along.middleCols<deviation_count>(deviation_count * static_cast<Eigen::Index>(k));
            add_rows(problem_.layout, k, cross, of_run);
        }
        return at.root * (at.root.transpose() * along(at.active, Eigen::all));
    }

    // Order of the modes: by frequency if the frequencies differ, otherwise by decay.
    ModeOrder mode_order() const {
        const Posterior& at = set_.posterior;
        const std::complex<double> s = std::sqrt(square_half_difference(at.p));
        const Eigen::RowVectorXd by = (square_gradient(at) / (2.0 * s)).imag().transpose();
        const double sd = std::sqrt(at.covariance_of(by)(0, 0));
        return std::abs(s.imag()) < 5 * sd ? ModeOrder::decay : ModeOrder::frequency;
    }

    void add_envelopes() {
        double squares = 0;
        double count = 0;
        double windows = 0;
        for (const ScaledRun& run : problem_.runs) {
            windows += static_cast<double>(run.size());
        }
        const double dof_of_window = degrees_of_freedom(problem_) / windows;
        for (std::size_t k = 0; k < problem_.runs.size(); ++k) {
            const ScaledRun& run = problem_.runs[k];
            const std::vector<Eigen::Vector2cd> expected =
                expected_phasors(problem_, set_.fit.p, k);
            for (std::size_t window = 0; window < run.size(); ++window) {
                squares += (run.z[window] - expected[window]).squaredNorm();
                count += 4;
            }
            const Eigen::VectorXd& p = set_.fit.p;
            fit_.runs[k].chi2_per_dof =
                chi_square(run, p.head(shared_count), own_of(problem_.layout, p, k), run.size()) /
                (dof_of_window * static_cast<double>(run.size()));
            const double f_hz = set_.runs[k].f_ref_hz + fit_.motion.runs[k].own[frequency_at];
            add_envelope(k, envelope_decay(run, expected), f_hz);
        }
        fit_.residual_rms = set_.scale * std::sqrt(squares / count);
    }

    void add_envelope(std::size_t run, const EnvelopeDecay& envelope, double f_hz) {
        Estimate& q = fit_.runs[run].q_envelope;
        if (problem_.runs[run].phase_lost) {
            q.reason = {ReasonCode::phase_lost, {}};
            return;
        }
        const double sd = envelope.sd;
        if (!std::isfinite(sd)) {
            q.reason = {ReasonCode::too_few_windows, {}};
            return;
        }
        const double factor = std::numbers::pi * f_hz;
        const Estimate tau = decay_time({envelope.per_s, sd, {}, sd});
        q = tau.given() ? Estimate{factor * tau.value, factor * tau.sd, {}} : tau;
        // A gain of D that drifts changes the envelope alone.
        const double by_channel = set_.tolerance[gain_drift_error] / problem_.runs[run].duration_s;
        if (std::abs(envelope.per_s - envelope.model_per_s) > 4 * std::hypot(sd, by_channel)) {
            fit_.warnings.push_back({DiagnosticKind::q_disagrees,
                                     {recording_arg(run), number_arg(factor / envelope.per_s, 4),
                                      number_arg(factor / envelope.model_per_s, 4)}});
        }
    }

    void warn() {
        for (std::size_t k = 0; k < fit_.runs.size(); ++k) {
            const Estimate& drift = fit_.runs[k].drift_hz_per_s;
            if (drift.given() && std::abs(drift.value) > 4 * drift.uncertainty()) {
                fit_.warnings.push_back(
                    {DiagnosticKind::frequency_drifts,
                     {recording_arg(k), number_arg(drift.value, 3), number_arg(drift.sd, 2)}});
            }
        }
        const Estimate& power = fit_.resonator.frequency_per_power;
        if (power.given()) {
            fit_.warnings.push_back({DiagnosticKind::frequency_follows_amplitude,
                                     {number_arg(power.value, 3), number_arg(power.sd, 2)}});
        }
        if (!set_.fit.finished()) {
            fit_.warnings.push_back({DiagnosticKind::fit_not_converged, {}});
            refuse_all({ReasonCode::not_converged, {}}, fit_);
        }
    }

    FittedSet set_;
    const FitProblem& problem_;
    const JobControl& job_;
    ResonatorFit fit_;
};

}  // namespace

FittedMotion motion_of(const FittedSet& set) {
    FittedMotion motion{.scale = set.scale, .shared = set.fit.p.head(shared_count), .runs = {}};
    for (std::size_t k = 0; k < set.runs.size(); ++k) {
        ScaledRun frame = set.problem->runs[k];
        frame.time_s.clear();
        frame.z.clear();
        frame.weight.clear();
        motion.runs.push_back(
            {set.runs[k].f_ref_hz, std::move(frame), own_of(set.problem->layout, set.fit.p, k)});
    }
    return motion;
}

ResonatorFit describe(const FittedSet& set, const JobControl& job) {
    return Description(set, job).made();
}

}  // namespace vybeg
