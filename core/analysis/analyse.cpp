#include "core/analysis/analyse.h"

#include "core/analysis/estimate_track.h"
#include "core/analysis/setting_table.h"
#include "core/numerics/phase.h"
#include "core/recording/checks/recording_check.h"
#include "core/track/motion.h"
#include "core/track/track.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace vybeg {
namespace {

void add_diagnostics(const EstimationSummary& estimation, AnalysisSummary& analysis) {
    const auto tell_of = [&analysis](DiagnosticKind kind, std::int64_t windows) {
        if (windows > 0) {
            analysis.diagnostics.push_back(
                {kind, {count_arg(windows), count_arg(analysis.plan.count)}});
        }
    };
    std::size_t moving = 0;
    for (const FlaggedRows& rows : analysis.flagged) {
        moving += rows.flag == Flag::moving ? rows.count : 0;
    }
    tell_of(DiagnosticKind::not_converged, estimation.not_converged);
    tell_of(DiagnosticKind::leakage, static_cast<std::int64_t>(estimation.track.leaking));
    tell_of(DiagnosticKind::wave_moves, static_cast<std::int64_t>(moving));
    if (estimation.context > 0) {
        analysis.diagnostics.push_back(
            {DiagnosticKind::context_missing, {count_arg(estimation.context)}});
    }
}

// The summary of an analysis before its first window is estimated: settings as used, plan,
// residual, and the findings of the recording.
AnalysisSummary summary_before(const Settings& settings, const ConditionedRecording& prepared,
                               const WindowPlan& plan, double rate_hz) {
    AnalysisSummary analysis;
    analysis.settings = settings;
    analysis.settings.window = plan.length;
    analysis.settings.hop = plan.hop;
    analysis.settings.f0_hz = prepared.f0_hz;
    analysis.settings.calibration = prepared.calibration;
    analysis.plan = plan;
    analysis.residual = orthogonality_residual(plan.length, prepared.f0_hz, rate_hz);
    analysis.diagnostics = prepared.diagnostics;
    analysis.timing.carrier_s = prepared.carrier_s;
    analysis.timing.threads = threads_of(settings.threads);
    return analysis;
}

// Adds what the windows have shown, and the sample check that has seen all samples on their way.
void add_estimation(const EstimationSummary& estimation, const SampleFaults& faults,
                    std::int64_t filter_reach, AnalysisSummary& analysis) {
    add_findings(faults.findings, analysis.diagnostics);
    analysis.flagged = windows_over(faults, analysis.plan, filter_reach);
    const std::vector<FlaggedRows> moving =
        moving_apart(estimation.moving, analysis.flagged, analysis.plan);
    analysis.flagged.insert(analysis.flagged.end(), moving.begin(), moving.end());
    std::ranges::stable_sort(analysis.flagged, {}, &FlaggedRows::first);
    analysis.means = estimation.track;
    analysis.f_correlation = estimation.f_correlation;
    add_diagnostics(estimation, analysis);
    analysis.timing.read_s = estimation.read_s;
    analysis.timing.estimate_s = estimation.estimate_s;
}

// Whether no window has neighbours a window length before and after, which show a motion inside.
bool are_few(const WindowPlan& plan) {
    return (plan.count - 1) * plan.hop < 2 * plan.length;
}

// Of few windows, with their rows, the parts of the first and of the last one show it.
Status look_inside(const ConditionedRecording& prepared, const WindowPlan& plan, const Track& rows,
                   const Settings& settings, double rate_hz, const JobControl& job,
                   std::vector<FlaggedRows>& moving) {
    constexpr std::int64_t parts = 9;
    const std::int64_t length = plan.length / parts;
    if (length < 4 * least_window(prepared.f0_hz, rate_hz)) {
        return {};
    }
    const ConditionedRecording again = prepared.past_check();
    Settings own = settings;
    own.initial.reset();
    for (std::int64_t window = 0; window < plan.count;
         window += std::max<std::int64_t>(plan.count - 1, 1)) {
        Track cut;
        TRY(estimate_track(again, {plan.start(window), length, length, parts}, own, rate_hz, 1,
                           appended_to(cut), job.silent()));
        const auto row = MotionMarker::row_of(rows, static_cast<std::size_t>(window));
        if (MotionMarker::bends_inside(row, cut)) {
            moving = {{0, rows.rows(), Flag::moving}};
            break;
        }
    }
    return {};
}

// Names the line that the recording holds, where the windows about the carrier that was given leave
// most of its power and cannot reach that line.
Status add_other_carrier(const Recording& recording, const SignalSettings& settings,
                         const FaultCheck& check, const JobControl& job,
                         AnalysisSummary& analysis) {
    constexpr double most_of_it = 0.5;
    const double left = 2 * analysis.means.noise * analysis.means.noise;
    if (!settings.f0_hz || !(left > most_of_it * check.power())) {
        return {};
    }
    SignalSettings search = settings;
    search.f0_hz.reset();
    const Result<double> found = find_recording_carrier(recording, search, job.silent());
    const double reach = recording.rate_hz / static_cast<double>(analysis.plan.length);
    if (found && std::abs(*found - *settings.f0_hz) > reach) {
        analysis.diagnostics.push_back({DiagnosticKind::carrier_out_of_reach,
                                        {number_arg(*found), number_arg(*settings.f0_hz)}});
    }
    return job.go_on();
}

// Seconds below which nobody waits: everything is made at once.
constexpr double at_once_s = 0.1;
// Seconds that the spread windows may take. Each step doubles their number, so that a slow disk or
// a long window gives a coarser first picture, not a late one.
constexpr double spread_s = 0.06;
constexpr std::int64_t fewest_spread = 16;
constexpr std::int64_t most_spread = 512;

// Windows [first, end) of a plan.
struct WindowRange {
    std::int64_t first = 0;
    std::int64_t end = 0;

    std::int64_t count() const { return end - first; }
};

// Rough time of windows, s: a window and a frame of an ordinary processor core. Only the order in
// which windows are shown depends on it.
double about_s(std::int64_t windows, const WindowPlan& plan, Algorithm algorithm) {
    const double window_s = algorithm == Algorithm::conjugate_gradient ? 5e-6 : 0.2e-6;
    const double frame_s = 15e-9;
    const auto count = static_cast<double>(windows);
    return count * (window_s + frame_s * static_cast<double>(plan.hop));
}

// The windows whose centres are visible.
WindowRange visible_windows(const WindowPlan& plan, const TimeRange& visible, double rate_hz) {
    const auto windows = static_cast<double>(plan.count);
    const auto window_at = [&](double time_s) {
        const double hops = (time_s - plan.centre_s(0, rate_hz)) * rate_hz;
        return std::clamp(hops / static_cast<double>(plan.hop), -1.0, windows);
    };
    const auto first = static_cast<std::int64_t>(std::ceil(window_at(visible.from_s)));
    const auto last = static_cast<std::int64_t>(std::floor(window_at(visible.to_s)));
    const WindowRange shown{std::clamp<std::int64_t>(first, 0, plan.count),
                            std::clamp<std::int64_t>(last + 1, 0, plan.count)};
    return shown.count() > 0 ? shown : WindowRange{};
}

// Windows of an analysis by themselves, before all of them are made.
class EarlyWindows {
public:
    EarlyWindows(ConditionedRecording prepared, const AnalysisSummary& whole, double rate_hz,
                 const JobControl& job)
        : prepared_(std::move(prepared)), whole_(whole), rate_hz_(rate_hz), job_(job.silent()) {}

    // Single windows at even distances, first and last included, as many as there is time for.
    Status spread(const WindowRange& segment) {
        const double begun = job_.now();
        for (std::int64_t places = fewest_spread; places <= most_spread; places *= 2) {
            for (std::int64_t place = 0; place <= places; ++place) {
                const std::int64_t window = segment.first + (segment.count() - 1) * place / places;
                if (rows_.contains(window)) {
                    continue;
                }
                if (places > fewest_spread && job_.now() - begun > spread_s / 2) {
                    return {};
                }
                TRY(estimate({window, window + 1}, 1));
            }
        }
        return {};
    }

    // All of them.
    Status fill(const WindowRange& segment) {
        rows_.erase(rows_.lower_bound(segment.first), rows_.lower_bound(segment.end));
        return estimate(segment, threads_of(whole_.settings.threads));
    }

    Analysis analysis() const {
        Analysis analysis{whole_, {}};
        analysis.timing = {};
        for (const auto& [window, rows] : rows_) {
            analysis.track.append(rows);
        }
        // The first electrode's angle has been taken off with the rows' own.
        AngleUnwrapper(0).unwrap(analysis.track);
        return analysis;
    }

private:
    Status estimate(const WindowRange& segment, int threads) {
        const WindowPlan part{whole_.plan.start(segment.first), whole_.plan.length, whole_.plan.hop,
                              segment.count()};
        Settings settings = whole_.settings;
        if (settings.initial) {
            // Typed start values hold at the first window of the whole.
            const double later = part.centre_s(0, rate_hz_) - whole_.plan.centre_s(0, rate_hz_);
            double& alpha = settings.initial->state.alpha;
            alpha = wrap(alpha - 2 * std::numbers::pi * settings.initial->f_hz * later);
        }
        TRY(estimate_track(prepared_, part, settings, rate_hz_, threads,
                           appended_to(rows_[segment.first]), job_));
        return {};
    }

    ConditionedRecording prepared_;
    const AnalysisSummary& whole_;
    double rate_hz_;
    JobControl job_;
    std::map<std::int64_t, Track> rows_;  // by their first window
};

Status show_early(const ConditionedRecording& prepared, const AnalysisSummary& whole,
                  double rate_hz, const TimeRange& visible, const EarlySink& early,
                  const JobControl& job) {
    const WindowPlan& plan = whole.plan;
    EarlyWindows windows(prepared.past_check(), whole, rate_hz, job);
    TRY(windows.spread({0, plan.count}));
    const WindowRange shown = visible_windows(plan, visible, rate_hz);
    const bool is_part = shown.count() > 0 && 2 * shown.count() <= plan.count;
    const bool is_quick = about_s(shown.count(), plan, whole.settings.algorithm) < at_once_s;
    if (is_part && !is_quick) {
        TRY(windows.spread(shown));
    }
    if (!is_part || !is_quick) {
        early(windows.analysis());
    }
    if (is_part) {
        TRY(windows.fill(shown));
        early(windows.analysis());
    }
    return {};
}

}  // namespace

Result<WindowPlan> plan_of(const WindowSettings& settings, const ConditionedRecording& prepared,
                           const Recording& recording) {
    const double rate = recording.rate_hz;
    std::int64_t length = settings.periods
                              ? window_of_periods(*settings.periods, prepared.f0_hz, rate)
                              : settings.window;
    const std::int64_t least = least_window(prepared.f0_hz, rate);
    if (length < least) {
        return Error{ErrorCode::window_too_short,
                     recording_name(recording),
                     {count_arg(length), count_arg(least)}};
    }
    if (settings.snap) {
        length = snap_window(length, prepared.f0_hz, rate);
    }
    const std::int64_t hop = settings.hop > 0 ? settings.hop : length;
    const WindowPlan plan = plan_windows(prepared.first, prepared.end, length, hop);
    if (plan.count == 0) {
        return Error{ErrorCode::window_too_long,
                     recording_name(recording),
                     {count_arg(length), count_arg(prepared.end - prepared.first)}};
    }
    return plan;
}

Result<AnalysisSummary> analyse(const Recording& recording, const Settings& settings,
                                const TrackSink& sink, const JobControl& job,
                                const BeforeWindows& before) {
    TRY(validate(settings));
    const auto prepared = TRY(prepare(recording, settings, job));
    const auto plan = TRY(plan_of(settings, prepared, recording));
    AnalysisSummary analysis = summary_before(settings, prepared, plan, recording.rate_hz);
    TRY(before ? before(prepared, analysis) : Status());
    const bool few = are_few(plan);
    Track rows;
    const TrackSink kept = [&](const Track& next) -> Status {
        rows.append(next);
        return sink(next);
    };
    auto estimation = TRY(estimate_track(prepared, plan, settings, recording.rate_hz,
                                         analysis.timing.threads, few ? kept : sink, job));
    if (few) {
        TRY(look_inside(prepared, plan, rows, settings, recording.rate_hz, job, estimation.moving));
    }
    add_estimation(estimation, prepared.check->finish(), prepared.filter_reach, analysis);
    TRY(add_other_carrier(recording, settings, *prepared.check, job, analysis));
    return analysis;
}

Result<Analysis> analyse(const Recording& recording, const Settings& settings,
                         const JobControl& job, const BeforeWindows& before) {
    Track track;
    auto summary = TRY(analyse(recording, settings, appended_to(track), job, before));
    set_flags(track.flags(), 0, summary.flagged);
    return Analysis{std::move(summary), std::move(track)};
}

Result<Analysis> analyse_visible_first(const Recording& recording, const Settings& settings,
                                       const TimeRange& visible, const EarlySink& early,
                                       const JobControl& job) {
    const BeforeWindows show = [&](const ConditionedRecording& prepared,
                                   const AnalysisSummary& whole) {
        // Repairing lost samples goes through the whole recording before the first window: nothing
        // of it could be early.
        const bool long_enough =
            about_s(whole.plan.count, whole.plan, settings.algorithm) > at_once_s;
        return !settings.repair_lost && long_enough
                   ? show_early(prepared, whole, recording.rate_hz, visible, early, job)
                   : Status();
    };
    return analyse(recording, settings, job, show);
}

}  // namespace vybeg
