#pragma once

#include "ui/plots/time_panel.h"

#include <optional>
#include <vector>

namespace vybeg::ui {

class PlotStrip;
// Plots over each other on one time axis, in one column of a QCustomPlot's layout, with a row of
// texts above them and the name of the time below: on the screen, on paper and in figures. The
// QCustomPlot owns the elements; preparePlot() comes first.
class TimeStack {
public:
    // `head` is the same for all columns of a figure.
    TimeStack(QCustomPlot& plot, int column, PlotHead head);
    TimeStack(const TimeStack&) = delete;
    TimeStack& operator=(const TimeStack&) = delete;
    virtual ~TimeStack() = default;

    // From above.
    const std::vector<TimePanel*>& frames() const { return frames_; }
    const Theme& theme() const { return theme_; }
    // The one at a position of the plot, its head included; null beside them.
    TimePanel* frameAt(const QPointF& position) const;
    // Width of the frames in a plot of that width.
    int frameWidth(int width) const;
    // Size of this column (device-independent pixels) in the next layout, from which tick steps and
    // the resolution of curves follow. Call it before every layout of another size.
    void prepare(QSize size);

    QCustomPlot& plot() const { return plot_; }

protected:
    PlotHead head() const { return head_; }
    // Replaces the elements of the column.
    void build(std::vector<TimePanel*> frames);
    // The row of texts above the plots, after build(); on the screen a gap.
    PlotStrip& headStrip() { return *head_strip_; }
    void setLook(const Theme& theme);

private:
    void nameTime();

    QCustomPlot& plot_;
    int column_;
    PlotHead head_;
    Theme theme_;
    PlotStrip* head_strip_ = nullptr;
    PlotStrip* time_strip_ = nullptr;
    std::vector<TimePanel*> frames_;
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
