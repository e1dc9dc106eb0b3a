#include "core/resonator/results/resonator_fit.h"

#include "core/base/number_text.h"
#include "core/resonator/fit/fit_start.h"
#include "core/resonator/fit/phase_break.h"
#include "core/resonator/fit/refit_in_phase.h"
#include "core/resonator/fit/score_test.h"
#include "core/resonator/results/describe_fit.h"
#include "core/resonator/results/given_or_refused.h"
#include "core/resonator/results/misfit_cause.h"
#include "core/resonator/results/run_parameters.h"
#include "core/resonator/results/set_examination.h"
#include "core/resonator/results/structured_verdict.h"
#include "core/resonator/runs/merge_windows.h"
#include "core/resonator/runs/needed_windows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>

namespace vybeg {
namespace {

// Least number of windows of a run: 32 numbers for its four to six own parameters.
constexpr std::size_t least_windows = 8;
// Windows of a run after merging, if its motion within a window allows; the time of the fit grows
// with their number.
constexpr std::size_t enough_windows = 150;
// Least fall of chi^2 for which a dependence of the frequency on the amplitude is fitted.
constexpr double cubic_fall = 25;
constexpr int cubic_steps = 200;
// A fit is abandoned after the first steps if its chi^2 is this many times that of a settling
// frequency, or if it falls so slowly that the remaining steps would not show the term.
constexpr int first_cubic_steps = 8;
constexpr int later_cubic_steps = 60;
constexpr int own_steps = 40;
constexpr double hopeless = 100;

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

// The whole fit of one set, step by step.
class SetFit {
public:
    // `fine`: the runs before merging of windows.
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

    // Finds the most likely parameters; returns the number of windows of a run that they need.
    NeededWindows solve() {
        find_main();
        try_cubic();
        if (options_.model != FitOptions::Model::free) {
            examine();
        }
        if (agrees()) {
            choose_model();
            if (model_ == ResonatorModel::free) {
                examine();
            }
            main_ = refit_in_phase(problem_, main_, job_);
        }
        return needed_windows(motion_of(solved()), fine_);
    }

    const SetExamination& examination() const { return examination_; }

    // Whether the runs are those of one resonator.
    bool agrees() const {
        return examination_.verdict == SetVerdict::fits ||
               examination_.verdict == SetVerdict::spread;
    }

    // A run's own parameters that fit it best with the shared ones of another set.
    Eigen::VectorXd own_given(const Eigen::VectorXd& shared, std::size_t run) const {
        FitProblem one = part_of(problem_, std::array{run}, problem_.runs.subspan(run, 1));
        one.priors.mean.head(shared_count) = shared;
        one.priors.sd.head(shared_count).setZero();
        Eigen::VectorXd start(one.layout.size());
        start << shared, own_of(problem_.layout, main_.p, run);
        return own_of(one.layout, minimise(one, start, own_steps, job_).p, 0);
    }

    // Whether this solution explains its windows about as well as `other`.
    bool explains_as_much_as(const SetFit& other) const {
        const double dof = degrees_of_freedom(problem_);
        const bool structured = model_ == other.model_ || other.model_ == ResonatorModel::free;
        return structured &&
               chi2_per_dof() < std::max(1.5 * other.chi2_per_dof(), noise_bound(dof));
    }

    double chi2() const { return main_.chi2; }
    double chi2_per_dof() const { return main_.chi2 / degrees_of_freedom(problem_); }
    bool at_noise() const { return chi2_per_dof() < noise_bound(degrees_of_freedom(problem_)); }

    // Step of a run's phase that explains more of the residual than a settling frequency.
    std::optional<PhaseBreak> unexplained_break() const {
        if (at_noise()) {
            return {};
        }
        const Posterior at = posterior(problem_, main_);
        const std::optional<PhaseBreak> found = phase_break(problem_, at);
        if (!found) {
            return {};
        }
        const double settling = settling_score(problem_, at).fall;
        const double dof = degrees_of_freedom(problem_);
        const bool settles =
            settling > found->fall &&
            main_.chi2 - settling < std::max(noise_bound(dof) * dof, main_.chi2 / 5);
        return settles ? std::nullopt : found;
    }

    // Step of a run's phase at the break at `time_s`, rad in (-pi, pi]; none if no window lies
    // after it.
    std::optional<double> step_at(std::size_t run, double time_s) const {
        const std::vector<double>& breaks = scaled_[run].breaks_s;
        const auto found = std::ranges::find(breaks, time_s);
        if (found == breaks.end()) {
            return {};
        }
        const auto place = found - breaks.begin();
        return std::remainder(own_of(problem_.layout, main_.p, run)[own_count + place],
                              2 * std::numbers::pi);
    }

    FittedMotion motion() const { return motion_of(solved()); }

    // Results of the present parameters.
    ResonatorFit described() const {
        ResonatorFit fit = describe(solved(), job_);
        fit.free_over_structured = free_over_structured_;
        fit.warnings.insert(fit.warnings.begin(), warnings_.begin(), warnings_.end());
        SetExamination told = examination_;
        if (!agrees()) {
            refuse_all({ReasonCode::set_refused, {}}, fit);
            told.verdict = told.verdict == SetVerdict::foreign ? SetVerdict::several : told.verdict;
        }
        const std::vector<Diagnostic> findings = findings_of(told, runs_.size());
        fit.warnings.insert(fit.warnings.begin(), findings.begin(), findings.end());
        return fit;
    }

private:
    static ParameterLayout layout_of(const std::vector<ScaledRun>& runs) {
        std::vector<std::size_t> breaks;
        for (const ScaledRun& run : runs) {
            breaks.push_back(run.breaks_s.size());
        }
        return ParameterLayout(breaks);
    }

    SolvedSet solved() const {
        ChannelTolerance tolerance = options_.tolerance;
        for (const ChannelError& error : channel_errors) {
            double& size = tolerance.*error.tolerance;
            size = size > 0 ? size : options_.assumed.*error.tolerance;
        }
        return {runs_,
                fine_,
                &problem_,
                main_,
                model_,
                scale_,
                cubic_limit_,
                amplitude_or_time_,
                examination_.spread,
                tolerance};
    }

    // Whether the set is one at all. A cause common to all runs that leaves only noise is named
    // instead; nearly so where no single run makes the difference.
    void examine() {
        examination_ = examine_set(problem_, main_, job_);
        if (examination_.verdict == SetVerdict::spread) {
            for (std::size_t k = 0; k < scaled_.size(); ++k) {
                scaled_[k].deviation = examination_.deviation[k];
            }
            main_ = minimise(problem_, examination_.p, cubic_steps, job_);
        }
        if (agrees() || model_ == ResonatorModel::free) {
            return;
        }
        const std::optional<MisfitCause> cause =
            misfit_cause(problem_, posterior(problem_, main_), fine_, scale_);
        const double dof = degrees_of_freedom(problem_);
        const double left = cause ? main_.chi2 - cause->fall : main_.chi2;
        // One parameter that explains that much is no chance.
        constexpr double nearly_all = 0.05;
        if (left < noise_bound(dof) * dof || (examination_.verdict == SetVerdict::refused &&
                                              left - dof < nearly_all * (main_.chi2 - dof))) {
            examination_ = {};
        }
    }

    void find_main() {
        const WaveFit wave = fit_waves(problem_, job_);
        std::optional<MapFit> still = fit_still_in_phase(problem_, wave.best, job_);
        phase_left_ = still.has_value();
        main_ = still ? *std::move(still) : fit_modes(problem_, wave, job_);
    }

    // Opens a dependence of the frequency on the amplitude only if the data require it, because
    // elliptic waves would otherwise lose their rotation.
    void try_cubic() {
        const Posterior at = posterior(problem_, main_);
        const Score score = cubic_score(problem_, at);
        const double dof = degrees_of_freedom(problem_);
        double scale = std::max(1.0, (main_.chi2 - score.fall) / dof);
        cubic_limit_ = {score.size[0], std::sqrt(score.inverse(0, 0) * scale), {}};
        if (score.fall < cubic_fall * scale / 4) {
            return;
        }
        FitProblem with = problem_;
        open_cubic(with.priors, scaled_);
        // A frequency that settles falls with the amplitude, too.
        const double settling = main_.chi2 - settling_score(problem_, at).fall;
        MapFit fit = minimise(with, main_.p, first_cubic_steps, job_);
        if (!fit.converged) {
            const double reach = main_.chi2 - fit.chi2 + later_cubic_steps * fit.last_gain;
            if (settling < fit.chi2 / hopeless || reach < cubic_fall * scale) {
                return;
            }
            fit = minimise(with, fit.p, later_cubic_steps, job_);
        }
        scale = std::max(1.0, fit.chi2 / degrees_of_freedom(with));
        if (main_.chi2 - fit.chi2 <= cubic_fall * scale) {
            return;
        }
        if (settling < fit.chi2 - cubic_fall * scale) {
            return;
        }
        amplitude_or_time_ = settling < fit.chi2 + cubic_fall * scale;
        main_ = std::move(fit);
        problem_.priors = with.priors;
        polish_cubic();
    }

    // Without the cubic term the other parameters compensated for it and are far from their values.
    // The fit needs many steps, or a new start at still waves.
    void polish_cubic() {
        if (main_.converged) {
            return;
        }
        Eigen::VectorXd anew = still_waves(problem_);
        anew[cubic_at] = main_.p[cubic_at];
        for (const Eigen::VectorXd& start : {main_.p, anew}) {
            MapFit fit = minimise(problem_, start, cubic_steps, job_);
            if (fit.cost < main_.cost) {
                main_ = std::move(fit);
            }
        }
    }

    void choose_model() {
        using Model = FitOptions::Model;
        if (options_.model == Model::structured) {
            return;
        }
        FitProblem free = problem_;
        free.priors = free_priors(scaled_, problem_.layout);
        Eigen::VectorXd start = main_.p;
        for (const ChannelError& error : channel_errors) {
            start[error.parameter] = free.priors.mean[error.parameter];
        }
        start[cubic_at] = 0;
        MapFit free_fit = fit_near_or_from_nothing(free, start);
        const StructuredVerdict verdict =
            test_structured(problem_, main_, free, free_fit, options_.tolerance, job_);
        free_over_structured_ = verdict.free_over_structured;
        if (options_.model == Model::automatic && verdict.structured) {
            return;
        }
        if (options_.model == Model::automatic) {
            warnings_.push_back({DiagnosticKind::structured_refused, {verdict.reason}});
        }
        model_ = ResonatorModel::free;
        problem_.priors = std::move(free.priors);
        main_ = std::move(free_fit);
    }

    // The free model has no cubic term, because |z|^2 of channels of unknown scale beats.
    MapFit fit_near_or_from_nothing(FitProblem& problem, const Eigen::VectorXd& start) const {
        MapFit near = minimise(problem, start, 60, job_);
        const double dof = degrees_of_freedom(problem);
        const double ratio = noise_bound(dof);
        if (phase_left_ || near.chi2 < ratio * dof) {
            return near;
        }
        // Channels with nearly one mixture hide the second mode in a chi^2 of two.
        FitProblem anew = problem;
        anew.noise_ratio = ratio;
        anew.damping_share = std::numeric_limits<double>::infinity();
        MapFit fit = fit_from_nothing(anew, job_);
        return fit.cost < near.cost ? fit : near;
    }

    std::vector<PhasorRun> runs_;
    std::span<const PhasorRun> fine_;
    std::vector<ScaledRun> scaled_;
    double scale_;
    const FitOptions& options_;
    const JobControl& job_;
    FitProblem problem_;
    MapFit main_;
    bool phase_left_ = false;  // still waves explain everything except the phase
    SetExamination examination_;
    Estimate cubic_limit_;
    bool amplitude_or_time_ = false;
    ResonatorModel model_{};
    double free_over_structured_ = 0;
    std::vector<Diagnostic> warnings_;
};

// The runs with about `windows` of them each.
std::vector<PhasorRun> merged(std::span<const PhasorRun> runs, std::size_t windows) {
    std::vector<PhasorRun> merged;
    for (const PhasorRun& run : runs) {
        merged.push_back(merge_windows(run, windows));
    }
    return merged;
}

// The set with as many windows of a run as its solution needs.
std::unique_ptr<SetFit> solved_set(const std::vector<PhasorRun>& good, double scale,
                                   const FitOptions& options, const JobControl& job) {
    auto set = std::make_unique<SetFit>(merged(good, enough_windows), good, scale, options, job);
    const NeededWindows needed = set->solve();
    const double windows = std::max(needed.by_motion, needed.by_line);
    if (windows > static_cast<double>(enough_windows)) {
        auto finer = std::make_unique<SetFit>(merged(good, static_cast<std::size_t>(windows) + 1),
                                              good, scale, options, job);
        finer->solve();
        // A line may be a disturbance far from the carrier, which longer windows suppress.
        if (needed.by_motion > static_cast<double>(enough_windows) ||
            finer->explains_as_much_as(*set)) {
            return finer;
        }
    }
    return set;
}

struct OpenedPhases {
    std::vector<PhasorRun> runs;
    std::vector<PhaseBreak> breaks;
    std::unique_ptr<SetFit> set;  // of the runs; null if no break explains the residual
};

// Opens the phase at a step. Beating modes also determine the number of samples; numbers with the
// phase of the step are tried.
void open_phase(OpenedPhases& opened, PhaseBreak step, double scale, const FitOptions& options,
                const JobControl& job) {
    constexpr double clear_fall = 9;
    const PhasorRun before = opened.runs[step.run];
    std::vector<int> numbers = possible_samples(step, before.f_ref_hz, before.rate_hz);
    numbers.insert(numbers.begin(), 0);
    OpenedPhases best;
    for (const int samples : numbers) {
        step.shift_s = samples == 0 ? 0 : samples / before.rate_hz;
        // A set keeps references to its runs.
        OpenedPhases next{opened.runs, opened.breaks, {}};
        next.runs[step.run] = with_break(before, step);
        next.set = solved_set(next.runs, scale, options, job);
        next.breaks.push_back(step);
        const double needed = clear_fall * std::max(1.0, next.set->chi2_per_dof());
        if (!best.set || next.set->chi2() < best.set->chi2() - needed) {
            best = std::move(next);
        }
    }
    opened = std::move(best);
}

// The set with open phases at steps. One step must explain nearly all of the residual, several must
// leave only noise; a weaker condition would find steps in any wandering phase.
OpenedPhases with_open_phases(const std::vector<PhasorRun>& good, const SetFit& closed,
                              double scale, const FitOptions& options, const JobControl& job) {
    constexpr std::size_t most_breaks = 4;
    constexpr double nearly_none = 0.2;
    std::optional<PhaseBreak> step = closed.unexplained_break();
    if (!step) {
        return {};
    }
    OpenedPhases opened{good, {}, {}};
    while (step) {
        open_phase(opened, *step, scale, options, job);
        const bool full = opened.breaks.size() == most_breaks;
        step = full ? std::nullopt : opened.set->unexplained_break();
    }
    const bool most = opened.breaks.size() == 1 &&
                      opened.set->chi2_per_dof() - 1 < nearly_none * (closed.chi2_per_dof() - 1);
    if (most || opened.set->at_noise()) {
        return opened;
    }
    return {};
}

// Leaves out the run that does not belong to the set, if the others agree; returns the set with it,
// else null.
std::unique_ptr<SetFit> without_foreign(std::vector<PhasorRun>& runs, std::unique_ptr<SetFit>& set,
                                        double scale, const FitOptions& options,
                                        const JobControl& job) {
    if (set->examination().verdict != SetVerdict::foreign || runs.size() < 3) {
        return nullptr;
    }
    std::vector<PhasorRun> others = runs;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(set->examination().foreign.front()));
    std::unique_ptr<SetFit> rest = solved_set(others, scale, options, job);
    if (!rest->agrees()) {
        return nullptr;
    }
    // The sets refer to their runs, which stay where they are.
    std::swap(set, rest);
    std::swap(runs, others);
    return rest;
}

// The results of a set without its foreign run, with a place for that run.
void add_foreign(const SetFit& whole, std::size_t count, ResonatorFit& fit) {
    const SetExamination& examination = whole.examination();
    const std::size_t out = examination.foreign.front();
    std::vector<MessageArg> numbers;
    for (std::size_t k = 0; k < count; ++k) {
        if (k != out) {
            numbers.push_back(recording_arg(k));
        }
    }
    for (Diagnostic& warning : fit.warnings) {
        name_recordings(numbers, warning.args);
    }
    for (PhaseBreak& step : fit.phase_breaks) {
        step.run += step.run >= out ? 1 : 0;
    }
    const std::vector<Diagnostic> findings = findings_of(examination, count);
    fit.warnings.insert(fit.warnings.begin(), findings.begin(), findings.end());
    const auto at = static_cast<std::ptrdiff_t>(out);
    RunEstimate none;
    for (const RunParameter& parameter : run_parameters) {
        none.*parameter.member = Estimate{.reason = {ReasonCode::left_out, {}}};
    }
    fit.runs.insert(fit.runs.begin() + at, none);
    FittedMotion::Run motion = whole.motion().runs[out];
    motion.own = whole.own_given(fit.motion.shared, out);
    fit.motion.runs.insert(fit.motion.runs.begin() + at, std::move(motion));
    fit.left_out = out;
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
        return Error{ErrorCode::fit_failed,
                     "the recordings",
                     {words(VYBEG_MESSAGE("Words", "there is no wave"))}};
    }
    std::unique_ptr<SetFit> set = solved_set(good, scale, options, job);
    const std::unique_ptr<SetFit> whole = without_foreign(good, set, scale, options, job);
    OpenedPhases opened;
    if (set->agrees()) {
        opened = with_open_phases(good, *set, scale, options, job);
    }
    if (opened.set) {
        set = std::move(opened.set);
    }
    ResonatorFit fit = set->described();
    for (PhaseBreak& step : opened.breaks) {
        step.step_rad = set->step_at(step.run, step.time_s).value_or(step.step_rad);
        fit.warnings.push_back(
            {DiagnosticKind::fitted_phase_step,
             {recording_arg(step.run), number_arg(step.step_rad, 3), number_arg(step.time_s, 4)}});
    }
    fit.phase_breaks = std::move(opened.breaks);
    if (whole) {
        add_foreign(*whole, runs.size(), fit);
    }
    if (job.cancelled()) {
        return Error{ErrorCode::interrupted, {}, {}};
    }
    return fit;
}

}  // namespace vybeg
