#include "core/sweep/window_lengths.h"

#include <cmath>

namespace vybeg {

std::vector<std::int64_t> spaced_lengths(std::int64_t first, std::int64_t last, int steps) {
    std::vector<std::int64_t> lengths;
    const double ratio = static_cast<double>(last) / static_cast<double>(first);
    for (int k = 0; k < steps; ++k) {
        const double share = static_cast<double>(k) / (steps - 1);
        const auto length = static_cast<std::int64_t>(
            std::llround(static_cast<double>(first) * std::pow(ratio, share)));
        if (lengths.empty() || length > lengths.back()) {
            lengths.push_back(length);
        }
    }
    return lengths;
}

}  // namespace vybeg
