#include "core/analysis/analyse.h"

#include "core/analysis/estimate_track.h"
#include "core/analysis/setting_table.h"
#include "core/analysis/window_faults.h"
#include "core/recording/checks/recording_check.h"

#include <algorithm>
#include <utility>

namespace vybeg {

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

namespace {

void add_diagnostics(const EstimationSummary& estimation, AnalysisSummary& analysis) {
    if (estimation.not_converged > 0) {
        analysis.diagnostics.push_back(
            {DiagnosticKind::not_converged,
             {count_arg(estimation.not_converged), count_arg(analysis.plan.count)}});
    }
    if (estimation.leaking > 0) {
        analysis.diagnostics.push_back(
            {DiagnosticKind::leakage,
             {count_arg(estimation.leaking), count_arg(analysis.plan.count)}});
    }
    std::size_t moving = 0;
    for (const FlaggedRows& rows : analysis.flagged) {
        moving += rows.flag == Flag::moving ? rows.count : 0;
    }
    if (moving > 0) {
        analysis.diagnostics.push_back(
            {DiagnosticKind::wave_moves,
             {count_arg(static_cast<std::int64_t>(moving)), count_arg(analysis.plan.count)}});
    }
    if (estimation.context > 0) {
        analysis.diagnostics.push_back(
            {DiagnosticKind::context_missing, {count_arg(estimation.context)}});
    }
}

// What is known of an analysis before its first window is estimated: settings as used, plan,
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
                    AnalysisSummary& analysis) {
    add_findings(faults.findings, analysis.diagnostics);
    analysis.flagged = windows_over(faults, analysis.plan);
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

}  // namespace

Result<AnalysisSummary> analyse(const Recording& recording, const Settings& settings,
                                const TrackSink& sink, const JobControl& job,
                                const BeforeWindows& before) {
    TRY(validate(settings));
    const auto prepared = TRY(prepare(recording, settings, job));
    const auto plan = TRY(plan_of(settings, prepared, recording));
    AnalysisSummary analysis = summary_before(settings, prepared, plan, recording.rate_hz);
    TRY(before ? before(prepared, analysis) : Status());
    const auto estimation = TRY(estimate_track(prepared, plan, settings, recording.rate_hz,
                                               analysis.timing.threads, sink, job));
    add_estimation(estimation, prepared.check->finish(), analysis);
    return analysis;
}

Result<Analysis> analyse(const Recording& recording, const Settings& settings,
                         const JobControl& job, const BeforeWindows& before) {
    Track track;
    const TrackSink collect = [&track](const Track& rows) {
        track.append(rows);
        return Status{};
    };
    auto summary = TRY(analyse(recording, settings, collect, job, before));
    set_flags(track.flags(), 0, summary.flagged);
    return Analysis{std::move(summary), std::move(track)};
}

}  // namespace vybeg
