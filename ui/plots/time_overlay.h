#pragma once

#include "ui/plots/time_stack.h"

#include <functional>
#include <optional>

namespace vybeg::ui {

// Instants on the time axis, seconds.
struct HairLines {
    std::optional<double> cursor_a;
    std::optional<double> cursor_b;
    std::optional<double> tracker;
};

// Items that move with the mouse, on a separate layer, so that the curves below are not drawn
// again: the hair lines of the tracker and the two cursors, the rubber band.
class TimeOverlay : public QCPLayerable {
public:
    TimeOverlay(const TimeStack& stack, std::function<HairLines()> hairs);

    void setBand(std::optional<QRectF> band) { band_ = band; }

protected:
    HairLines hairs() const { return hairs_(); }

    void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
    void draw(QCPPainter* painter) override;

private:
    void drawHair(QCPPainter& painter, std::optional<double> time_s, const QColor& color,
                  const QString& name) const;

    const TimeStack& stack_;
    std::function<HairLines()> hairs_;
    std::optional<QRectF> band_;
};

}  // namespace vybeg::ui
