#pragma once

#include "core/analysis/analysis.h"
#include "ui/values/curve_data.h"
#include "ui/values/ids.h"

#include <QColor>
#include <QString>

#include <memory>

namespace vybeg::ui {

// One analysis for display: a row of the analysis list, a curve in every plot. A value; copies
// share the analysis.
struct ShownAnalysis {
    AnalysisId id = AnalysisId::none;  // unique in a document
    QString name;
    QString recording;  // name of the file
    QColor color;       // Okabe-Ito, see theme.h
    Qt::PenStyle dash = Qt::SolidLine;
    bool visible = true;
    double rate_hz = 0;
    double seconds_taken = 0;  // estimators only
    std::shared_ptr<const Analysis> analysis;
    Curves curves;  // of the analysis; computed on drawing if empty
};

}  // namespace vybeg::ui
