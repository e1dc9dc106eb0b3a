#pragma once

#include "core/analysis/prepare.h"
#include "core/resonator/phasor_run.h"
#include "core/windows/window_plan.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace vybeg {

// The phasors of one recording, for the identification of its resonator (METHOD section 8).
struct PhasorWindows {
    PhasorRun run;                        // those of the windows that count
    WindowPlan plan;                      // of all windows
    double noise_sd = 0;                  // per sample and channel, recording units
    std::vector<Diagnostic> diagnostics;  // of the preparation and of the samples
    double read_s = 0;
    double estimate_s = 0;  // summed over the threads, divided by their number
};

// Least window of an identification: 16 samples and two periods, so that six numbers a channel
// leave a residual.
std::int64_t least_phasor_window(double f0_hz, double rate_hz);

// The window where the engineer gives none: 15 ms, twelve periods of the carrier at least. That is
// short against the beat of a split of 10 Hz and against the decay of a bell. Shorter where the
// range holds fewer than 64 of them, longer where it holds more than 16384: memory does not grow
// with the recording.
std::int64_t default_phasor_window(std::int64_t frames, double f0_hz, double rate_hz);

// Demodulates windows of `length` samples, one after the other, at the fixed carrier
// prepared.f0_hz. In each, a channel is fitted by
//     sum over k = 0, 1, 2 of P_k(t) (A_k cos wt + B_k sin wt),
// P_k the orthogonal polynomials of the window: A_0 - i B_0 is the phasor's mean over the window,
// free of what its slope and curvature leave of the image at 2w, and what is not noise (beats, a
// frequency beside the carrier, decay) does not count as noise. Times count from the start of the
// recording. Windows with missing or clipped samples and those over a lost sample are left out; the
// time behind lost samples counts them; where the phase does not tell their number it counts the
// smallest, and PhasorRun::phase_breaks_s names the place. Left out is also what is no free decay
// yet: all up to the strike where a window before it has less than a thousandth of its power, and,
// behind a band-pass, as much again as the filter reaches, through which a strike still rings. The
// angle of the first electrode is subtracted.
//
// Precondition: the plan's windows lie in the prepared range, hop = length, at least
// least_phasor_window(). Errors: those of the source, no_valid_samples where no window is left,
// every_window_clipped where clipping leaves none, interrupted. The result is the same to the last
// bit for any number of threads.
Result<PhasorWindows> phasor_windows(const Prepared& prepared, const WindowPlan& plan,
                                     double rate_hz, int threads, const JobControl& job);

}  // namespace vybeg
