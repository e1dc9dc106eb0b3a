#pragma once

#include "core/analysis/settings.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/recording.h"

namespace vybeg {

// Only the carrier f0 of the recording (Hz), with the settings' band, filter, calibration and
// range: what the interface shows before the first run.
Result<double> find_recording_carrier(const Recording& recording, const SignalSettings& settings,
                                      const JobControl& job);

}  // namespace vybeg
