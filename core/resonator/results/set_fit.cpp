#include "core/resonator/results/set_fit.h"

#include "core/resonator/fit/pencil_start.h"
#include "core/resonator/fit/score_test.h"
#include "core/resonator/noise/noise_claim.h"
#include "core/resonator/results/misfit_cause.h"
#include "core/resonator/results/reported_estimates.h"
#include "core/resonator/results/structured_verdict.h"
#include "core/resonator/runs/merge_windows.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace vybeg {
namespace {

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

std::vector<ScaledRun> whitened_runs(std::span<const PhasorRun> runs, double scale,
                                     std::span<const Eigen::Matrix2d> whitenings) {
    std::vector<ScaledRun> scaled = scaled_runs(runs, scale);
    for (std::size_t k = 0; k < whitenings.size(); ++k) {
        scaled[k].whitening = whitenings[k];
    }
    return scaled;
}

// Windows of a run that are enough: their noise is nearly new from one to the next, as the tests of
// what happened and of what belongs together take it for white.
std::size_t enough_windows_of(const PhasorRun& run) {
    constexpr std::size_t least = 24;
    double apart = 1;  // windows: twice what the noise remembers
    for (std::size_t lag = 1; lag < run.noise_correlation.size(); ++lag) {
        apart += 4 * std::max(run.noise_correlation[lag], 0.0);
    }
    const double separate = static_cast<double>(run.time_s.size()) / apart;
    return std::clamp(static_cast<std::size_t>(separate), least, enough_windows);
}

// The runs with about `windows` of them each, or those that are enough where these are more.
std::vector<PhasorRun> merged(std::span<const PhasorRun> runs, std::size_t windows) {
    std::vector<PhasorRun> merged;
    for (const PhasorRun& run : runs) {
        merged.push_back(merge_windows(run, std::max(windows, enough_windows_of(run))));
    }
    return merged;
}

}  // namespace

double largest_amplitude(std::span<const PhasorRun> runs) {
    double most = 0;
    for (const PhasorRun& run : runs) {
        for (std::size_t k = 0; k < run.c.size(); ++k) {
            most = std::max({most, std::abs(run.c[k]), std::abs(run.d[k])});
        }
    }
    return most;
}

SetFit::SetFit(std::vector<PhasorRun> runs, std::span<const PhasorRun> fine,
               std::span<const Eigen::Matrix2d> whitenings, const FitTask& task,
               const TrialStart& start)
    : runs_(std::move(runs)),
      task_(task),
      problem_(problem_of(whitened_runs(runs_, task.scale, whitenings))),
      set_{.runs = runs_,
           .fine = fine,
           .problem = &problem_,
           .scale = task.scale,
           .tolerance = with_assumed(task.options).tolerance},
      start_(start.p) {
    problem_.priors = structured_priors(problem_.runs, problem_.layout, task_.options.tolerance);
    if (is_trial()) {
        problem_.noise_ratio = std::numeric_limits<double>::infinity();
    }
    for (std::size_t k = 0; k < start.deviation.size(); ++k) {
        problem_.runs[k].deviation = start.deviation[k];
    }
}

TrialStart SetFit::with_room_for(const FittedBreak& found) const {
    Eigen::Index place = problem_.layout.at(found.run, own_count);
    for (const RunBreak& each : problem_.runs[found.run].breaks) {
        place += each.time_s < found.time_s ? break_size(each.kind) : 0;
    }
    const Eigen::VectorXd& p = set_.fit.p;
    TrialStart start{Eigen::VectorXd(p.size() + break_size(found.kind)),
                     examination_.spread.deviation};
    start.p << p.head(place), Eigen::VectorXd::Zero(break_size(found.kind)),
        p.tail(p.size() - place);
    return start;
}

void SetFit::solve() {
    find_main();
    const MapFit plain = set_.fit;
    const Priors plain_priors = problem_.priors;
    try_cubic();
    if (!explained_without_cubic(plain, plain_priors)) {
        polish_cubic();
        if (task_.options.model != FitOptions::Model::free && !is_trial()) {
            examine();
        }
    }
    if (!agrees() && is_of_free_runs()) {
        examination_ = agreeing_set(problem_, set_.fit, task_.options.spread, task_.job);
    }
    if (agrees()) {
        choose_model();
        if (set_.model == ResonatorModel::free) {
            examine();
        }
        set_.fit = refit_in_phase(problem_, set_.fit, task_.job);
    }
}

Eigen::VectorXd SetFit::own_given(const Eigen::VectorXd& shared, std::size_t run) const {
    FitProblem one = part_of(problem_, std::array{run});
    one.priors.mean.head(shared_count) = shared;
    one.priors.sd.head(shared_count).setZero();
    Eigen::VectorXd start(one.layout.size());
    start << shared, own_of(problem_.layout, set_.fit.p, run);
    return own_of(one.layout, minimise(one, start, own_steps, task_.job).p, 0);
}

bool SetFit::explains_as_much_as(const SetFit& other) const {
    const double dof = degrees_of_freedom(problem_);
    const bool structured =
        set_.model == other.set_.model || other.set_.model == ResonatorModel::free;
    return structured && chi2_per_dof() < std::max(1.5 * other.chi2_per_dof(), noise_bound(dof));
}

std::vector<FittedBreak> SetFit::unexplained_breaks() const {
    constexpr double least_share = 0.3;  // of the excess of chi^2 above the noise
    constexpr double least_of_best = 0.5;
    constexpr double close = 16;
    const Posterior at = posterior(problem_, set_.fit);
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
    const double noise = noise_limit(degrees_of_freedom(problem_));
    const bool settles =
        settling > fall && set_.fit.chi2 - settling < std::max(noise, set_.fit.chi2 / 5);
    const std::optional<MisfitCause> smooth =
        misfit_cause(set_, at, Causes::without_lines, task_.job);
    const bool bends = smooth && smooth->fall > fall - close;
    return settles || bends ? std::vector<FittedBreak>{} : likely;
}

bool SetFit::is_white() const {
    if (!at_noise()) {
        return false;
    }
    const Posterior at = posterior(problem_, set_.fit);
    const NoiseEstimate noise(problem_, at, task_.job);
    return noise.as_expected() && noise_claim(noise, at, task_.job).holds;
}

bool SetFit::has_usual_channels() const {
    constexpr double most_tolerances = 3;
    const Priors& priors = problem_.priors;
    return std::ranges::all_of(channel_errors, [&](const ToleratedError& error) {
        const double off = set_.fit.p[error.parameter] - priors.mean[error.parameter];
        return std::abs(off) <= most_tolerances * priors.sd[error.parameter];
    });
}

bool SetFit::explains() const {
    return set_.fit.finished() && !structured_refused_ &&
           examination_.verdict == SetVerdict::fits && at_noise() && has_usual_channels();
}

bool SetFit::may_be_explained_by(const ChannelTolerance& tolerance) const {
    constexpr double near = 2;
    if (set_.model == ResonatorModel::free) {
        return true;
    }
    FitProblem open = problem_;
    for (const ToleratedError& error : channel_errors) {
        open.priors.sd[error.parameter] = tolerance[error.source];
    }
    const MapFit fit = minimise(open, set_.fit.p, own_steps, task_.job);
    return fit.chi2 < near * noise_limit(degrees_of_freedom(open));
}

ResonatorFit SetFit::described() {
    set_.spread = examination_.spread.sd;
    ResonatorFit fit = describe(set_, task_.job);
    fit.free_over_structured = free_over_structured_;
    fit.warnings.insert(fit.warnings.begin(), warnings_.begin(), warnings_.end());
    conclude(examination_, !task_.options.spread, fit);
    return fit;
}

void SetFit::examine() {
    examination_ = examine_set(problem_, set_.fit, task_.options.spread, task_.job);
    // Recordings that disagree look coloured together; noise is coloured in some of them alone,
    // too.
    constexpr double white = 1.3;
    if (examination_.verdict != SetVerdict::fits && examination_.own_noise > white && is_noise()) {
        examination_ = agreeing_set(problem_, set_.fit, task_.options.spread, task_.job);
    }
    if (examination_.verdict == SetVerdict::spread) {
        for (std::size_t k = 0; k < problem_.runs.size(); ++k) {
            problem_.runs[k].deviation = examination_.spread.deviation[k];
        }
        set_.fit = minimise(problem_, examination_.spread.p, cubic_steps, task_.job);
    }
    if (agrees() || examination_.by_channels || set_.model == ResonatorModel::free) {
        return;
    }
    const std::optional<MisfitCause> cause =
        misfit_cause(set_, posterior(problem_, set_.fit), Causes::without_lines, task_.job);
    const double dof = degrees_of_freedom(problem_);
    const double left = cause ? set_.fit.chi2 - cause->fall : set_.fit.chi2;
    // One parameter that explains that much is no chance, unless it takes channels beyond their
    // tolerances.
    constexpr double nearly_all = 0.05;
    if (left < noise_limit(dof) ||
        (examination_.verdict == SetVerdict::refused && has_usual_channels() &&
         left - dof < nearly_all * (set_.fit.chi2 - dof))) {
        examination_ = agreeing_set(problem_, set_.fit, task_.options.spread, task_.job);
    }
}

bool SetFit::is_noise() const {
    const Posterior at = posterior(problem_, set_.fit);
    const NoiseEstimate noise(problem_, at, task_.job);
    return !noise.white() && noise_claim(noise, at, task_.job).holds;
}

void SetFit::find_main() {
    const StillFit wave = is_trial() ? fit_near_start() : fit_waves(problem_, task_.job);
    std::optional<MapFit> still = fit_still_in_phase(problem_, wave.best, task_.job);
    phase_left_ = still.has_value();
    no_motion_ = !still && wave.best.chi2 > hopeless * degrees_of_freedom(problem_) &&
                 is_no_motion(wave.best.p);
    set_.fit =
        still ? *std::move(still)
              : fit_modes(problem_, wave, task_.job, no_motion_ ? Starts::together : Starts::all);
}

StillFit SetFit::fit_near_start() {
    const Priors& known = problem_.priors;
    start_ = (known.sd.array() > 0).select(start_, known.mean);
    const MapFit near = fit_from(problem_, start_, task_.job);
    if (near.chi2 < noise_limit(degrees_of_freedom(problem_))) {
        return {near, {}, {}};
    }
    const Priors priors = problem_.priors;
    StillFit waves = fit_waves(problem_, task_.job);
    if (near.cost < waves.best.cost) {
        waves.best = near;
        problem_.priors = priors;
    }
    return waves;
}

void SetFit::try_cubic() {
    const Posterior at = posterior(problem_, set_.fit);
    const Score score = parameter_score(problem_, at, cubic_at);
    const double dof = degrees_of_freedom(problem_);
    double scale = std::max(1.0, (set_.fit.chi2 - score.fall) / dof);
    set_.cubic_limit = {score.size[0], std::sqrt(score.inverse(0, 0) * scale), {}};
    if (score.fall < cubic_fall * scale / 4) {
        return;
    }
    FitProblem with = problem_;
    open_cubic(with.priors, problem_.runs);
    // A frequency that settles falls with the amplitude, too.
    const double settling = set_.fit.chi2 - settling_score(problem_, at).fall;
    MapFit fit = minimise(with, set_.fit.p, first_cubic_steps, task_.job);
    if (!fit.converged) {
        const double reach = set_.fit.chi2 - fit.chi2 + later_cubic_steps * fit.last_gain;
        if (settling < fit.chi2 / hopeless || reach < cubic_fall * scale) {
            return;
        }
        fit = minimise(with, fit.p, later_cubic_steps, task_.job);
    }
    scale = std::max(1.0, fit.chi2 / degrees_of_freedom(with));
    if (set_.fit.chi2 - fit.chi2 <= cubic_fall * scale) {
        return;
    }
    if (settling < fit.chi2 - cubic_fall * scale) {
        return;
    }
    set_.amplitude_or_time = settling < fit.chi2 + cubic_fall * scale;
    set_.fit = std::move(fit);
    problem_.priors = with.priors;
}

void SetFit::polish_cubic() {
    if (set_.fit.converged || problem_.priors.sd[cubic_at] == 0 || is_trial()) {
        return;
    }
    Eigen::VectorXd anew = still_waves(problem_);
    anew[cubic_at] = set_.fit.p[cubic_at];
    for (const Eigen::VectorXd& start : {set_.fit.p, anew}) {
        MapFit fit = minimise(problem_, start, cubic_steps, task_.job);
        if (fit.cost < set_.fit.cost) {
            set_.fit = std::move(fit);
        }
    }
}

bool SetFit::is_of_free_runs() const {
    if (task_.options.model != FitOptions::Model::automatic || is_trial() || runs_.size() < 2) {
        return false;
    }
    FitProblem free = problem_;
    if (!(fit_freely(free).chi2 < noise_limit(degrees_of_freedom(problem_)))) {
        return false;
    }
    for (std::size_t k = 0; k < runs_.size(); ++k) {
        SetFit alone({runs_[k]}, set_.fine.subspan(k, 1), {}, task_);
        alone.solve();
        if (alone.set_.model != ResonatorModel::free) {
            return false;
        }
    }
    return true;
}

MapFit SetFit::fit_freely(FitProblem& free) const {
    free.priors = free_priors(problem_.runs, problem_.layout);
    Eigen::VectorXd start = set_.fit.p;
    for (const ToleratedError& error : channel_errors) {
        start[error.parameter] = free.priors.mean[error.parameter];
    }
    start[cubic_at] = 0;
    MapFit near = minimise(free, start, 60, task_.job);
    const double dof = degrees_of_freedom(free);
    if (phase_left_ || near.chi2 < noise_limit(dof)) {
        return near;
    }
    // No other start is better than the sum of two modes, and where that is far from the noise, no
    // motion of channels explains the runs.
    constexpr double close = 1.02;
    if (runs_.size() == 1) {
        const std::optional<ModeSum> modes = modes_of(0, near.p);
        if (modes && !(near.chi2 < close * modes->chi2)) {
            Eigen::Matrix2cd shapes;
            shapes << modes->shapes[0], modes->shapes[1];
            if (const auto rates = rates_of_modes({modes->rates[0], modes->rates[1]}, shapes)) {
                MapFit fit = minimise(free, parameters_under(free, *rates), 60, task_.job);
                near = fit.cost < near.cost ? std::move(fit) : std::move(near);
            }
        }
        if (modes && near.chi2 < close * modes->chi2) {
            return near;
        }
    }
    if (no_motion_) {
        return near;
    }
    // Channels with nearly one mixture hide the second mode in a chi^2 of two.
    FitProblem anew = free;
    anew.noise_ratio = noise_bound(dof);
    anew.damping_share = std::numeric_limits<double>::infinity();
    MapFit fit = fit_from_nothing(anew, task_.job);
    return fit.cost < near.cost ? fit : near;
}

void SetFit::choose_model() {
    using Model = FitOptions::Model;
    if (task_.options.model == Model::structured || is_trial()) {
        return;
    }
    FitProblem free = problem_;
    MapFit free_fit = fit_freely(free);
    const StructuredVerdict verdict =
        test_structured(problem_, set_.fit, free, free_fit, task_.options.tolerance, task_.job);
    free_over_structured_ = verdict.free_over_structured;
    if (task_.options.model == Model::automatic && verdict.structured) {
        return;
    }
    if (task_.options.model == Model::automatic) {
        warnings_.push_back({DiagnosticKind::structured_refused, {verdict.reason}});
        structured_refused_ = true;
    }
    set_.model = ResonatorModel::free;
    problem_.priors = std::move(free.priors);
    set_.fit = std::move(free_fit);
}

std::optional<ModeSum> SetFit::modes_of(std::size_t run, const Eigen::VectorXd& p) const {
    const ScaledRun& scaled = problem_.runs[run];
    if (scaled.phase_lost || !scaled.breaks.empty() || !scaled.whitening.isIdentity(0)) {
        return {};
    }
    PhasorRun even = runs_[run];
    const double drift = p[problem_.layout.at(run, drift_at)];
    for (std::size_t k = 0; k < even.time_s.size(); ++k) {
        const double u = even.time_s[k] - scaled.reference_s;
        const std::complex<double> back = std::polar(1.0, -std::numbers::pi * drift * u * u);
        even.c[k] *= back;
        even.d[k] *= back;
    }
    std::optional<ModeSum> with = sum_of_modes(even, 2);
    std::optional<ModeSum> without = sum_of_modes(runs_[run], 2);
    return without && (!with || without->chi2 < with->chi2) ? without : with;
}

bool SetFit::is_no_motion(const Eigen::VectorXd& p) const {
    for (std::size_t k = 0; k < runs_.size() && !task_.job.cancelled(); ++k) {
        const std::optional<ModeSum> modes = modes_of(k, p);
        if (modes && modes->chi2 > hopeless * modes->freedom) {
            return true;
        }
    }
    return false;
}

bool SetFit::explained_without_cubic(const MapFit& plain, const Priors& plain_priors) {
    const bool opened = problem_.priors.sd[cubic_at] > plain_priors.sd[cubic_at];
    if (!opened || problem_.runs.size() < 2 || task_.options.model == FitOptions::Model::free ||
        is_trial() || runs_agree(problem_, set_.fit.p)) {
        return false;
    }
    const MapFit with = std::exchange(set_.fit, plain);
    const Priors with_priors = std::exchange(problem_.priors, plain_priors);
    examine();
    const double least = examination_.verdict == SetVerdict::foreign  ? examination_.cost
                         : examination_.verdict == SetVerdict::spread ? set_.fit.cost
                                                                      : with.cost;
    if (least < with.cost - cubic_fall && least < noise_limit(degrees_of_freedom(problem_))) {
        set_.amplitude_or_time = false;
        return true;
    }
    set_.fit = with;
    problem_.priors = with_priors;
    examination_ = {};
    for (ScaledRun& run : problem_.runs) {
        run.deviation.setZero();
    }
    return false;
}

std::unique_ptr<SetFit> solved_set(const std::vector<PhasorRun>& good, const FitTask& task,
                                   const TrialStart& start) {
    // More than this costs minutes and is beyond the band of the recorded windows anyway.
    constexpr double most_windows = 4000;
    std::vector<Eigen::Matrix2d> whitenings;
    const auto solve_once = [&](const std::vector<PhasorRun>& runs) {
        auto set = std::make_unique<SetFit>(runs, good, whitenings, task, start);
        set->solve();
        return set;
    };
    const auto solve = [&](const std::vector<PhasorRun>& runs) {
        auto set = solve_once(runs);
        // What a fit this far from the noise leaves does not show the noise.
        if (!whitenings.empty() || set->chi2_per_dof() > hopeless) {
            return set;
        }
        whitenings = vybeg::whitenings(set->motion(), good);
        const bool white =
            std::ranges::all_of(whitenings, [](const auto& one) { return one.isIdentity(0); });
        return white ? std::move(set) : solve_once(runs);
    };
    const std::vector<PhasorRun> runs = merged(good, 0);
    const auto are_enough = [&good](double windows) {
        return std::ranges::all_of(good, [windows](const PhasorRun& run) {
            return !(windows > static_cast<double>(enough_windows_of(run)));
        });
    };
    std::unique_ptr<SetFit> coarse = solve(runs);
    const NeededWindows needed = coarse->needed();
    const double windows = std::min(std::max(needed.by_motion, needed.by_line), most_windows);
    if (are_enough(windows) || task.job.cancelled()) {
        return coarse;
    }
    const std::vector<PhasorRun> finer = merged(good, static_cast<std::size_t>(windows) + 1);
    const auto windows_of = [](const PhasorRun& run) { return run.time_s.size(); };
    if (std::ranges::equal(runs, finer, {}, windows_of, windows_of)) {
        return coarse;
    }
    // A line may be a disturbance far from the carrier, which longer windows suppress.
    const bool by_motion = !are_enough(needed.by_motion);
    std::unique_ptr<SetFit> fine = solve(finer);
    return by_motion || fine->explains_as_much_as(*coarse) ? std::move(fine) : std::move(coarse);
}

}  // namespace vybeg
