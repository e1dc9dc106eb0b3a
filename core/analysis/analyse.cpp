#include "core/analysis/analyse.h"

#include "core/analysis/planned_analysis.h"
#include "core/analysis/prepare.h"

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
