#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/identify_settings.h"
#include "core/analysis/phasor_windows.h"
#include "core/base/job_control.h"
#include "core/recording/checks/recording_check.h"
#include "core/recording/samples/recording.h"
#include "core/resonator/results/drift_function.h"
#include "core/resonator/results/resonator_fit.h"
#include "core/resonator/runs/run_track.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vybeg {

// Points of a run's track: enough for a picture.
inline constexpr std::size_t run_track_points = 200;

// Summed over the recordings.
struct IdentifyTiming : Timing {
    double windows_s = 0;  // all of these together, by the clock
    double fit_s = 0;
    std::int64_t windows = 0;
};

struct Identification {
    IdentifySettings settings;
    std::vector<IdentifiedRun> runs;  // one for each recording, in their order
    ResonatorFit fit;
    DriftFunction drift;                  // empty for the free model
    std::vector<ChannelBalance> balance;  // of each run; empty for the free model
    IdentifyTiming timing;
};

// The whole road from the recordings of one resonator to the resonator (METHOD section 8): a set of
// runs that differ in their start. The gain ratio that is found is the one of the recorded signals.
// Memory does not grow with the recordings, and the result is the same to the last bit for any
// number of threads. Precondition: at least one recording; settings.of_recordings is empty or has
// an entry for each. Errors: setting_invalid, those of prepare(), fit_window_too_short,
// window_too_long, no_valid_samples, every_window_clipped, those of fit_resonator(), interrupted.
Result<Identification> identify(std::span<const Recording> recordings,
                                const IdentifySettings& settings, const JobControl& job);

// The same from phasors. `found`: settings and the timing so far. Errors: those of
// fit_resonator(), phasors_fold, interrupted.
Result<Identification> identify_runs(std::vector<RecordedRun> runs, Identification found,
                                     const JobControl& job);

// The fit sees D over the calibration's gain ratio: brings its own to the recorded channels.
void refer_to_recorded(double calibrated, ResonatorFit& fit);

// The error of a fit, about the recording that it is about.
Error named(Error error, std::span<const MessageArg> names);

// The tolerances of the settings for a fit at a frequency.
FitOptions fit_options(const IdentifySettings& settings, double f_hz);

// Why an identification has no drift function; ReasonCode::none where it has one.
Reason no_drift_function(const Identification& identification);

// The recording check of METHOD section 7 over the whole recording: its own diagnostics, then those
// of the samples and the motion. The carrier is looked for as the settings say; where there is
// none, neither lost samples nor a start transient are looked for. Errors: those of the source,
// interrupted.
Result<SampleFaults> inspect(const Recording& recording, const SignalSettings& settings,
                             const JobControl& job);

}  // namespace vybeg
