#pragma once

#include "ui/values/shown_analysis.h"
#include "ui/values/zoom_state.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <optional>
#include <vector>

namespace vybeg::ui {

// Content of a stack of plots, common to screen, exported image and figure.
struct PlotContent {
    std::vector<ShownAnalysis> analyses;
    std::vector<SlowVariable> variables{main_slow_variables.begin(), main_slow_variables.end()};
    DisplayUnits units;
    Theme theme = lightTheme();
    ZoomState zoom;
    std::vector<double> marks_s;  // rising
    std::vector<TrendCurve> trends;
    int unlike = 0;  // analyses that drawnWith() has hidden
};

// Hides the analyses that cannot be drawn over the chosen one, because their recordings have
// another unit or five times its length or more: one would be a pixel, or flatten the others. Where
// the chosen one is hidden, the first visible one takes its place. Returns how many it hides.
int drawnWith(AnalysisId chosen, std::vector<ShownAnalysis>& analyses);

// Time range of the visible analyses, from the first to the last sample of their windows; empty
// without a visible window.
std::optional<AxisRange> coveredTime(const std::vector<ShownAnalysis>& analyses);

}  // namespace vybeg::ui
