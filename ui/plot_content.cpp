#include "ui/plot_content.h"

#include <algorithm>

namespace vybeg::ui {

std::optional<AxisRange> coveredTime(const std::vector<Run>& runs) {
    std::optional<AxisRange> covered;
    for (const Run& run : runs) {
        if (!run.visible || !run.analysis || run.analysis->track.rows() == 0) {
            continue;
        }
        const auto times = run.analysis->track.time_s();
        const AxisRange own{times.front(), times.back()};
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
