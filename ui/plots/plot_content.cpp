#include "ui/plots/plot_content.h"

#include <algorithm>

namespace vybeg::ui {

int drawnWith(AnalysisId chosen, std::vector<ShownAnalysis>& analyses) {
    constexpr double alike = 5;
    auto first = std::ranges::find_if(analyses, [chosen](const ShownAnalysis& shown) {
        return shown.visible && shown.id == chosen;
    });
    if (first == analyses.end()) {
        first = std::ranges::find_if(analyses, &ShownAnalysis::visible);
    }
    if (first == analyses.end()) {
        return 0;
    }
    const ShownAnalysis by = *first;
    int hidden = 0;
    for (ShownAnalysis& shown : analyses) {
        const auto [less, more] = std::minmax(by.recorded_s, shown.recorded_s);
        if (shown.visible && (shown.unit != by.unit || (less > 0 && more >= alike * less))) {
            shown.visible = false;
            ++hidden;
        }
    }
    return hidden;
}

std::optional<AxisRange> coveredTime(const std::vector<ShownAnalysis>& analyses) {
    std::optional<AxisRange> covered;
    for (const ShownAnalysis& shown : analyses) {
        if (!shown.visible || !shown.analysis || shown.analysis->track.rows() == 0) {
            continue;
        }
        const auto times = shown.analysis->track.time_s();
        // From the first window's first sample to the last one's last.
        const double half =
            shown.rate_hz > 0
                ? 0.5 * static_cast<double>(shown.analysis->settings.window - 1) / shown.rate_hz
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

}  // namespace vybeg::ui
