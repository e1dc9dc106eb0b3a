#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/analysis/window_choice.h"
#include "core/resonator/model/phasor_run.h"
#include "core/resonator/runs/run_track.h"
#include "core/resonator/runs/wave_motion.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vybeg {

// What became of one recording.
struct IdentifiedRun {
    double f0_hz = 0;
    std::int64_t window = 0;        // samples
    std::int64_t windows = 0;       // in the range
    std::int64_t windows_used = 0;  // without faults
    // Per sample and channel, recording units: of white noise with the density at the carrier.
    double noise_sd = 0;
    std::vector<Diagnostic> diagnostics;  // of the preparation and of the samples
    RunTrack track;
    WaveMotion wave;
};

// Phasors of one recording, of the windows that count, for the identification of its resonator
// (METHOD section 8), and what is known of it.
struct RecordedRun {
    std::string name;
    double rate_relative_sd = 0;  // what the digits of its file leave open of its clock
    PhasorRun phasors;
    IdentifiedRun told;  // without track and wave
    Timing timing = {};  // of recordings
};

// Demodulates windows of `length` samples, one after the other, at the fixed carrier
// choice.prepared.f0_hz (WindowMean). Times count from the start of the recording. Windows with
// missing or clipped samples and those over a lost sample are left out; the time behind lost
// samples counts them; where the phase does not tell their number it counts the smallest, and
// PhasorRun::breaks names the place. Left out is also what is no free decay yet: all up to
// the strike where a window before it has less than a thousandth of its power, and, behind a
// band-pass, as much again as the filter reaches, through which a strike still rings. The angle of
// the first electrode is subtracted.
//
// The deviations are those of the noise at the carrier: of the windows' residual where the noise is
// white, else of the density between the lines (CarrierLines), behind a band-pass with what it
// lets through of a window's bandwidth. A window whose residual stands out has a
// deviation in proportion.
//
// Precondition: the plan's windows lie in the prepared range, hop = length, at least
// least_phasor_window(). Errors: those of the source, no_valid_samples where no window is left,
// every_window_clipped where clipping leaves none, interrupted. The result is the same to the last
// bit for any number of threads. It has no name yet.
Result<RecordedRun> phasor_windows(const WindowChoice& choice, double rate_hz, int threads,
                                   const JobControl& job);

}  // namespace vybeg
