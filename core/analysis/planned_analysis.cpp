#include "core/analysis/planned_analysis.h"

#include "core/analysis/estimate_track.h"
#include "core/analysis/inspect.h"
#include "core/analysis/setting_table.h"
#include "core/analysis/window_faults.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <utility>

namespace vybeg {
namespace {

void add_diagnostics(const EstimationSummary& estimation, AnalysisSummary& analysis) {
    if (estimation.not_converged > 0) {
        analysis.diagnostics.push_back(
            {DiagnosticKind::not_converged,
             {integer_text(estimation.not_converged), integer_text(analysis.plan.count)}});
    }
    if (estimation.leaking > 0) {
        analysis.diagnostics.push_back(
            {DiagnosticKind::leakage,
             {integer_text(estimation.leaking), integer_text(analysis.plan.count)}});
    }
    std::size_t moving = 0;
    for (const FlaggedRows& rows : analysis.flagged) {
        moving += rows.flag == Flag::moving ? rows.count : 0;
    }
    if (moving > 0) {
        analysis.diagnostics.push_back(
            {DiagnosticKind::wave_moves,
             {integer_text(static_cast<std::int64_t>(moving)), integer_text(analysis.plan.count)}});
    }
    if (estimation.context > 0) {
        analysis.diagnostics.push_back(
            {DiagnosticKind::context_missing, {integer_text(estimation.context)}});
    }
}

Result<WindowPlan> plan_of(const Settings& settings, const Prepared& prepared,
                           const Recording& recording) {
    const double rate = recording.rate_hz;
    std::int64_t length = settings.periods
                              ? window_of_periods(*settings.periods, prepared.f0_hz, rate)
                              : settings.window;
    const std::int64_t least = least_window(prepared.f0_hz, rate);
    if (length < least) {
        return Error{ErrorCode::window_too_short,
                     recording_name(recording),
                     {integer_text(length), integer_text(least)}};
    }
    if (settings.snap) {
        length = snap_window(length, prepared.f0_hz, rate);
    }
    const std::int64_t hop = settings.hop > 0 ? settings.hop : length;
    const WindowPlan plan = plan_windows(prepared.first, prepared.end, length, hop);
    if (plan.count == 0) {
        return Error{ErrorCode::window_too_long,
                     recording_name(recording),
                     {integer_text(length), integer_text(prepared.end - prepared.first)}};
    }
    return plan;
}

}  // namespace

Result<Planned> plan_analysis(const Recording& recording, const Settings& settings,
                              const JobControl& job) {
    if (const Status valid = validate(settings); !valid) {
        return valid.error();
    }
    Result<Prepared> prepared = prepare(recording, settings, job);
    if (!prepared) {
        return prepared.error();
    }
    const Result<WindowPlan> plan = plan_of(settings, *prepared, recording);
    if (!plan) {
        return plan.error();
    }
    return Planned{std::move(*prepared), *plan};
}

AnalysisSummary summary_before(const Settings& settings, const Planned& planned, double rate_hz) {
    AnalysisSummary analysis;
    analysis.settings = settings;
    analysis.settings.window = planned.plan.length;
    analysis.settings.hop = planned.plan.hop;
    analysis.settings.f0_hz = planned.f0_hz;
    analysis.settings.calibration = planned.calibration;
    analysis.plan = planned.plan;
    analysis.residual = orthogonality_residual(planned.plan.length, planned.f0_hz, rate_hz);
    analysis.diagnostics = planned.diagnostics;
    return analysis;
}

Result<AnalysisSummary> analyse_planned(const Recording& recording, const Settings& settings,
                                        const Planned& planned, const TrackSink& sink,
                                        const JobControl& job) {
    const int threads = threads_of(settings.threads);
    const Result<EstimationSummary> estimation =
        estimate_track(planned, planned.plan, settings, recording.rate_hz, threads, sink, job);
    if (!estimation) {
        return estimation.error();
    }
    AnalysisSummary analysis = summary_before(settings, planned, recording.rate_hz);
    const SampleFaults faults = planned.check->finish();
    add_findings(faults.findings, analysis.diagnostics);
    analysis.flagged = windows_over(faults, planned.plan);
    const std::vector<FlaggedRows> moving =
        moving_apart(estimation->moving, analysis.flagged, planned.plan);
    analysis.flagged.insert(analysis.flagged.end(), moving.begin(), moving.end());
    std::ranges::stable_sort(analysis.flagged, {}, &FlaggedRows::first);
    analysis.means = estimation->track;
    add_diagnostics(*estimation, analysis);
    analysis.timing = {estimation->read_s, planned.carrier_s, estimation->estimate_s, threads};
    return analysis;
}

Result<Analysis> analyse_planned(const Recording& recording, const Settings& settings,
                                 const Planned& planned, const JobControl& job) {
    Analysis analysis;
    const TrackSink collect = [&analysis](const Track& rows) {
        analysis.track.append(rows);
        return Status{};
    };
    Result<AnalysisSummary> summary = analyse_planned(recording, settings, planned, collect, job);
    if (!summary) {
        return summary.error();
    }
    static_cast<AnalysisSummary&>(analysis) = std::move(*summary);
    set_flags(analysis.track, 0, analysis.flagged);
    return analysis;
}

}  // namespace vybeg
