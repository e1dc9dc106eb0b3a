#include "ui/signals/signal_panel.h"

#include "ui/plots/panel_frame.h"
#include "ui/signals/signal_graph.h"

#include <QCoreApplication>

namespace vybeg::ui {
namespace {

constexpr int least_left_margin = 60;
constexpr double unit_gap = 8;

}  // namespace

SignalPanel::SignalPanel(QCustomPlot* plot, SignalPart part)
    : QCPAxisRect(plot, false),
      part_(part),
      time_ticker_(new PanelTicker(Qt::Horizontal)),
      value_ticker_(new PanelTicker(Qt::Vertical)) {
    addFrame(*this, time_ticker_, value_ticker_);
    timeAxis()->setTickLabelPadding(5);
    valueAxis()->setTickLabelPadding(4);
    setAutoMargins(QCP::msLeft);
    setMinimumMargins({least_left_margin, 0, 0, 0});
    setMargins({least_left_margin, head_height, right_margin, foot});
    graph_ = new SignalGraph(timeAxis(), valueAxis(), part);
}

void SignalPanel::setPicture(const SignalContent& content, const SignalPicture& picture,
                             const QFont& font, QSize room) {
    theme_ = content.theme;
    stored_unit_ = content.unit;
    font_ = font;
    tick_font_ = tickFont(font);
    room_ = room;
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
        value_ticker_->setRoom(room_.height(), tick_font_);
        time_ticker_->setRoom(room_.width(), tick_font_, right_margin - 2);
    }
    QCPAxisRect::update(phase);
}

QString SignalPanel::symbol() const {
    switch (part_) {
        case SignalPart::c: return QStringLiteral("C") + value_ticker_->ticks().offsetText();
        case SignalPart::d: return QStringLiteral("D") + value_ticker_->ticks().offsetText();
        case SignalPart::residual: break;
    }
    return QCoreApplication::translate("SignalPanel", "Residual");
}

QString SignalPanel::unit() const {
    const int exponent = value_ticker_->ticks().exponent;
    return scaledUnit(stored_unit_, !stored_unit_.isEmpty(), exponent);
}

QRectF SignalPanel::readoutArea() const {
    const QFontMetricsF metrics(font_);
    const double used = metrics.horizontalAdvance(symbol()) + metrics.horizontalAdvance(unit());
    const double from = rect().left() + used + 3 * unit_gap;
    return {from, double(rect().top() - head_height), std::max(0., rect().right() - from),
            double(head_height - 3)};
}

void SignalPanel::draw(QCPPainter* painter) {
    QCPAxisRect::draw(painter);
    painter->setFont(font_);
    if (!empty_.isEmpty()) {
        painter->setPen(theme_.mutedText);
        painter->drawText(QRectF(rect()).adjusted(12, 4, -12, -4),
                          int(Qt::AlignCenter) | Qt::TextWordWrap, empty_);
    }
    const double base = rect().top() - 7;
    painter->setPen(theme_.text);
    painter->drawText(QPointF(rect().left(), base), symbol());
    painter->setPen(theme_.mutedText);
    painter->drawText(
        QPointF(rect().left() + QFontMetricsF(font_).horizontalAdvance(symbol()) + unit_gap, base),
        unit());
}

}  // namespace vybeg::ui
