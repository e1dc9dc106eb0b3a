#include "core/analysis/analyse.h"

#include "core/analysis/estimate_track.h"
#include "core/analysis/inspect.h"
#include "core/analysis/prepare.h"
#include "core/analysis/window_faults.h"
#include "core/base/number_text.h"

#include <tbb/info.h>

#include <algorithm>
#include <utility>

namespace vybeg {
namespace {

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

void add_diagnostics(const EstimationSummary& estimation, AnalysisSummary& analysis) {
    if (estimation.not_converged > 0) {
        analysis.diagnostics.push_back(
            {DiagnosticKind::not_converged,
             {integer_text(estimation.not_converged), integer_text(analysis.plan.count)}});
    }
    if (estimation.context > 0) {
        analysis.diagnostics.push_back(
            {DiagnosticKind::context_missing, {integer_text(estimation.context)}});
    }
}

}  // namespace

Result<AnalysisSummary> analyse(const Recording& recording, const Settings& settings,
                                const TrackSink& sink, const JobControl& job) {
    if (const Status valid = validate(settings); !valid) {
        return valid.error();
    }
    const Result<Prepared> prepared = prepare(recording, settings, job);
    if (!prepared) {
        return prepared.error();
    }
    const Result<WindowPlan> plan = plan_of(settings, *prepared, recording);
    if (!plan) {
        return plan.error();
    }
    const int cores = tbb::info::default_concurrency();
    const int threads = settings.threads > 0 ? std::min(settings.threads, cores) : cores;
    const Result<EstimationSummary> estimation =
        estimate_track(*prepared, *plan, settings, recording.rate_hz, threads, sink, job);
    if (!estimation) {
        return estimation.error();
    }

    AnalysisSummary analysis;
    analysis.settings = settings;
    analysis.settings.window = plan->length;
    analysis.settings.hop = plan->hop;
    analysis.settings.f0_hz = prepared->f0_hz;
    analysis.settings.calibration = prepared->calibration;
    analysis.plan = *plan;
    analysis.residual = orthogonality_residual(plan->length, prepared->f0_hz, recording.rate_hz);
    analysis.diagnostics = prepared->diagnostics;
    const SampleFaults faults = prepared->check->finish();
    add_findings(faults.findings, analysis.diagnostics);
    analysis.flagged = windows_over(faults, *plan);
    add_diagnostics(*estimation, analysis);
    analysis.timing = {estimation->read_s, prepared->carrier_s, estimation->estimate_s, threads};
    return analysis;
}

Result<Analysis> analyse(const Recording& recording, const Settings& settings,
                         const JobControl& job) {
    Analysis analysis;
    const TrackSink collect = [&analysis](const Track& rows) {
        analysis.track.append(rows);
        return Status{};
    };
    Result<AnalysisSummary> summary = analyse(recording, settings, collect, job);
    if (!summary) {
        return summary.error();
    }
    static_cast<AnalysisSummary&>(analysis) = std::move(*summary);
    set_flags(analysis.track, analysis.flagged);
    return analysis;
}

Result<double> find_recording_carrier(const Recording& recording, const Settings& settings,
                                      const JobControl& job) {
    if (const Status valid = validate(settings); !valid) {
        return valid.error();
    }
    const Result<Prepared> prepared = prepare(recording, settings, job);
    if (!prepared) {
        return prepared.error();
    }
    return prepared->f0_hz;
}

}  // namespace vybeg
