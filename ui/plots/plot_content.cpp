#include "ui/plots/plot_content.h"

#include <algorithm>

namespace vybeg::ui {

std::optional<AxisRange> coveredTime(const std::vector<Run>& runs) {
    std::optional<AxisRange> covered;
    for (const Run& run : runs) {
        if (!run.visible || !run.analysis || run.analysis->track.rows() == 0) {
            continue;
        }
        const auto times = run.analysis->track.time_s();
        // From the first window's first sample to the last one's last.
        const double half =
            run.rate_hz > 0
                ? 0.5 * static_cast<double>(run.analysis->settings.window - 1) / run.rate_hz
                : 0;
        const AxisRange own{times.front() - half, times.back() + half};
        covered = covered ? AxisRange{std::min(covered->lower, own.lower),
                                      std::max(covered->upper, own.upper)}
                          : own;
    }
    if (covered && covered->span() <= 0) {
        covered = AxisRange{covered->lower - 0.5, covered->upper + 0.5};  // a single window
    }
    return covered;
}

double referenceFrequency(const std::vector<Run>& runs) {
    const auto first = std::find_if(runs.begin(), runs.end(), [](const Run& run) {
        return run.visible && run.analysis && run.analysis->settings.f0_hz;
    });
    return first == runs.end() ? 0 : first->analysis->f0_hz();
}

}  // namespace vybeg::ui
