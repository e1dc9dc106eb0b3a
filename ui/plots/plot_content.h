#pragma once

#include "ui/values/run.h"
#include "ui/values/zoom_stack.h"
#include "ui/widgets/theme.h"
#include "ui/words/display_units.h"

#include <optional>
#include <vector>

namespace vybeg::ui {

// A fitted curve over one plot: displayed units against seconds.
struct TrendCurve {
    SlowVariable variable = SlowVariable::a_A;
    std::vector<double> time_s;
    std::vector<double> value;
};

// All that a stack of plots shows: what the screen, an exported image and a figure have in common.
struct PlotContent {
    std::vector<Run> runs;
    std::vector<SlowVariable> variables{main_slow_variables.begin(), main_slow_variables.end()};
    DisplayUnits units;
    Theme theme = lightTheme();
    ZoomState zoom;
    std::vector<double> marks_s;  // rising
    std::optional<TrendCurve> trend;
};

// All that the visible runs cover, first to last sample of their windows; nothing without a visible
// window.
std::optional<AxisRange> coveredTime(const std::vector<Run>& runs);

// A view with its time range inside what the visible runs cover, and with sound value ranges.
ZoomState clipped(ZoomState state, const std::vector<Run>& runs);

// What frequency deviations are counted from: the carrier of the first visible run, or 0.
double referenceFrequency(const std::vector<Run>& runs);

}  // namespace vybeg::ui
