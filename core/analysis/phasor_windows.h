#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/identify_settings.h"
#include "core/analysis/prepare.h"
#include "core/analysis/settings.h"
#include "core/resonator/model/phasor_run.h"
#include "core/resonator/runs/run_track.h"
#include "core/resonator/runs/wave_motion.h"
#include "core/windows/window_plan.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace vybeg {

// What the spectrum shows around the carrier of a recording: the lines of its modes, the density
// of the noise between them, and the lines of the mains.
struct CarrierLines {
    // The modes' lines, Hz. All three are f0 where no line stands out.
    double strongest_hz = 0;
    double lowest_hz = 0;
    double highest_hz = 0;
    // Variance per sample and channel of the white noise that has the density found beside the
    // carrier, and its relative standard deviation; the median over segments. NaN where the
    // samples are too few.
    double noise_power = std::numeric_limits<double>::quiet_NaN();
    int segments = 0;  // that it was found in
    double relative_sd = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> mains_hz;
};

// Least window of an identification: 16 samples and two periods, so that six numbers a channel
// leave a residual.
std::int64_t least_phasor_window(double f0_hz, double rate_hz);

// The window where the engineer gives none: 15 ms, twelve periods of the carrier at least. That is
// short against the beat of a split of 10 Hz and against the decay of a bell. Shorter where the
// range holds fewer than 64 of them, longer where it holds more than 16384: memory does not grow
// with the recording.
std::int64_t default_phasor_window(std::int64_t frames, double f0_hz, double rate_hz);

// A recording made ready, and the windows in which its phasors are demodulated.
struct WindowChoice {
    ConditionedRecording prepared;  // f0_hz is the frequency of demodulation
    WindowPlan plan;
    CarrierLines lines;
};

// Windows in which the phasors of all modes turn by at most a tenth of a revolution, so that
// neither their beat nor a carrier given beside them is aliased. Where they turn faster at f0, the
// frequency of demodulation moves to the middle of the modes' lines (CarrierLines), and a window
// that the engineer did not choose is shortened. Errors: those of prepare(), carrier_not_near
// where the engineer gave f0 and there is no line, fit_window_too_short, window_too_long,
// fit_window_turns where a window that the engineer chose turns by more than a quarter,
// fit_beat_too_fast where two periods are too long.
Result<WindowChoice> choose_windows(const Recording& recording, const SignalSettings& settings,
                                    const PhasorWindowSettings& wished, const JobControl& job);

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
// (METHOD section 8), with its summary.
struct RecordedRun {
    std::string name;
    double rate_relative_sd = 0;  // of its clock, from the digits in its file
    PhasorRun phasors;
    IdentifiedRun told;  // without track and wave
    Timing timing = {};  // of recordings
};

// Demodulates windows of `length` samples, one after the other, at the fixed carrier
// choice.prepared.f0_hz (WindowMean). Times count from the start of the recording. Windows with
// missing or clipped samples and those over a lost sample are left out; the time after lost
// samples counts them; where the phase leaves their number open it counts the smallest, and
// PhasorRun::breaks names the place. Windows before the free decay are left out, too: all up to
// the strike where a window before it has less than a thousandth of its power, and, after a
// band-pass, as much again as the filter reaches, through which a strike still rings. The angle of
// the first electrode is subtracted.
//
// The deviations are those of the noise at the carrier: of the windows' residual where the noise is
// white, else of the density between the lines (CarrierLines), after a band-pass with the part of a
// window's bandwidth that it passes. A window whose residual stands out has a
// deviation in proportion.
//
// Precondition: the plan's windows lie in the prepared range, hop = length, at least
// least_phasor_window(). Errors: those of the source, no_valid_samples where no window is left,
// every_window_clipped where clipping leaves none, interrupted. The result is the same to the last
// bit for any number of threads. It has no name yet.
Result<RecordedRun> phasor_windows(const WindowChoice& choice, double rate_hz, int threads,
                                   const JobControl& job);

}  // namespace vybeg
