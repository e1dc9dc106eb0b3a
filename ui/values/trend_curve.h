#pragma once

#include "core/track/slow_variables.h"
#include "ui/values/ids.h"

#include <vector>

namespace vybeg::ui {

// A fitted curve over one plot: displayed units against seconds.
struct TrendCurve {
    AnalysisId of = AnalysisId::none;
    SlowVariable variable = SlowVariable::a_A;
    std::vector<double> time_s;
    std::vector<double> value;

    friend bool operator==(const TrendCurve&, const TrendCurve&) = default;
};

}  // namespace vybeg::ui
