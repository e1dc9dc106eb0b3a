#include "ui/signals/signal_panel.h"

#include "ui/signals/signal_graph.h"

#include <QCoreApplication>

#include <algorithm>

namespace vybeg::ui {
namespace {

constexpr double unit_gap = 8;

}  // namespace

SignalPanel::SignalPanel(QCustomPlot* plot, SignalPart part, PlotHead head)
    : QCPAxisRect(plot, false),
      part_(part),
      head_(head),
      time_ticker_(new PanelTicker(Qt::Horizontal)),
      value_ticker_(new PanelTicker(Qt::Vertical)) {
    addStackedFrame(
        *this, time_ticker_, value_ticker_, head,
        [this](const AxisTicks& ticks) { return marginTexts(ticks); }, font_);
    graph_ = new SignalGraph(timeAxis(), valueAxis(), part);
}

void SignalPanel::setPicture(const SignalContent& content, const SignalPicture& picture,
                             const QFont& font, QSize room) {
    theme_ = content.theme;
    stored_unit_ = content.unit;
    font_ = font;
    tick_font_ = tickFont(font);
    expected_ = room;
    empty_ = part_ == SignalPart::residual && !content.analysis ? content.no_residual : QString();
    setFrameLook(*this, theme_, tick_font_);
    timeAxis()->grid()->setZeroLinePen(Qt::NoPen);
    valueAxis()->setTicks(empty_.isEmpty());
    valueAxis()->setTickLabels(empty_.isEmpty());
    timeAxis()->setRange(content.time.lower, content.time.upper);
    const AxisRange values = valuesOf(content, picture, part_);
    valueAxis()->setRange(values.lower, values.upper);
    graph_->setPicture(&content, &picture);
}

void SignalPanel::setTimeLabels(bool shown) {
    timeAxis()->setTickLabels(shown);
}

void SignalPanel::update(UpdatePhase phase) {
    if (phase == upPreparation) {
        value_ticker_->setRoom(expected_.height(), tick_font_);
        time_ticker_->setRoom(expected_.width(), tick_font_, room().right - 2);
    }
    QCPAxisRect::update(phase);
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

std::vector<MarginLine> SignalPanel::marginTexts(const AxisTicks& ticks) const {
    return marginLines(symbol(), ticks.offsetText(), unit(ticks), font_);
}

int SignalPanel::calculateAutoMargin(QCP::MarginSide side) {
    const int margin = QCPAxisRect::calculateAutoMargin(side);
    return head_ == PlotHead::margin && side == QCP::msLeft
               ? std::max(margin, marginOf(marginTexts(value_ticker_->ticks())))
               : margin;
}

void SignalPanel::draw(QCPPainter* painter) {
    QCPAxisRect::draw(painter);
    painter->setFont(font_);
    if (!empty_.isEmpty()) {
        painter->setPen(theme_.mutedText);
        painter->drawText(QRectF(rect()).adjusted(12, 4, -12, -4),
                          int(Qt::AlignCenter) | Qt::TextWordWrap, empty_);
    }
    const AxisTicks& ticks = value_ticker_->ticks();
    if (head_ == PlotHead::margin) {
        drawMarginLines(*painter, *this, marginTexts(ticks), theme_, font_);
        return;
    }
    const double base = rect().top() - 7;
    const QString name = symbol() + ticks.offsetText();
    painter->setPen(theme_.text);
    painter->drawText(QPointF(rect().left(), base), name);
    painter->setPen(theme_.mutedText);
    painter->drawText(
        QPointF(rect().left() + QFontMetricsF(font_).horizontalAdvance(name) + unit_gap, base),
        unit(ticks));
}

}  // namespace vybeg::ui
