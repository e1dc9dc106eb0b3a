#include "core/analysis/analyse.h"

#include "core/analysis/analysis_plan.h"
#include "core/analysis/analysis_summary.h"
#include "core/analysis/estimate_track.h"
#include "core/analysis/setting_table.h"

#include <utility>

namespace vybeg {

Result<AnalysisSummary> analyse(const Recording& recording, const Settings& settings,
                                const TrackSink& sink, const JobControl& job,
                                const BeforeWindows& before) {
    if (const Status valid = validate(settings); !valid) {
        return valid.error();
    }
    const Result<ConditionedRecording> prepared = prepare(recording, settings, job);
    if (!prepared) {
        return prepared.error();
    }
    const Result<WindowPlan> plan = plan_of(settings, *prepared, recording);
    if (!plan) {
        return plan.error();
    }
    AnalysisSummary analysis = summary_before(settings, *prepared, *plan, recording.rate_hz);
    if (const Status begun = before ? before(*prepared, analysis) : Status(); !begun) {
        return begun.error();
    }
    const Result<EstimationSummary> estimation = estimate_track(
        *prepared, *plan, settings, recording.rate_hz, analysis.timing.threads, sink, job);
    if (!estimation) {
        return estimation.error();
    }
    add_estimation(*estimation, prepared->check->finish(), analysis);
    return analysis;
}

Result<Analysis> analyse(const Recording& recording, const Settings& settings,
                         const JobControl& job, const BeforeWindows& before) {
    Track track;
    const TrackSink collect = [&track](const Track& rows) {
        track.append(rows);
        return Status{};
    };
    Result<AnalysisSummary> summary = analyse(recording, settings, collect, job, before);
    if (!summary) {
        return summary.error();
    }
    set_flags(track.flags(), 0, summary->flagged);
    return Analysis{std::move(*summary), std::move(track)};
}

}  // namespace vybeg
