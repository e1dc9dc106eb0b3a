#pragma once

#include "core/analysis/identify_settings.h"
#include "core/analysis/prepare.h"
#include "core/windows/window_plan.h"

#include <cstdint>
#include <limits>
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
// where the engineer gave f0 and no line stands there, fit_window_too_short, window_too_long,
// fit_window_turns where a window that the engineer chose turns by more than a quarter,
// fit_beat_too_fast where two periods are too long.
Result<WindowChoice> choose_windows(const Recording& recording, const SignalSettings& settings,
                                    const PhasorWindowSettings& wished, const JobControl& job);

}  // namespace vybeg
