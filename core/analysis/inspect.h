#pragma once

#include "core/analysis/settings.h"
#include "core/base/job_control.h"
#include "core/recording/checks/recording_check.h"
#include "core/recording/samples/recording.h"

namespace vybeg {

// The recording check of METHOD section 7 over the whole recording: its own diagnostics, then what
// the samples tell. The carrier is looked for as the settings say; where there is none, neither
// lost samples nor a start transient are looked for. Errors: those of the source, interrupted.
Result<SampleFaults> inspect(const Recording& recording, const SignalSettings& settings,
                             const JobControl& job);

}  // namespace vybeg
