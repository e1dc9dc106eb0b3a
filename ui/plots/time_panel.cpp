#include "ui/plots/time_panel.h"

#include "ui/plots/panel_frame.h"
#include "ui/words/rich_text.h"

#include <algorithm>
#include <cmath>

namespace vybeg::ui {
namespace {

constexpr double margin_edge = 3;  // from the window's edge to a text in the margin
constexpr double unit_gap = 8;

}  // namespace

QMargins TimePanel::room(PlotHead head) {
    return head == PlotHead::line ? QMargins(60, 21, 16, 3) : QMargins(56, 0, 8, 4);
}

// The labels under the lowest panel have a separate row, so that all panels are equally high. On
// the screen tick labels leave room for the lines in the margin and the name of the time axis.
TimePanel::TimePanel(QCustomPlot* plot, PlotHead head)
    : FramedPanel(plot, room(head)), head_(head) {
    timeAxis()->setTickLabelPadding(5);
    valueAxis()->setTickLabelPadding(4);
    if (head == PlotHead::line) {
        return;
    }
    valueTicker().setShared(
        [this](const AxisTicks& ticks) {
            std::vector<double> widths;
            for (const MarginLine& line : marginLines(ticks)) {
                widths.push_back(line.width + margin_edge);
            }
            return widths;
        },
        room(head).left() - 4);
    ticker(QCPAxis::atBottom).setShared([this](const AxisTicks& ticks) {
        return std::vector<double>{indexTextWidth(timeAxisName(ticks), font())};
    });
}

void TimePanel::setLook(const Theme& theme, const QFont& font) {
    FramedPanel::setLook(theme, font);
    timeAxis()->grid()->setZeroLinePen(Qt::NoPen);
}

void TimePanel::setScaleShown(bool shown) {
    valueAxis()->setTickLabels(shown);
    valueAxis()->setTicks(shown);
}

void TimePanel::draw(QCPPainter* painter) {
    QCPAxisRect::draw(painter);
    if (head_ == PlotHead::line) {
        drawHead(*painter);
    } else {
        drawMarginLines(*painter);
    }
    if (const QString text = emptyText(); !text.isEmpty()) {
        drawEmpty(*painter, text);
    }
}

void TimePanel::drawHead(QCPPainter& painter) const {
    const AxisTicks& ticks = valueTicker().ticks();
    const double base = rect().top() - 7;
    painter.setPen(theme().text);
    const double x = rect().left() + drawIndexText(painter, {double(rect().left()), base},
                                                   symbol() + offset(ticks), font());
    painter.setPen(theme().mutedText);
    drawIndexText(painter, {x + unit_gap, base}, unit(ticks), font());
    if (!letter_.isEmpty()) {
        QFont italic(font());
        italic.setItalic(true);
        painter.setFont(italic);
        painter.setPen(theme().text);
        const int head = room(head_).top();
        painter.drawText(QRectF(rect().left(), rect().top() - head, rect().width(), head - 3),
                         int(Qt::AlignRight | Qt::AlignVCenter), letter_);
    }
}

void TimePanel::drawMarginLines(QCPPainter& painter) const {
    const QFontMetricsF metrics(tickFont());
    double base = rect().top() + metrics.ascent();
    for (const MarginLine& line : marginLines(valueTicker().ticks())) {
        painter.setPen(line.muted ? theme().mutedText : theme().text);
        drawIndexText(painter, {outerRect().left() + margin_edge, base}, line.text,
                      line.muted ? tickFont() : font());
        base += metrics.height();
    }
}

std::vector<TimePanel::MarginLine> TimePanel::marginLines(const AxisTicks& ticks) const {
    const auto line = [&](const QString& text, bool muted) {
        return MarginLine{text, muted, indexTextWidth(text, muted ? tickFont() : font())};
    };
    std::vector<MarginLine> lines{line(symbol(), false)};
    const QString from = offset(ticks);
    const QString of = unit(ticks);
    if (!from.isEmpty()) {
        lines.push_back(line(from.trimmed(), true));
    } else if (const MarginLine both = line(symbol() + QStringLiteral(", ") + of, false);
               !of.isEmpty() && both.width + margin_edge < room(PlotHead::margin).left()) {
        return {both};
    }
    if (!of.isEmpty()) {
        lines.push_back(line(of, true));
    }
    return lines;
}

int TimePanel::calculateAutoMargin(QCP::MarginSide side) {
    int margin = QCPAxisRect::calculateAutoMargin(side);
    if (head_ == PlotHead::margin && side == QCP::msLeft) {
        for (const MarginLine& line : marginLines(valueTicker().ticks())) {
            margin = std::max(margin, static_cast<int>(std::ceil(line.width + 2 * margin_edge)));
        }
    }
    return margin;
}

}  // namespace vybeg::ui
