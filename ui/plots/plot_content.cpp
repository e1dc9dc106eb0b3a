#include "ui/plots/plot_content.h"

#include <algorithm>
#include <cmath>

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

ZoomState clipped(ZoomState state, const std::vector<ShownAnalysis>& analyses,
                  const RecordedTime& recorded) {
    const AxisRange full = coveredTime(analyses).value_or(recorded.range);
    AxisRange& time = state.time;
    // Least span of four samples, the resolution of a track.
    double least = 1e-6 * full.span();
    const auto resolve = [&](double rate_hz) {
        if (rate_hz > 0) {
            least = std::min(least, 4 / rate_hz);
        }
    };
    resolve(recorded.rate_hz);
    for (const ShownAnalysis& shown : analyses) {
        resolve(shown.rate_hz);
    }
    const double span = std::clamp(time.span(), std::min(least, full.span()), full.span());
    const double centre = 0.5 * (time.lower + time.upper);
    // A range that only lies too far out is shifted at its edge, not through its centre, so that it
    // keeps its last bit and the history recognises it.
    if (span != time.span()) {
        time = {centre - 0.5 * span, centre + 0.5 * span};
    }
    if (time.lower < full.lower) {
        time = {full.lower, std::min(full.upper, full.lower + span)};
    } else if (time.upper > full.upper) {
        time = {std::max(full.lower, full.upper - span), full.upper};
    }
    std::erase_if(state.fixed, [](const auto& entry) {
        const AxisRange& range = entry.second;
        return !(range.span() > 0) || !std::isfinite(range.span());
    });
    return state;
}

double referenceFrequency(const std::vector<ShownAnalysis>& analyses) {
    const auto first =
        std::find_if(analyses.begin(), analyses.end(), [](const ShownAnalysis& shown) {
            return shown.visible && shown.analysis && shown.analysis->settings.f0_hz &&
                   std::isfinite(shown.analysis->f0_hz());
        });
    return first == analyses.end() ? 0 : first->analysis->f0_hz();
}

}  // namespace vybeg::ui
