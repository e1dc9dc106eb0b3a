#pragma once

#include "ui/plots/panel_ticker.h"
#include "ui/signals/signal_picture.h"

#include <qcustomplot.h>

namespace vybeg::ui {

class SignalGraph;

// One plot of the signals with a head line: symbol and unit, at its right end a text.
class SignalPanel : public QCPAxisRect {
    Q_OBJECT

public:
    SignalPanel(QCustomPlot* plot, SignalPart part);

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
    // Right of symbol and unit.
    QRectF readoutArea() const;

    static constexpr int head_height = 21;
    static constexpr int right_margin = 16;
    static constexpr int foot = 3;

    void update(UpdatePhase phase) override;

protected:
    void draw(QCPPainter* painter) override;

private:
    QString symbol() const;
    QString unit() const;

    SignalPart part_;
    QSharedPointer<PanelTicker> time_ticker_;
    QSharedPointer<PanelTicker> value_ticker_;
    SignalGraph* graph_;
    Theme theme_;
    QString stored_unit_;
    QString empty_;
    QFont font_;
    QFont tick_font_;
    QSize room_{400, 100};
};

}  // namespace vybeg::ui
