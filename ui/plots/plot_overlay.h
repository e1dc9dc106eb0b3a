#pragma once

#include "ui/widgets/theme.h"

#include <qcustomplot.h>

#include <array>
#include <optional>

namespace vybeg::ui {

class PlotPanel;
class PlotStack;

// Items that move with the mouse, on a separate layer, so that the curves below are not drawn
// again: the tracker's hair line with a dot on each curve, the two cursors, the rubber band.
class PlotOverlay : public QCPLayerable {
    Q_OBJECT

public:
    PlotOverlay(QCustomPlot* plot, const PlotStack* stack);

    void setTheme(const Theme& theme) { theme_ = theme; }
    void setTracker(std::optional<double> time_s) { tracker_ = time_s; }
    void setCursors(const std::array<std::optional<double>, 2>& times_s) { cursors_ = times_s; }
    void setRubberBand(std::optional<QRectF> band) { band_ = band; }
    // Text in the middle of an empty view.
    void setHint(const QString& hint) { hint_ = hint; }
    // Number of analyses that are not drawn, told in the corner of the first plot.
    void setUnlike(int count) { unlike_ = count; }

protected:
    void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
    void draw(QCPPainter* painter) override;

private:
    void drawHair(QCPPainter& painter, double time_s, const QColor& color,
                  const QString& name) const;
    void drawDots(QCPPainter& painter, const PlotPanel& panel) const;

    const PlotStack* stack_;
    Theme theme_;
    std::optional<double> tracker_;
    std::array<std::optional<double>, 2> cursors_;
    std::optional<QRectF> band_;
    QString hint_;
    int unlike_ = 0;
};

}  // namespace vybeg::ui
