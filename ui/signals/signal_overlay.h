#pragma once

#include "ui/plots/track_view.h"
#include "ui/signals/signal_picture.h"

#include <qcustomplot.h>

namespace vybeg::ui {

class SignalPanel;
class SignalStack;

// Items that move with the mouse, on a layer of their own: cursors, the hair line of the tracker
// with the values of the sample nearest to it, the part of the time to zoom into.
class SignalOverlay : public QCPLayerable {
    Q_OBJECT

public:
    SignalOverlay(QCustomPlot* plot, const SignalStack& stack, const TrackView& tracks);

    // Pixels from the left.
    void setPart(std::optional<AxisRange> part) { part_ = part; }

protected:
    void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
    void draw(QCPPainter* painter) override;

private:
    QString note(const SignalPanel& panel) const;
    void drawNote(QCPPainter& painter, const SignalPanel& panel) const;

    const SignalStack& stack_;
    const TrackView& tracks_;
    std::optional<AxisRange> part_;
};

}  // namespace vybeg::ui
