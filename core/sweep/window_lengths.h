#pragma once

#include <cstdint>
#include <vector>

namespace vybeg {

inline constexpr int sweep_steps = 15;

// Whole numbers from `first` to `last` in about equal ratios, ascending, each once. Precondition:
// 1 <= first <= last, steps >= 2.
std::vector<std::int64_t> spaced_lengths(std::int64_t first, std::int64_t last,
                                         int steps = sweep_steps);

}  // namespace vybeg
