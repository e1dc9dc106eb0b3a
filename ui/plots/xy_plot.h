#pragma once

#include "core/base/result.h"
#include "ui/values/zoom_stack.h"
#include "ui/widgets/theme.h"

#include <QImage>
#include <QSize>
#include <QString>

#include <optional>
#include <vector>

class QCustomPlot;

namespace vybeg::ui {

// Points with their standard deviations, or a line with its band; as many sd as points, or none.
struct XYSeries {
    QString name;   // in the legend; empty: not in it
    int style = 0;  // of runStyle(): colour, dash, and the shape of points
    bool points = false;
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> sd;
    bool plain = false;  // a line in the colour of the text
    bool dashed = false;
};

// A plot of one quantity against another, as a value, for screen and paper. An underscore in a name
// introduces an index.
struct XYPlot {
    QString x_name;
    QString x_unit;
    bool x_in_degrees = false;
    std::optional<AxisRange> x_range;  // otherwise the range of the series
    QString y_name;
    QString y_unit;
    bool y_takes_prefix = false;
    std::vector<XYSeries> series;
    QString empty;  // text shown without series
};

// Replaces the content of a plot of size `size`.
void layOutXYPlot(QCustomPlot& plot, const XYPlot& content, const Theme& theme, QSize size);

// Size of an exported figure of one plot, independent of the window.
inline constexpr QSize xy_paper_size{640, 420};

// Exports a plot in the light theme, format by the ending of the path: .png, .svg, .pdf. Errors:
// output_format_unknown, output_failed.
Status exportXYPlot(const XYPlot& content, QSize size, const QString& path);
QImage xyPlotImage(const XYPlot& content, QSize size);

}  // namespace vybeg::ui
