#include "core/resonator/results/resonator_fit.h"

#include "core/base/number_text.h"
#include "core/resonator/fit/fit_start.h"
#include "core/resonator/fit/refit_in_phase.h"
#include "core/resonator/fit/score_test.h"
#include "core/resonator/noise/residual_noise.h"
#include "core/resonator/results/misfit_cause.h"
#include "core/resonator/results/raw_parameters.h"
#include "core/resonator/results/resonator_estimates.h"
#include "core/resonator/results/structured_test.h"
#include "core/resonator/runs/decay_time.h"
#include "core/resonator/runs/envelope_decay.h"
#include "core/resonator/runs/merge_windows.h"
#include "core/resonator/runs/needed_windows.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

// Each run has four to six parameters of its own; eight windows are 32 numbers.
constexpr std::size_t least_windows = 8;
// Of one run, where its motion within a window allows: the fit's time grows with their number.
constexpr std::size_t enough_windows = 150;
// Fall of chi^2 from which on a dependence of the frequency on the amplitude is fitted.
constexpr double cubic_fall = 25;
// Of the last step: a tenth of a standard deviation. Along what is not seen a fit creeps for ever.
constexpr double unfinished_gain = 0.01;
constexpr int cubic_steps = 200;
// Size of split and anisotropy from which on they are given, standard deviations.
constexpr double vector_needs = 3;
constexpr double vector_needs_coloured = 5;

double largest_amplitude(std::span<const PhasorRun> runs) {
    double most = 0;
    for (const PhasorRun& run : runs) {
        for (std::size_t k = 0; k < run.c.size(); ++k) {
            most = std::max({most, std::abs(run.c[k]), std::abs(run.d[k])});
        }
    }
    return most;
}

std::vector<ScaledRun> scaled_runs(std::span<const PhasorRun> runs, double scale) {
    std::vector<ScaledRun> scaled;
    for (const PhasorRun& run : runs) {
        scaled.push_back(scaled_run(run, scale));
    }
    return scaled;
}

std::string recording_number(std::size_t run) {
    return integer_text(static_cast<std::int64_t>(run) + 1);
}

// The whole fit of one set, step by step.
class SetFit {
public:
    // `fine`: the runs before their windows were merged.
    SetFit(std::vector<PhasorRun> runs, std::span<const PhasorRun> fine, double scale,
           const FitOptions& options, const JobControl& job)
        : runs_(std::move(runs)),
          fine_(fine),
          scaled_(scaled_runs(runs_, scale)),
          scale_(scale),
          options_(options),
          job_(job),
          problem_{scaled_, layout_of(scaled_), {}} {
        problem_.priors = structured_priors(scaled_, problem_.layout, options.tolerance);
    }

    // Finds the most likely parameters; the number of windows of a run that they ask for.
    NeededWindows solve() {
        main_ = fit_still_in_phase(problem_, fit_from_nothing(problem_, job_), job_);
        try_cubic(main_);
        choose_model(main_);
        main_ = refit_in_phase(problem_, main_, job_);
        return needed_windows(motion(main_), fine_);
    }

    // Whether these windows are explained about as well as those of another solution.
    bool explains_as_much_as(const SetFit& other) const {
        const double dof = degrees_of_freedom(problem_);
        const double other_ratio = other.main_.chi2 / degrees_of_freedom(other.problem_);
        const bool structured =
            fit_.model == other.fit_.model || other.fit_.model == ResonatorModel::free;
        return structured &&
               main_.chi2 / dof < std::max(1.5 * other_ratio, 1 + 6 * std::sqrt(2 / dof));
    }

    // What they say of the resonator.
    ResonatorFit described() {
        describe(main_);
        return std::move(fit_);
    }

private:
    static ParameterLayout layout_of(const std::vector<ScaledRun>& runs) {
        std::vector<std::size_t> breaks;
        for (const ScaledRun& run : runs) {
            breaks.push_back(run.breaks_s.size());
        }
        return ParameterLayout(breaks);
    }

    // A dependence of the frequency on the amplitude is opened where the data ask for it: always
    // open it would cost elliptic waves their rotation.
    void try_cubic(MapFit& main) {
        const Posterior at = posterior(problem_, main);
        const Score score = cubic_score(problem_, at);
        const double dof = degrees_of_freedom(problem_);
        double scale = std::max(1.0, (main.chi2 - score.fall) / dof);
        cubic_limit_ = {score.size[0], std::sqrt(score.inverse(0, 0) * scale), {}};
        if (score.fall < cubic_fall * scale / 4) {
            return;
        }
        FitProblem with = problem_;
        open_cubic(with.priors, scaled_);
        MapFit fit = minimise(with, main.p, 60, job_);
        scale = std::max(1.0, fit.chi2 / degrees_of_freedom(with));
        if (main.chi2 - fit.chi2 <= cubic_fall * scale) {
            return;
        }
        // A frequency that settles falls with the amplitude, too.
        const double settling = main.chi2 - settling_score(problem_, at).fall;
        if (settling < fit.chi2 - cubic_fall * scale) {
            return;
        }
        amplitude_or_time_ = settling < fit.chi2 + cubic_fall * scale;
        main = std::move(fit);
        problem_.priors = with.priors;
        polish_cubic(main);
    }

    // Without the cubic term the other parameters have stood in for it, far from where they belong:
    // the way back is long, or begins anew at still waves.
    void polish_cubic(MapFit& main) const {
        if (main.converged) {
            return;
        }
        Eigen::VectorXd anew = still_waves(problem_);
        anew[cubic_at] = main.p[cubic_at];
        for (const Eigen::VectorXd& start : {main.p, anew}) {
            MapFit fit = minimise(problem_, start, cubic_steps, job_);
            if (fit.cost < main.cost) {
                main = std::move(fit);
            }
        }
    }

    void choose_model(MapFit& main) {
        using Model = FitOptions::Model;
        if (options_.model == Model::structured) {
            return;
        }
        FitProblem free = problem_;
        free.priors = free_priors(scaled_, problem_.layout);
        Eigen::VectorXd start = main.p;
        start[kappa_at] = 1;
        for (const int held :
             {skew_at, phase_at, crosstalk_at, phase_drift_at, gain_drift_at, cubic_at}) {
            start[held] = 0;
        }
        MapFit free_fit = fit_near_or_from_nothing(free, start);
        const StructuredVerdict verdict =
            test_structured(problem_, main, free, free_fit, options_.tolerance, job_);
        fit_.free_over_structured = verdict.free_over_structured;
        if (options_.model == Model::automatic && verdict.structured) {
            return;
        }
        if (options_.model == Model::automatic) {
            fit_.warnings.push_back({DiagnosticKind::structured_refused, {verdict.reason}});
        }
        fit_.model = ResonatorModel::free;
        problem_.priors = std::move(free.priors);
        main = std::move(free_fit);
    }

    // |z|^2 of channels of unknown scale beats, so that the free model has no cubic term.
    MapFit fit_near_or_from_nothing(FitProblem& problem, const Eigen::VectorXd& start) const {
        MapFit near = minimise(problem, start, 60, job_);
        const double dof = degrees_of_freedom(problem);
        const double ratio = 1 + 6 * std::sqrt(2 / dof);
        if (near.chi2 < ratio * dof) {
            return near;
        }
        // Channels that see nearly one mixture hide the second mode in a chi^2 of two.
        FitProblem anew = problem;
        anew.noise_ratio = ratio;
        anew.damping_share = std::numeric_limits<double>::infinity();
        MapFit fit = fit_from_nothing(anew, job_);
        return fit.cost < near.cost ? fit : near;
    }

    void describe(const MapFit& main) {
        const double dof = degrees_of_freedom(problem_);
        const double ratio = main.chi2 / dof;
        fit_.chi2_per_dof = ratio;
        FittedSet set;
        set.model = fit_.model;
        set.problem = &problem_;
        set.fit = main;
        set.posterior = posterior(problem_, main);
        set.scale = scale_;
        set.cubic_limit = cubic_limit_;
        set.amplitude_or_time = amplitude_or_time_;
        set.split_needs = vector_needs;
        set.context.layout = &problem_.layout;
        for (const PhasorRun& run : runs_) {
            set.context.f_ref_hz.push_back(run.f_ref_hz);
            set.context.window_s.push_back(run.window_s);
        }
        set_covariance(ratio, dof, set);
        std::vector<ProfilePoint> beside;
        if (fit_.model == ResonatorModel::structured) {
            beside = unseen_directions(problem_, main, set.posterior, std::max(1.0, ratio), job_);
        }
        set.context.order = mode_order(set);
        set.variances = reported_variances(set.posterior, set.context, beside);
        fit_.motion = motion(main);
        add_estimates(set, runs_, fit_);
        fit_.raw = raw_parameters(set, runs_);
        add_envelopes();
        warn(main);
    }

    void set_covariance(double ratio, double dof, FittedSet& set) {
        const double scatter = 4 * std::sqrt(2 / dof);
        if (ratio > 1 + scatter) {
            if (const auto cause = misfit_cause(problem_, set.posterior, fine_, scale_)) {
                fit_.warnings.push_back(*cause);
            }
        }
        const NoiseEstimate noise(problem_, set.posterior);
        fit_.noise = noise.noise();
        if (!noise.noise().white()) {
            set.posterior.data = noise.covariance(set.posterior);
            set.split_needs = vector_needs_coloured;
            fit_.warnings.push_back({DiagnosticKind::residual_coloured, {short_text(ratio, 3)}});
            if (noise.noise().narrowest) {
                double longest_s = 0;
                for (const ScaledRun& run : scaled_) {
                    longest_s = std::max(longest_s, run.duration_s);
                }
                fit_.warnings.push_back(
                    {DiagnosticKind::noise_too_narrow, {short_text(0.2 / longest_s, 2)}});
            }
            return;
        }
        if (ratio > 1 + scatter) {
            set.posterior.data *= ratio;
            fit_.warnings.push_back({DiagnosticKind::residual_above_noise, {short_text(ratio, 3)}});
        } else if (ratio < 1 - 2 * scatter) {
            fit_.warnings.push_back({DiagnosticKind::residual_below_noise, {short_text(ratio, 3)}});
        }
    }

    // Modes are named by frequency where the frequencies differ, else by their decay.
    ModeOrder mode_order(const FittedSet& set) const {
        const Posterior& at = set.posterior;
        const std::complex<double> s = std::sqrt(square_half_difference(at.p));
        const Eigen::RowVectorXd by = (square_gradient(at) / (2.0 * s)).imag().transpose();
        const double sd = std::sqrt(at.covariance_of(by)(0, 0));
        return std::abs(s.imag()) < 5 * sd ? ModeOrder::decay : ModeOrder::frequency;
    }

    FittedMotion motion(const MapFit& main) const {
        FittedMotion motion{.scale = scale_, .shared = main.p.head(shared_count), .runs = {}};
        for (std::size_t k = 0; k < runs_.size(); ++k) {
            ScaledRun frame = scaled_[k];
            frame.time_s.clear();
            frame.z.clear();
            frame.weight.clear();
            motion.runs.push_back(
                {runs_[k].f_ref_hz, std::move(frame), own_of(problem_.layout, main.p, k)});
        }
        return motion;
    }

    void add_envelopes() {
        double squares = 0;
        double count = 0;
        for (std::size_t k = 0; k < runs_.size(); ++k) {
            const ScaledRun& run = scaled_[k];
            const std::vector<Eigen::Vector2cd> expected =
                expected_phasors(run, fit_.motion.shared, fit_.motion.runs[k].own, run.size());
            for (std::size_t window = 0; window < run.size(); ++window) {
                squares += (run.z[window] - expected[window]).squaredNorm();
                count += 4;
            }
            const double f_hz = runs_[k].f_ref_hz + fit_.motion.runs[k].own[frequency_at];
            add_envelope(k, envelope_decay(run, expected), f_hz);
        }
        fit_.residual_rms = scale_ * std::sqrt(squares / count);
    }

    void add_envelope(std::size_t run, const EnvelopeDecay& envelope, double f_hz) {
        Estimate& q = fit_.runs[run].q_envelope;
        const double sd = envelope.sd;
        if (!std::isfinite(sd)) {
            q.reason = {ReasonCode::too_few_windows, {}};
            return;
        }
        const double factor = std::numbers::pi * f_hz;
        const Estimate tau = decay_time(envelope.per_s, sd, sd);
        q = tau.given() ? Estimate{factor * tau.value, factor * tau.sd, {}} : tau;
        if (std::abs(envelope.per_s - envelope.model_per_s) > 3 * sd) {
            fit_.warnings.push_back({DiagnosticKind::q_disagrees,
                                     {recording_number(run), short_text(factor / envelope.per_s, 4),
                                      short_text(factor / envelope.model_per_s, 4)}});
        }
    }

    void warn(const MapFit& main) {
        if (!main.converged && main.last_gain > unfinished_gain) {
            fit_.warnings.push_back({DiagnosticKind::fit_not_converged, {}});
        }
        for (std::size_t k = 0; k < fit_.runs.size(); ++k) {
            const Estimate& drift = fit_.runs[k].drift_hz_per_s;
            if (drift.given() && std::abs(drift.value) > 4 * drift.uncertainty()) {
                fit_.warnings.push_back(
                    {DiagnosticKind::frequency_drifts,
                     {recording_number(k), short_text(drift.value, 3), short_text(drift.sd, 2)}});
            }
        }
        const Estimate& power = fit_.resonator.frequency_per_power;
        if (power.given()) {
            fit_.warnings.push_back({DiagnosticKind::frequency_follows_amplitude,
                                     {short_text(power.value, 3), short_text(power.sd, 2)}});
        }
    }

    std::vector<PhasorRun> runs_;
    std::span<const PhasorRun> fine_;
    std::vector<ScaledRun> scaled_;
    double scale_;
    const FitOptions& options_;
    const JobControl& job_;
    FitProblem problem_;
    MapFit main_;
    Estimate cubic_limit_;
    bool amplitude_or_time_ = false;
    ResonatorFit fit_;
};

// The runs with about `windows` of them each.
std::vector<PhasorRun> merged(std::span<const PhasorRun> runs, std::size_t windows) {
    std::vector<PhasorRun> merged;
    for (const PhasorRun& run : runs) {
        merged.push_back(merge_windows(run, windows));
    }
    return merged;
}

}  // namespace

Result<ResonatorFit> fit_resonator(std::span<const PhasorRun> runs, const FitOptions& options,
                                   const JobControl& job) {
    std::vector<PhasorRun> good;
    for (const PhasorRun& run : runs) {
        good.push_back(usable_windows(run));
        if (good.back().time_s.size() < least_windows) {
            return Error{ErrorCode::fit_too_few_windows,
                         "recording " + std::to_string(good.size()),
                         {integer_text(static_cast<std::int64_t>(good.back().time_s.size())),
                          integer_text(least_windows)}};
        }
    }
    const double scale = largest_amplitude(good);
    if (good.empty() || scale <= 0) {
        return Error{ErrorCode::fit_failed, "the recordings", {"there is no wave"}};
    }
    auto set = std::make_unique<SetFit>(merged(good, enough_windows), good, scale, options, job);
    // Solved again where merged windows were too long for what they gave.
    const NeededWindows needed = set->solve();
    const double windows = std::max(needed.by_motion, needed.by_line);
    if (windows > static_cast<double>(enough_windows)) {
        auto finer = std::make_unique<SetFit>(merged(good, static_cast<std::size_t>(windows) + 1),
                                              good, scale, options, job);
        finer->solve();
        // A line may be a disturbance far from the carrier, which longer windows average out.
        if (needed.by_motion > static_cast<double>(enough_windows) ||
            finer->explains_as_much_as(*set)) {
            set = std::move(finer);
        }
    }
    ResonatorFit fit = set->described();
    if (job.cancelled()) {
        return Error{ErrorCode::interrupted, {}, {}};
    }
    return fit;
}

}  // namespace vybeg
