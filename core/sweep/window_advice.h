#pragma once

#include "core/sweep/window_sweep.h"

#include <optional>
#include <span>

namespace vybeg {

// The length at which the largest loss is least. The loss of a variable is its expected error
// (SweepValue::error()) over the least one in the list: errors of different units become
// comparable, and no variable is sacrificed. Of lengths of nearly the same loss it is the shortest.
// A variable that has no error in most lengths does not count, nor a length in which another
// variable has none. `lengths` ascend. Nothing for fewer than two lengths.
std::optional<WindowAdvice> advise_window(std::span<const SweepLength> lengths);

}  // namespace vybeg
