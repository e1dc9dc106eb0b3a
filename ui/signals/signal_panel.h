#pragma once

#include "ui/plots/time_panel.h"
#include "ui/signals/signal_picture.h"

namespace vybeg::ui {

class SignalGraph;

// One plot of the signals.
class SignalPanel : public TimePanel {
public:
    SignalPanel(QCustomPlot* plot, SignalPart part, PlotHead head);

    SignalPart part() const { return part_; }
    // Both outlive the panel or are replaced before the next drawing.
    void setPicture(const SignalContent& content, const SignalPicture& picture, const QFont& font);

protected:
    QString symbol() const override;
    QString unit(const AxisTicks& ticks) const override;
    QString emptyText() const override { return empty_; }

private:
    SignalPart part_;
    SignalGraph* graph_;
    QString stored_unit_;
    QString empty_;
};

}  // namespace vybeg::ui
