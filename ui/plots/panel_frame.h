#pragma once

#include "ui/plots/panel_ticker.h"
#include "ui/widgets/theme.h"

#include <qcustomplot.h>

namespace vybeg::ui {

// A full frame with ticks at the left and bottom only, on the layers of preparePlot(). Labels under
// the frame lie outside its margins.
void addFrame(QCPAxisRect& panel, const QSharedPointer<PanelTicker>& x,
              const QSharedPointer<PanelTicker>& y);

void setFrameLook(QCPAxisRect& panel, const Theme& theme, const QFont& tick_font);

// The font of tick labels beside texts of a font.
QFont tickFont(const QFont& font);

// Where symbol and unit of a plot stand: on the screen in the left margin, on paper above it.
enum class PlotHead { margin, line };

// Pixels around the frames of stacked plots.
struct FrameRoom {
    int left = 60;  // at least
    int head = 21;  // of the line above a frame
    int right = 16;
    int foot = 3;
};
FrameRoom frameRoom(PlotHead head);

// A line in the left margin of a plot: symbol, offset of the axis, unit.
struct MarginLine {
    QString text;  // an underscore introduces an index
    bool muted = false;
    double width = 0;
};

std::vector<MarginLine> marginLines(const QString& symbol, const QString& offset,
                                    const QString& unit, const QFont& font);
// The margin that lines of text need.
int marginOf(const std::vector<MarginLine>& lines);
void drawMarginLines(QCPPainter& painter, const QCPAxisRect& panel,
                     const std::vector<MarginLine>& lines, const Theme& theme, const QFont& font);
// The frame of one of stacked plots over one time axis, with its margins. On the screen tick labels
// leave room for the lines in the margin and the name of the time axis; `font` outlives the panel.
void addStackedFrame(QCPAxisRect& panel, const QSharedPointer<PanelTicker>& time,
                     const QSharedPointer<PanelTicker>& values, PlotHead head,
                     std::function<std::vector<MarginLine>(const AxisTicks&)> lines,
                     const QFont& font);

}  // namespace vybeg::ui
