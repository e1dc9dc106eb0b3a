#pragma once

#include "ui/plots/panel_frame.h"
#include "ui/plots/plot_file.h"
#include "ui/signals/signal_picture.h"

#include <qcustomplot.h>

#include <vector>

namespace vybeg::ui {

// A text of the plots of the signals in the language of the window.
QString signalsText(const char* text);

class PlotStrip;
class SignalPanel;

// The plots of the signals over one time axis, with a legend above: the layout of a QCustomPlot,
// on screen and on paper. The QCustomPlot owns the elements and goes first.
class SignalStack {
public:
    // On the screen without a legend: the overlay says what the curves are.
    SignalStack(QCustomPlot& plot, const std::vector<SignalPart>& parts, PlotHead head);

    // Everything for a plot of that size, device-independent pixels.
    void setContent(SignalContent content, QSize size);

    const SignalContent& content() const { return content_; }
    const SignalPicture& picture() const { return picture_; }
    const std::vector<SignalPanel*>& panels() const { return panels_; }
    // Frames of the panels, for hair lines.
    std::vector<QCPAxisRect*> frames() const;
    // Width of the frames in a plot of that width.
    int frameWidth(int width) const;

private:
    void showLegend();
    void nameTime();

    QCustomPlot& plot_;
    SignalContent content_;
    SignalPicture picture_;
    PlotHead head_;
    PlotStrip* legend_;  // on the screen a gap
    PlotStrip* time_name_;
    std::vector<SignalPanel*> panels_;
    QObject context_;  // of the connection to the plot
};

// A figure of some plots in the light theme, with its proposed size.
Figure signalFigure(SignalContent content, const std::vector<SignalPart>& parts);

}  // namespace vybeg::ui
