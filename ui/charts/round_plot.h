#pragma once

#include "ui/plots/plot_file.h"
#include "ui/plots/plot_view.h"
#include "ui/widgets/theme.h"

#include <QString>

#include <vector>

class QChartView;
class QLabel;

namespace vybeg::ui {

// A curve or points of a round plot.
struct RoundSeries {
    QString name{};  // in the legend, an underscore introduces an index; empty: not in it
    Ink ink = Ink::style;
    QColor color{};  // for Ink::style, before it is made readable
    int shade = 0;
    bool points = false;
    bool dashed = false;
    double width = 1.6;
    std::vector<double> x{};  // polar: angle, degrees
    std::vector<double> y{};  // polar: radius
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

inline constexpr QSize round_paper_size{480, 480};

// A plot in the light theme.
Drawing roundDrawing(const RoundPlot& content);

// A round plot in a panel.
class RoundView : public PlotView {
    Q_OBJECT

public:
    explicit RoundView(bool polar, QWidget* parent = nullptr);

    void setContent(const RoundPlot& content);
    // Hidden where the window names the curves already; a figure has a legend all the same.
    void setLegendShown(bool shown);
    const RoundPlot& content() const { return content_; }
    QSize sizeHint() const override { return {260, 260}; }
    Figure figure() const override;

private:
    void rebuild() override;

    QChartView* view_;
    QLabel* legend_;
    bool legend_shown_ = true;
    RoundPlot content_;
};

}  // namespace vybeg::ui
