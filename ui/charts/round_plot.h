#pragma once

#include "ui/plots/plot_file.h"
#include "ui/widgets/theme.h"

#include <QString>

#include <vector>

class QChart;

namespace vybeg::ui {

// A curve or points of a round plot.
struct RoundSeries {
    QString name;  // in the legend, an underscore introduces an index; empty: not in it
    Ink ink = Ink::style;
    QColor color;  // for Ink::style, before it is made readable
    int shade = 0;
    bool points = false;
    bool dashed = false;
    double width = 1.6;
    std::vector<double> x;  // polar: angle, degrees
    std::vector<double> y;  // polar: radius
};

// A plot around an origin, as a value, for screen and paper: polar, 0 degrees at the top and
// clockwise, or a square of two axes of the same scale.
struct RoundPlot {
    bool polar = true;
    double reach = 1;   // largest radius, or half the side of the square
    bool scale = true;  // whether the radius has numbers
    QString x_name;     // of the square
    QString y_name;
    std::vector<RoundSeries> series;
    QString empty;  // text shown without series
};

// The names of a plot's series with their colours, as HTML that wraps between them: Qt's own legend
// cuts names where room is short. Empty without names.
QString legendOf(const RoundPlot& content, const Theme& theme);

// Makes a chart of makeRoundChart() show a plot at the chart's size. Curves that are there already
// are moved.
void fillRoundChart(QChart& chart, const RoundPlot& content, const Theme& theme);
// The caller owns it.
QChart* makeRoundChart(bool polar);

inline constexpr QSize round_paper_size{480, 480};

// A plot in the light theme.
Drawing roundDrawing(const RoundPlot& content);

}  // namespace vybeg::ui
