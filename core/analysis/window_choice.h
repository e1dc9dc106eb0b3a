#pragma once

#include "core/analysis/carrier_lines.h"
#include "core/analysis/identify_settings.h"
#include "core/analysis/prepare.h"
#include "core/windows/window_plan.h"

#include <cstdint>
#include <optional>

namespace vybeg {

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
