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
