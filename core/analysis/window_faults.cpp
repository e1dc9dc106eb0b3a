#include "core/analysis/window_faults.h"

#include <algorithm>

namespace vybeg {
namespace {

// Quotient rounded down, for b > 0.
std::int64_t floor_div(std::int64_t a, std::int64_t b) {
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

// Adds the windows that begin before frame `before` and end after frame `after`, the frame behind
// their last one.
void add_windows(std::int64_t before, std::int64_t after, Flag flag, const WindowPlan& plan,
                 std::vector<FlaggedRows>& flagged) {
    const std::int64_t first =
        std::max<std::int64_t>(floor_div(after - plan.length - plan.first, plan.hop) + 1, 0);
    const std::int64_t end = std::min(floor_div(before - 1 - plan.first, plan.hop) + 1, plan.count);
    if (!flagged.empty() && flagged.back().flag == flag) {
        FlaggedRows& last = flagged.back();
        const auto last_end = static_cast<std::int64_t>(last.first + last.count);
        if (first <= last_end) {
            if (end > last_end) {
                last.count = static_cast<std::size_t>(end) - last.first;
            }
            return;
        }
    }
    if (first < end) {
        flagged.push_back(
            {static_cast<std::size_t>(first), static_cast<std::size_t>(end - first), flag});
    }
}

}  // namespace

std::vector<FlaggedRows> windows_over(const SampleFaults& faults, const WindowPlan& plan) {
    std::vector<FlaggedRows> flagged;
    for (const FrameRange& range : faults.clipped) {
        add_windows(range.end(), range.first, Flag::clipped, plan, flagged);
    }
    for (const PhaseStep& step : faults.steps) {
        add_windows(step.frame, step.frame, Flag::gap, plan, flagged);
    }
    std::ranges::stable_sort(flagged, {}, &FlaggedRows::first);
    return flagged;
}

std::vector<FlaggedRows> moving_apart(const std::vector<FlaggedRows>& moving,
                                      const std::vector<FlaggedRows>& over_faults,
                                      const WindowPlan& plan) {
    const auto reach = static_cast<std::size_t>((2 * plan.length + plan.hop - 1) / plan.hop);
    std::vector<FlaggedRows> apart;
    for (const FlaggedRows& rows : moving) {
        std::size_t first = rows.first;
        const std::size_t end = rows.first + rows.count;
        for (const FlaggedRows& fault : over_faults) {
            const std::size_t from = fault.first - std::min(fault.first, reach);
            const std::size_t to = fault.first + fault.count + reach;
            if (to <= first || from >= end) {
                continue;
            }
            if (from > first) {
                apart.push_back({first, from - first, rows.flag});
            }
            first = std::min(to, end);
        }
        if (first < end) {
            apart.push_back({first, end - first, rows.flag});
        }
    }
    return apart;
}

}  // namespace vybeg
