#pragma once

#include "core/numerics/statistics.h"
#include "ui/plots/plot_file.h"
#include "ui/values/zoom_state.h"
#include "ui/widgets/theme.h"

#include <QFont>
#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

class QCustomPlot;

namespace vybeg::ui {

// Points with their standard deviations, or a line with its band; as many sd as points, or none.
struct XYSeries {
    QString name{};  // in the legend; empty: not in it
    int style = 0;   // of curveStyle(): colour, and the shape of points
    int shades = 0;  // beyond that of the style
    Ink ink = Ink::style;
    bool points = false;
    bool steps = false;  // a line of steps centred at the values
    bool thin = false;   // a line of one pixel, quick for thousands of values
    bool dashed = false;
    std::vector<double> x{};
    std::vector<double> y{};
    std::vector<double> sd{};
};

// A dashed line.
XYSeries dashedLine(const QString& name, Ink ink, std::vector<double> x = {},
                    std::vector<double> y = {});
// The counts of a histogram at the middle of their bins, as steps that fall to zero at both ends.
XYSeries histogramSteps(const Histogram& histogram, const QString& name, Ink ink);

// The normal curve of zero mean and unit deviation, over so much area.
XYSeries normalCurve(const QString& name, double area, int points);

// A mark on one point of a series.
XYSeries markOn(const XYSeries& points, std::size_t point, Ink ink);

// A plot of one quantity against another, as a value, for screen and paper. An underscore in a name
// introduces an index.
struct XYPlot {
    QString x_name{};
    QString x_unit{};
    bool x_in_degrees = false;
    bool x_is_date = false;              // seconds since 1970, UTC
    bool x_logarithmic = false;          // values at and below 0 are not drawn
    std::optional<AxisRange> x_range{};  // otherwise the range of the series
    bool x_below = false;                // the plot below has the same x axis and names it
    QString y_name{};
    QString y_unit{};
    bool y_takes_prefix = false;
    bool y_logarithmic = false;
    std::optional<AxisRange> y_range{};  // as x_range
    bool turned = false;                 // x along the left axis, y along the lower one
    int least_head = 0;                  // pixels above the frame, as of a plot beside it
    std::vector<XYSeries> series{};
    // Not empty: the curves are named at their right ends, with room for all of these: the names of
    // this plot and of one with the same x axis. Where they have none, a legend names the curves.
    QStringList names_at_ends{};
    QString empty{};  // text shown without series
};

// The ranges of x and y that are shown.
AxisRange shownPlaces(const XYPlot& content);
AxisRange shownValues(const XYPlot& content);

// Pixels above the frame of a plot of that width: the name of an axis, beside or below the legend.
int headOf(const XYPlot& content, const QFont& font, int width);
// Replaces the content of a plot of size `size`.
void layOutXYPlot(QCustomPlot& plot, const XYPlot& content, const Theme& theme, QSize size);

// A plot in the light theme.
Drawing xyDrawing(const XYPlot& content);

}  // namespace vybeg::ui
