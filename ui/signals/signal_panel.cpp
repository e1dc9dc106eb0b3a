#include "ui/signals/signal_panel.h"

#include "ui/signals/signal_graph.h"

#include <QCoreApplication>

namespace vybeg::ui {

SignalPanel::SignalPanel(QCustomPlot* plot, SignalPart part, PlotHead head)
    : TimePanel(plot, head), part_(part), graph_(new SignalGraph(timeAxis(), valueAxis(), part)) {}

void SignalPanel::setPicture(const SignalContent& content, const SignalPicture& picture,
                             const QFont& font) {
    stored_unit_ = content.unit;
    empty_ = part_ == SignalPart::residual && !content.analysis ? content.no_residual : QString();
    setLook(content.theme, font);
    setScaleShown(empty_.isEmpty());
    setTime(content.time);
    setValues(valuesOf(content, picture, part_));
    graph_->setPicture(&content, &picture);
}

QString SignalPanel::symbol() const {
    switch (part_) {
        case SignalPart::c: return QStringLiteral("C");
        case SignalPart::d: return QStringLiteral("D");
        case SignalPart::residual: break;
    }
    return QCoreApplication::translate("SignalPanel", "Residual");
}

QString SignalPanel::unit(const AxisTicks& ticks) const {
    return scaledUnit(stored_unit_, !stored_unit_.isEmpty(), ticks.exponent);
}

}  // namespace vybeg::ui
