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

// 15 whole numbers from `first` to `last` in about equal ratios, ascending, each once: fewer where
// they lie close. Precondition: 1 <= first <= last.
std::vector<std::int64_t> spaced_lengths(std::int64_t first, std::int64_t last);

// The algorithm of the settings in adjacent windows of each length; with `snap` each is moved to
// whole half-periods. The settings' window, periods and hop do not count. One preparation serves
// all lengths; up to 2^24 frames are held in memory, more are read again for each length. The
// result is the same to the last bit for any number of threads. Errors: setting_invalid, those of
// prepare() and of the source; that of a length where no length of the list is possible;
// interrupted.
Result<WindowSweep> sweep_windows(const Recording& recording, const Settings& settings,
                                  std::span<const std::int64_t> lengths, const JobControl& job);

}  // namespace vybeg
