#pragma once

#include "core/analysis/analysis.h"
#include "core/track/track.h"
#include "ui/values/curve_data.h"
#include "ui/values/ids.h"

#include <QColor>
#include <QString>

#include <algorithm>
#include <memory>
#include <vector>

namespace vybeg::ui {

// One analysis for display: a row of the analysis list, a curve in every plot. A value; copies
// share the analysis.
struct ShownAnalysis {
    AnalysisId id = AnalysisId::none;  // unique in a document
    QString name;
    QString recording;  // name of the file
    QColor color;       // of the recording, see theme.h
    int shade = 0;      // of the analyses of that colour
    QString unit;       // of the channels; empty: not known, or two
    bool visible = true;
    double rate_hz = 0;
    double recorded_s = 0;  // length of the recording; 0: not known
    std::shared_ptr<const Analysis> analysis;
    Curves curves;  // of the analysis; computed on drawing if empty

    // The values of an angle on the branch of `scale`, computed on drawing where it has one.
    std::shared_ptr<const CurveData> curve(SlowVariable variable,
                                           const DisplayScale& scale = {}) const {
        const auto made = std::ranges::find_if(
            curves, [variable](const auto& each) { return each->variable() == variable; });
        return made == curves.end() || scale.period > 0
                   ? std::make_shared<const CurveData>(analysis, variable, scale)
                   : *made;
    }
};

// A fitted curve over one plot: displayed units against seconds.
struct TrendCurve {
    AnalysisId of = AnalysisId::none;
    SlowVariable variable = SlowVariable::a_A;
    std::vector<double> time_s;
    std::vector<double> value;

    friend bool operator==(const TrendCurve&, const TrendCurve&) = default;
};

}  // namespace vybeg::ui
