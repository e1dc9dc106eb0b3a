#include "core/analysis/analysis_summary.h"

#include "core/analysis/window_faults.h"
#include "core/base/number_text.h"
#include "core/recording/checks/recording_check.h"

#include <algorithm>

namespace vybeg {
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

}  // namespace

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

}  // namespace vybeg
