#include "core/analysis/analyse.h"

#include "core/analysis/planned_analysis.h"

namespace vybeg {

Result<AnalysisSummary> analyse(const Recording& recording, const Settings& settings,
                                const TrackSink& sink, const JobControl& job) {
    const Result<Planned> planned = plan_analysis(recording, settings, job);
    return planned ? analyse_planned(recording, settings, *planned, sink, job) : planned.error();
}

Result<Analysis> analyse(const Recording& recording, const Settings& settings,
                         const JobControl& job) {
    const Result<Planned> planned = plan_analysis(recording, settings, job);
    return planned ? analyse_planned(recording, settings, *planned, job) : planned.error();
}

}  // namespace vybeg
