#pragma once

#include "ui/plots/panel_frame.h"
#include "ui/signals/signal_picture.h"

#include <qcustomplot.h>

namespace vybeg::ui {

class SignalGraph;

// One plot of the signals, with its symbol and unit.
class SignalPanel : public QCPAxisRect {
    Q_OBJECT

public:
    SignalPanel(QCustomPlot* plot, SignalPart part, PlotHead head);

    SignalPart part() const { return part_; }
    // Both outlive the panel or are replaced before the next drawing. `room`: size of the frame
    // after the next layout, about.
    void setPicture(const SignalContent& content, const SignalPicture& picture, const QFont& font,
                    QSize room);
    void setTimeLabels(bool shown);

    QCPAxis* timeAxis() const { return axis(QCPAxis::atBottom); }
    QCPAxis* valueAxis() const { return axis(QCPAxis::atLeft); }
    const AxisTicks& timeTicks() const { return time_ticker_->ticks(); }
    const QFont& headFont() const { return font_; }
    FrameRoom room() const { return frameRoom(head_); }

    void update(UpdatePhase phase) override;

protected:
    void draw(QCPPainter* painter) override;
    int calculateAutoMargin(QCP::MarginSide side) override;

private:
    QString symbol() const;
    QString unit(const AxisTicks& ticks) const;
    std::vector<MarginLine> marginTexts(const AxisTicks& ticks) const;

    SignalPart part_;
    PlotHead head_;
    QSharedPointer<PanelTicker> time_ticker_;
    QSharedPointer<PanelTicker> value_ticker_;
    SignalGraph* graph_;
    Theme theme_;
    QString stored_unit_;
    QString empty_;
    QFont font_;
    QFont tick_font_;
    QSize expected_{400, 100};
};

}  // namespace vybeg::ui
