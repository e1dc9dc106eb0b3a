#include "core/resonator/results/resonator_fit.h"

#include "core/base/number_text.h"
#include "core/resonator/fit/fit_start.h"
#include "core/resonator/fit/fitted_break.h"
#include "core/resonator/fit/refit_in_phase.h"
#include "core/resonator/fit/score_test.h"
#include "core/resonator/noise/noise_claim.h"
#include "core/resonator/results/describe_fit.h"
#include "core/resonator/results/given_or_refused.h"
#include "core/resonator/results/misfit_cause.h"
#include "core/resonator/results/run_parameters.h"
#include "core/resonator/results/set_examination.h"
#include "core/resonator/results/structured_verdict.h"
#include "core/resonator/runs/channel_noise.h"
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

std::vector<ScaledRun> scaled_runs(std::span<const PhasorRun> runs, double scale,
                                   std::span<const Eigen::Matrix2d> whitenings) {
    std::vector<ScaledRun> scaled;
    for (const PhasorRun& run : runs) {
        scaled.push_back(scaled_run(run, scale));
        if (!whitenings.empty()) {
            scaled.back().whitening = whitenings[scaled.size() - 1];
        }
    }
    return scaled;
}

// A trial of a break takes neither further starts nor the free model.
enum class Effort { whole, trial };

// The whole fit of one set, step by step.
class SetFit {
public:
    // `fine`: the runs before merging of windows; `whitenings` of channel_noise.h, empty: none.
    SetFit(std::vector<PhasorRun> runs, std::span<const PhasorRun> fine, double scale,
           std::span<const Eigen::Matrix2d> whitenings, const FitOptions& options,
           const JobControl& job, Effort effort)
        : runs_(std::move(runs)),
          fine_(fine),
          scaled_(scaled_runs(runs_, scale, whitenings)),
          scale_(scale),
          options_(options),
          job_(job),
          effort_(effort),
          problem_{scaled_, layout_of(scaled_), {}} {
        problem_.priors = structured_priors(scaled_, problem_.layout, options.tolerance);
        if (effort == Effort::trial) {
            problem_.noise_ratio = std::numeric_limits<double>::infinity();
        }
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

    double chi2_per_dof() const { return main_.chi2 / degrees_of_freedom(problem_); }
    bool at_noise() const { return chi2_per_dof() < noise_bound(degrees_of_freedom(problem_)); }

    // Those of the noise beside this solution.
    std::vector<Eigen::Matrix2d> noise_whitenings() const {
        return whitenings(motion_of(solved()), fine_);
    }

    double excess() const { return main_.chi2 - degrees_of_freedom(problem_); }

    // Breaks, one of a kind, that may explain the residual; none if something smooth explains it as
    // well.
    std::vector<FittedBreak> unexplained_breaks() const {
        constexpr double least_share = 0.3;  // of the excess of chi^2 above the noise
        constexpr double least_of_best = 0.5;
        constexpr double close = 16;
        const Posterior at = posterior(problem_, main_);
        std::vector<FittedBreak> likely = likely_breaks(problem_, at);
        double most = at_noise() ? 0 : least_share * excess();
        for (const FittedBreak& each : likely) {
            most = std::max(most, least_of_best * each.fall);
        }
        std::erase_if(likely, [&](const FittedBreak& each) { return !(each.fall > most); });
        if (likely.empty()) {
            return {};
        }
        const double fall = std::ranges::max(likely, {}, &FittedBreak::fall).fall;
        const double settling = settling_score(problem_, at).fall;
        const double dof = degrees_of_freedom(problem_);
        const bool settles =
            settling > fall &&
            main_.chi2 - settling < std::max(noise_bound(dof) * dof, main_.chi2 / 5);
        const std::optional<MisfitCause> smooth =
            misfit_cause(problem_, at, fine_, scale_, Causes::without_lines, job_);
        const bool bends = smooth && smooth->fall > fall - close;
        return settles || bends ? std::vector<FittedBreak>{} : likely;
    }

    // Whether the residual is the noise of the windows, of their colour too.
    bool is_white() const {
        return at_noise() &&
               NoiseEstimate(problem_, posterior(problem_, main_), job_).noise().as_expected();
    }

    std::array<double, 2> size_of(const FittedBreak& each) const {
        return fitted_size(problem_, main_.p, each);
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
        const std::vector<Diagnostic> findings = set_findings(told, !options_.spread);
        fit.warnings.insert(fit.warnings.begin(), findings.begin(), findings.end());
        return fit;
    }

private:
    static ParameterLayout layout_of(const std::vector<ScaledRun>& runs) {
        std::vector<std::size_t> breaks;
        breaks.reserve(runs.size());
        for (const ScaledRun& run : runs) {
            breaks.push_back(run.break_parameters());
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
        examination_ = examine_set(problem_, main_, options_.spread, job_);
        if (examination_.verdict != SetVerdict::fits && is_noise()) {
            examination_ = {};
        }
        if (examination_.verdict == SetVerdict::spread) {
            for (std::size_t k = 0; k < scaled_.size(); ++k) {
                scaled_[k].deviation = examination_.deviation[k];
            }
            main_ = minimise(problem_, examination_.p, cubic_steps, job_);
        }
        if (agrees() || model_ == ResonatorModel::free) {
            return;
        }
        const std::optional<MisfitCause> cause = misfit_cause(
            problem_, posterior(problem_, main_), fine_, scale_, Causes::without_lines, job_);
        const double dof = degrees_of_freedom(problem_);
        const double left = cause ? main_.chi2 - cause->fall : main_.chi2;
        // One parameter that explains that much is no chance.
        constexpr double nearly_all = 0.05;
        if (left < noise_bound(dof) * dof || (examination_.verdict == SetVerdict::refused &&
                                              left - dof < nearly_all * (main_.chi2 - dof))) {
            examination_ = {};
        }
    }

    // Whether the residual is a coloured noise, the same in both halves of all runs: slow noise
    // moves the runs apart more than white noise of their windows.
    bool is_noise() const {
        const Posterior at = posterior(problem_, main_);
        const NoiseEstimate noise(problem_, at, job_);
        return !noise.noise().white() && noise_claim(noise, at, job_).holds();
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
        if (options_.model == Model::structured || effort_ == Effort::trial) {
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
    Effort effort_;
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
                                   const FitOptions& options, const JobControl& job,
                                   Effort effort = Effort::whole) {
    const auto fit_of = [&](std::size_t windows, std::span<const Eigen::Matrix2d> by) {
        return std::make_unique<SetFit>(merged(good, windows), good, scale, by, options, job,
                                        effort);
    };
    std::unique_ptr<SetFit> set = fit_of(enough_windows, {});
    NeededWindows needed = set->solve();
    const std::vector<Eigen::Matrix2d> by = set->noise_whitenings();
    if (std::ranges::any_of(by, [](const auto& one) { return !one.isIdentity(0); })) {
        set = fit_of(enough_windows, by);
        needed = set->solve();
    }
    // More than this costs minutes and is beyond the band of the recorded windows anyway.
    constexpr double most_windows = 4000;
    const double windows = std::min(std::max(needed.by_motion, needed.by_line), most_windows);
    if (windows > static_cast<double>(enough_windows) && !job.cancelled()) {
        std::unique_ptr<SetFit> finer = fit_of(static_cast<std::size_t>(windows) + 1, by);
        finer->solve();
        // A line may be a disturbance far from the carrier, which longer windows suppress.
        if (needed.by_motion > static_cast<double>(enough_windows) ||
            finer->explains_as_much_as(*set)) {
            return finer;
        }
    }
    return set;
}

struct OpenedBreaks {
    std::vector<PhasorRun> runs;
    std::vector<FittedBreak> breaks;
    std::unique_ptr<SetFit> set;  // of the runs; null if no break explains the residual
};

// Fits the set with each of the breaks; the fewest parameters that explain as much are kept.
// Beating modes also determine a number of samples; numbers with the phase of a step are tried.
OpenedBreaks open_break(const OpenedBreaks& opened, std::span<const FittedBreak> likely,
                        double scale, const FitOptions& options, const JobControl& job) {
    constexpr double price = 9;  // chi^2 that a parameter must explain
    OpenedBreaks best;
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](const FittedBreak& found, double parameters) {
        // A set keeps references to its runs.
        OpenedBreaks next{opened.runs, opened.breaks, {}};
        next.runs[found.run] = with_break(opened.runs[found.run], found);
        if (next.runs[found.run].time_s.size() < least_windows || job.cancelled()) {
            return;
        }
        next.set = solved_set(next.runs, scale, options, job, Effort::trial);
        next.breaks.push_back(found);
        const double cost =
            next.set->excess() + price * parameters * std::max(1.0, next.set->chi2_per_dof());
        if (cost < least) {
            least = cost;
            best = std::move(next);
        }
    };
    for (FittedBreak found : likely) {
        consider(found, break_size(found.kind));
        if (found.kind != BreakKind::phase) {
            continue;
        }
        const PhasorRun& run = opened.runs[found.run];
        for (const int samples : possible_samples(found.size[0], run.f_ref_hz, run.rate_hz)) {
            found.shift_s = samples / run.rate_hz;
            consider(found, break_size(found.kind) + 1);
        }
    }
    if (best.set) {
        best.set = solved_set(best.runs, scale, options, job);
    }
    return best;
}

// The set with breaks. One break must explain nearly all of the residual, several must leave only
// noise; a weaker condition would find breaks in any wandering phase.
OpenedBreaks with_breaks(const std::vector<PhasorRun>& good, const SetFit& closed, double scale,
                         const FitOptions& options, const JobControl& job) {
    constexpr std::size_t most_breaks = 4;
    constexpr double nearly_none = 0.2;
    OpenedBreaks opened{good, {}, {}};
    std::vector<FittedBreak> likely = closed.unexplained_breaks();
    while (!likely.empty() && opened.breaks.size() < most_breaks && !job.cancelled()) {
        OpenedBreaks next = open_break(opened, likely, scale, options, job);
        constexpr double halved = 0.6;
        const SetFit& before = opened.set ? *opened.set : closed;
        if (!next.set || (!next.set->at_noise() && next.set->excess() > halved * before.excess())) {
            break;
        }
        opened = std::move(next);
        likely = opened.set->unexplained_breaks();
    }
    if (!opened.set) {
        return {};
    }
    const bool most = opened.breaks.size() == 1 &&
                      opened.set->excess() < nearly_none * closed.excess() && !closed.at_noise();
    return most || opened.set->is_white() ? std::move(opened) : OpenedBreaks{};
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
    for (FittedBreak& each : fit.breaks) {
        each.run += each.run >= out ? 1 : 0;
    }
    const std::vector<Diagnostic> findings = set_findings(examination, false);
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
    OpenedBreaks opened;
    if (set->agrees()) {
        opened = with_breaks(good, *set, scale, options, job);
    }
    if (opened.set) {
        set = std::move(opened.set);
    }
    ResonatorFit fit = set->described();
    for (FittedBreak& each : opened.breaks) {
        each.size = set->size_of(each);
        fit.warnings.push_back(break_finding(each));
    }
    fit.breaks = std::move(opened.breaks);
    if (whole) {
        add_foreign(*whole, runs.size(), fit);
    }
    if (job.cancelled()) {
        return Error{ErrorCode::interrupted, {}, {}};
    }
    return fit;
}

}  // namespace vybeg
