#pragma once

#include "ui/plots/plot_content.h"
#include "ui/plots/plot_panel.h"

#include <qcustomplot.h>

#include <vector>

namespace vybeg::ui {

class PlotStrip;

// A column of plots over one time axis, in one column of a QCustomPlot's layout: part of the track
// view, its exports and the article's figure. The QCustomPlot owns the elements; before the first
// stack the caller clears its layout.
class PlotStack {
public:
    enum class Head { none, analysis_names, title };

    // `head`: kind of the row above the plots, the same for all columns of a figure. Without one
    // the stack is that of the screen: symbols in the margin, one row below the plots.
    PlotStack(QCustomPlot& plot, int column, Head head);

    // Rebuilds the panels if the variables have changed; sets zoom and value axes.
    void setContent(const PlotContent& content);
    void setTitle(const QString& title);
    // Instants marked in all plots, s, in rising order.
    void setMarks(const std::vector<double>& times_s);
    // Sets time and value axes; value axes that are not fixed follow the visible data.
    void setZoom(const ZoomState& zoom);
    // Size of this column (device-independent pixels) in the next layout, from which tick steps and
    // the resolution of curves follow. Call it before setZoom() and before every layout of another
    // size.
    void prepare(QSize size);

    const std::vector<PlotPanel*>& panels() const { return panels_; }
    PlotPanel* panel(SlowVariable variable) const;
    // Plot at a position, including its head line.
    PlotPanel* panelAt(const QPointF& position) const;

private:
    void build(const PlotContent& content);
    PlotHead plotHead() const;
    void removeElements();
    void nameTime();

    QCustomPlot& plot_;
    int column_;
    Head head_;
    PlotStrip* head_strip_ = nullptr;
    PlotStrip* time_strip_ = nullptr;
    std::vector<PlotPanel*> panels_;
    PlotContent content_;
    QPointer<QCPMarginGroup> margins_;
    QObject context_;  // context of the connections to the plot, which outlives the stack
};

// A QCustomPlot without its default axes, with the layers that a stack needs and the theme's
// background.
void preparePlot(QCustomPlot& plot, const Theme& theme);

// The font of everything in plots: that of the widgets, with its size in pixels so that screens,
// pictures and files agree.
QFont plotFont(const QWidget& widget);

}  // namespace vybeg::ui
