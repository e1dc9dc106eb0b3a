#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/estimate_track.h"
#include "core/analysis/prepare.h"
#include "core/analysis/settings.h"

namespace vybeg {

// What is known of an analysis before its first window is estimated: settings as used, plan,
// residual, and the findings of the recording.
AnalysisSummary summary_before(const Settings& settings, const ConditionedRecording& prepared,
                               const WindowPlan& plan, double rate_hz);

// Adds what the windows have shown, and the sample check that has seen all samples on their way.
void add_estimation(const EstimationSummary& estimation, const SampleFaults& faults,
                    AnalysisSummary& analysis);

}  // namespace vybeg
