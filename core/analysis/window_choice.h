#pragma once

#include "core/analysis/identify_settings.h"
#include "core/analysis/prepare.h"
#include "core/windows/window_plan.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace vybeg {

// What the spectrum shows around the carrier of a recording: the lines of its modes, the density
// of the noise between them, and the lines of the mains.
struct CarrierLines {
    // The modes' lines, Hz. All three are f0 where no line stands out.
    double strongest_hz = 0;
    double lowest_hz = 0;
    double highest_hz = 0;
    bool found = false;
    // Variance per sample and channel of the white noise that has the density found beside the
    // carrier, and its relative standard deviation; the median over segments. NaN where the
    // samples are too few.
    double noise_power = std::numeric_limits<double>::quiet_NaN();
    int segments = 0;  // that it was found in
    double relative_sd = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> mains_hz;
};

// Looks at up to 32 segments of the prepared range, each of 64 windows (`window` samples) where
// the range is long enough, with a Kaiser window whose side lobes of -150 dB keep an offset and
// other modes out of the carrier's surroundings. A line is a peak of the mean spectrum
// that stands above its noise and above 1e-7 of the strongest one. The modes' lines are those
// within 80 Hz (at most an eighth of the carrier, and within the band-pass) of the strongest line
// of the main lobe around f0; where the main lobe has none and the engineer gave f0, of the
// strongest line within 400 Hz (at most a third of f0). Errors: those of the source,
// carrier_not_near where the engineer gave f0 and no line stands there, interrupted.
Result<CarrierLines> carrier_lines(const ConditionedRecording& prepared,
                                   const SignalSettings& settings, std::int64_t window,
                                   double rate_hz, const JobControl& job);

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
// frequency of demodulation moves to the middle of the modes' lines (carrier_lines()), and a window
// that the engineer did not choose is shortened. Errors: those of prepare() and carrier_lines(),
// fit_window_too_short, window_too_long, fit_window_turns where a window that the engineer chose
// turns by more than a quarter, fit_beat_too_fast where two periods are too long.
Result<WindowChoice> choose_windows(const Recording& recording, const SignalSettings& settings,
                                    const PhasorWindowSettings& wished, const JobControl& job);

}  // namespace vybeg
