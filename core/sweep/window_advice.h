#pragma once

#include "core/sweep/window_sweep.h"

#include <optional>
#include <span>

namespace vybeg {

// The length at which the largest loss is least. The loss of a variable is its expected error
// (SweepValue::error()) over the least one in the list: errors of different units become
// comparable, and no variable is sacrificed. Variables without an error at some length do not
// count. `lengths` ascend. Nothing for fewer than two lengths or without a variable.
std::optional<WindowAdvice> advise_window(std::span<const SweepLength> lengths);

}  // namespace vybeg
