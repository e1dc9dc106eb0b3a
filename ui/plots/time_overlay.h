#pragma once

#include "ui/plots/time_stack.h"

#include <optional>

namespace vybeg::ui {

class TimeGestures;

// Items that move with the mouse, on a separate layer, so that the curves below are not drawn
// again: the hair lines of the tracker and the two cursors, the rubber band.
class TimeOverlay : public QCPLayerable {
public:
    TimeOverlay(QCustomPlot* plot, const TimeStack& stack, const TimeGestures& view);

    void setBand(std::optional<QRectF> band) { band_ = band; }

protected:
    const TimeGestures& view() const { return view_; }

    void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
    void draw(QCPPainter* painter) override;

private:
    void drawHair(QCPPainter& painter, std::optional<double> time_s, const QColor& color,
                  const QString& name) const;

    const TimeStack& stack_;
    const TimeGestures& view_;
    std::optional<QRectF> band_;
};

}  // namespace vybeg::ui
