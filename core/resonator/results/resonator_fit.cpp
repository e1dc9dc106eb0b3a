#include "core/resonator/results/resonator_fit.h"

#include "core/resonator/results/resonator_parameters.h"
#include "core/resonator/results/set_fit.h"
#include "core/resonator/runs/merge_windows.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace vybeg {
namespace {

// Least number of windows of a run: 32 numbers for its four to six own parameters.
constexpr std::size_t least_windows = 8;

struct OpenedBreaks {
    std::vector<PhasorRun> runs;
    std::vector<FittedBreak> breaks;
    std::unique_ptr<SetFit> set;  // of the runs; null if no break explains the residual
};

// Fits the set with each of the breaks; the fewest parameters that explain as much are kept.
// Beating modes also determine a number of samples; numbers with the phase of a step are tried.
// `before`: the set without them.
OpenedBreaks open_break(const OpenedBreaks& opened, const SetFit& before,
                        std::span<const FittedBreak> likely, const FitTask& task) {
    constexpr double price = 9;  // chi^2 that a parameter must explain
    OpenedBreaks best;
    double least = std::numeric_limits<double>::infinity();
    // Returns the size with which the break is fitted.
    const auto consider = [&](const FittedBreak& found, double parameters) {
        // A set keeps references to its runs.
        OpenedBreaks next{opened.runs, opened.breaks, {}};
        next.runs[found.run] = with_break(opened.runs[found.run], found);
        if (next.runs[found.run].time_s.size() < least_windows || task.job.cancelled()) {
            return found.size[0];
        }
        // Still waves do not lead to a fast beat.
        next.set = solved_set(next.runs, task, before.with_room_for(found));
        next.breaks.push_back(found);
        const double size = next.set->size_of(found)[0];
        const double cost =
            next.set->excess() + price * parameters * std::max(1.0, next.set->chi2_per_dof());
        if (cost < least) {
            least = cost;
            best = std::move(next);
        }
        return size;
    };
    for (FittedBreak found : likely) {
        // That by the score is far off where the fit without the break has followed the step.
        const double step_rad = consider(found, break_size(found.kind));
        if (found.kind != BreakKind::phase) {
            continue;
        }
        const PhasorRun& run = opened.runs[found.run];
        for (const int samples : possible_samples(step_rad, run.f_ref_hz, run.rate_hz)) {
            found.shift_s = samples / run.rate_hz;
            consider(found, break_size(found.kind) + 1);
        }
    }
    if (best.set) {
        best.set = solved_set(best.runs, task);
    }
    return best;
}

// The set with breaks. One break must explain nearly all of the residual, several must leave only
// noise; a weaker condition would find breaks in any wandering phase.
OpenedBreaks with_breaks(const std::vector<PhasorRun>& good, const SetFit& closed,
                         const FitTask& task) {
    constexpr std::size_t most_breaks = 4;
    constexpr double nearly_none = 0.2;
    OpenedBreaks opened{good, {}, {}};
    std::vector<FittedBreak> likely = closed.unexplained_breaks();
    while (!likely.empty() && opened.breaks.size() < most_breaks && !task.job.cancelled()) {
        const SetFit& before = opened.set ? *opened.set : closed;
        OpenedBreaks next = open_break(opened, before, likely, task);
        constexpr double halved = 0.6;
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

// Breaks that each run of a set shows alone, in the runs as well: a large one makes a run foreign
// to its set, whose fit then does not see it, and one in each of two runs makes another one
// foreign. Of a large set, those of the suspects.
std::vector<FittedBreak> open_own_breaks(const SetExamination& examination,
                                         std::vector<PhasorRun>& runs, const FitTask& task) {
    constexpr std::size_t small = 8;
    std::vector<std::size_t> suspects = examination.foreign;
    if (runs.size() <= small) {
        suspects.resize(runs.size());
        std::iota(suspects.begin(), suspects.end(), std::size_t{0});
    }
    std::vector<FittedBreak> all;
    for (const std::size_t k : suspects) {
        if (task.job.cancelled()) {
            break;
        }
        const std::vector<PhasorRun> one{runs[k]};
        const std::unique_ptr<SetFit> alone = solved_set(one, task);
        OpenedBreaks opened = with_breaks(one, *alone, task);
        if (opened.set) {
            runs[k] = std::move(opened.runs.front());
            for (FittedBreak& each : opened.breaks) {
                each.run = k;
                all.push_back(each);
            }
        }
    }
    return all;
}

// An event at an end of a run as the step of phase that the unmerged windows up to that end show:
// there are too few of them for a merged one beyond the step. `motion`: that of the other windows.
void name_step(const PhasorRun& run, const FittedMotion& motion, FittedBreak& found) {
    constexpr std::size_t fewest = 3;  // windows beyond the step
    constexpr double least_fall = 50;  // of chi^2, as that of an event
    const auto before = static_cast<std::size_t>(
        std::ranges::lower_bound(run.time_s, found.time_s - found.reach_s) - run.time_s.begin());
    const auto upto = static_cast<std::size_t>(
        std::ranges::upper_bound(run.time_s, found.time_s + found.reach_s) - run.time_s.begin());
    const std::size_t after = run.time_s.size() - upto;
    const std::size_t merged = upto - before;
    const bool at_start = before < merged;
    if (found.kind != BreakKind::event || (!at_start && after >= merged)) {
        return;
    }
    // From the end of the run inwards.
    std::vector<std::size_t> windows(at_start ? upto : run.time_s.size() - before);
    std::iota(windows.begin(), windows.end(), at_start ? 0 : before);
    if (!at_start) {
        std::ranges::reverse(windows);
    }
    const std::vector<Phasors> expected = predicted_phasors(motion, found.run, run.time_s);
    const auto misses = [&](std::size_t k, std::complex<double> turn) {
        return (std::norm(run.c[k] - turn * expected[k].c) +
                std::norm(run.d[k] - turn * expected[k].d)) /
               (run.sd[k] * run.sd[k]);
    };
    double without = 0;
    for (const std::size_t k : windows) {
        without += misses(k, 1);
    }
    double inside = without;
    const double dof = 4 * static_cast<double>(windows.size()) - 5;
    double least = std::min(noise_limit(dof), without - least_fall);
    std::complex<double> beyond = 0;
    for (std::size_t place = 0; place < windows.size(); ++place) {
        // The step lies in this window, those before it are beyond it.
        const std::size_t in = windows[place];
        inside -= misses(in, 1);
        double chi2 = inside;
        const std::complex<double> turn = std::polar(1.0, std::arg(beyond));
        for (std::size_t k = 0; k < place; ++k) {
            chi2 += misses(windows[k], turn);
        }
        if (place >= fewest && chi2 < least) {
            least = chi2;
            found.kind = BreakKind::phase;
            found.time_s = run.time_s[in];
            found.reach_s = run.window_s;
            found.size = {at_start ? -std::arg(beyond) : std::arg(beyond), 0};
        }
        beyond += (std::conj(expected[in].c) * run.c[in] + std::conj(expected[in].d) * run.d[in]) /
                  (run.sd[in] * run.sd[in]);
    }
}

// The warning that names a break.
Diagnostic break_finding(const FittedBreak& found) {
    const MessageArg recording = recording_arg(found.run);
    const MessageArg at = number_arg(found.time_s, 4);
    switch (found.kind) {
        case BreakKind::phase:
            return {DiagnosticKind::fitted_phase_step,
                    {recording, number_arg(found.size[0], 3), at}};
        case BreakKind::gain: {
            // The end of a drive changes the decay of both channels alike.
            constexpr double alike = 0.2;
            constexpr double first_s = 10;
            const double larger = std::max(std::abs(found.size[0]), std::abs(found.size[1]));
            const bool drive =
                found.time_s < first_s && std::abs(found.size[0] - found.size[1]) < alike * larger;
            return {DiagnosticKind::fitted_gain_step,
                    {recording, number_arg(100 * found.size[0], 2),
                     number_arg(100 * found.size[1], 2), at,
                     drive ? Phrase::tr("a drive ends or an amplifier changes its range")
                           : Phrase::tr("an amplifier changes its range")}};
        }
        case BreakKind::start:
            return {DiagnosticKind::fitted_knock,
                    {recording, number_arg(100 * found.size[0], 2), at}};
        case BreakKind::event: break;
    }
    return {DiagnosticKind::event_left_out, {recording, at, number_arg(2 * found.reach_s, 2)}};
}

// The breaks without those of a run that is left out.
std::vector<FittedBreak> breaks_without(std::vector<FittedBreak> breaks, std::size_t out) {
    std::erase_if(breaks, [out](const FittedBreak& each) { return each.run == out; });
    for (FittedBreak& each : breaks) {
        each.run -= each.run > out ? 1 : 0;
    }
    return breaks;
}

bool has_foreign(const SetFit& set) {
    return set.examination().verdict == SetVerdict::foreign;
}

// Leaves out the run that does not belong to the set, if the others agree; returns the set with it,
// else null.
std::unique_ptr<SetFit> without_foreign(std::vector<PhasorRun>& runs, std::unique_ptr<SetFit>& set,
                                        const FitTask& task) {
    if (!has_foreign(*set) || runs.size() < 3) {
        return nullptr;
    }
    std::vector<PhasorRun> others = runs;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(set->examination().foreign.front()));
    std::unique_ptr<SetFit> rest = solved_set(others, task);
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
    add_findings(examination, false, fit);
    const auto at = static_cast<std::ptrdiff_t>(out);
    RunEstimate none;
    refuse(run_parameters, {ReasonCode::left_out, {}}, none);
    fit.runs.insert(fit.runs.begin() + at, none);
    FittedMotion::Run motion = whole.motion().runs[out];
    motion.own = whole.own_given(fit.motion.shared, out);
    for (DriftTerms::Tolerated& each : fit.drift_terms.tolerated) {
        each.motion.runs.insert(each.motion.runs.begin() + at, motion);
    }
    fit.motion.runs.insert(fit.motion.runs.begin() + at, std::move(motion));
    fit.left_out = out;
}

}  // namespace

Result<ResonatorFit> fit_resonator(std::span<const PhasorRun> runs, const FitOptions& stated,
                                   const JobControl& job) {
    std::vector<PhasorRun> good;
    for (const PhasorRun& run : runs) {
        good.push_back(usable_windows(run));
        if (good.back().time_s.size() < least_windows) {
            return Error{ErrorCode::fit_too_few_windows,
                         "recording " + std::to_string(good.size()),
                         {count_arg(static_cast<std::int64_t>(good.back().time_s.size())),
                          count_arg(least_windows), recording_arg(good.size() - 1)}};
        }
    }
    const double scale = largest_amplitude(good);
    if (good.empty() || scale <= 0) {
        return Error{ErrorCode::fit_failed, "the recordings", {Phrase::tr("there is no wave")}};
    }
    const FitOptions usual = with_assumed(stated);
    std::unique_ptr<SetFit> set = solved_set(good, {scale, stated, job});
    bool by_usual = false;
    // What channels within their usual tolerances explain is no finding, and hides the run that
    // does not belong to the set. Errors of their size lead to no other maximum of the posterior.
    if (usual.tolerance != stated.tolerance &&
        !(set->explains() && set->is_white() && set->unexplained_breaks().empty()) &&
        (!set->agrees() || set->may_be_explained_by(usual.tolerance))) {
        std::unique_ptr<SetFit> open = solved_set(good, {scale, usual, job});
        by_usual = open->explains() || (!set->agrees() && !has_foreign(*set) && has_foreign(*open));
        if (by_usual) {
            set = std::move(open);
        }
    }
    const FitTask task{scale, by_usual ? usual : stated, job};
    std::vector<FittedBreak> breaks;
    std::vector<PhasorRun> unbroken = good;
    if (set->examination().verdict != SetVerdict::fits) {
        breaks = open_own_breaks(set->examination(), good, task);
        if (!breaks.empty()) {
            set = solved_set(good, task);
        }
    }
    const std::unique_ptr<SetFit> whole = without_foreign(good, set, task);
    if (whole) {
        const std::size_t out = whole->examination().foreign.front();
        breaks = breaks_without(std::move(breaks), out);
        unbroken.erase(unbroken.begin() + static_cast<std::ptrdiff_t>(out));
    }
    OpenedBreaks opened;
    if (set->agrees()) {
        opened = with_breaks(good, *set, task);
    }
    if (opened.set) {
        set = std::move(opened.set);
        std::ranges::move(opened.breaks, std::back_inserter(breaks));
    }
    ResonatorFit fit = set->described();
    for (FittedBreak& each : breaks) {
        each.size = set->size_of(each);
        name_step(unbroken[each.run], set->motion(), each);
        fit.warnings.push_back(break_finding(each));
    }
    fit.breaks = std::move(breaks);
    if (whole) {
        add_foreign(*whole, runs.size(), fit);
    }
    TRY(job.go_on());
    return fit;
}

}  // namespace vybeg
