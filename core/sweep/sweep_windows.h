#pragma once

#include "core/analysis/settings.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/samples/recording.h"
#include "core/sweep/window_sweep.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vybeg {

inline constexpr int sweep_steps = 15;

// Whole numbers from `first` to `last` in about equal ratios, ascending, each once. Precondition:
// 1 <= first <= last, steps >= 2.
std::vector<std::int64_t> spaced_lengths(std::int64_t first, std::int64_t last,
                                         int steps = sweep_steps);

// The algorithm of the settings in adjacent windows of each length; with `snap` each is moved to
// whole half-periods. The settings' window, periods and hop do not count. One preparation serves
// all lengths; up to 2^24 frames are held in memory, more are read again for each length. The
// result is the same to the last bit for any number of threads. Errors: setting_invalid, those of
// prepare() and of the source; that of a length where no length of the list is possible;
// interrupted.
Result<WindowSweep> sweep_windows(const Recording& recording, const Settings& settings,
                                  std::span<const std::int64_t> lengths, const JobControl& job);

}  // namespace vybeg
