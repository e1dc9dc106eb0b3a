#include "ui/plots/panel_frame.h"

#include "ui/words/index_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg::ui {
namespace {

constexpr double margin_edge = 3;  // from the window's edge to a text in the margin

}  // namespace

void addFrame(QCPAxisRect& panel, const QSharedPointer<PanelTicker>& x,
              const QSharedPointer<PanelTicker>& y) {
    panel.setLayer(QStringLiteral("background"));  // below the grid
    for (const auto type : {QCPAxis::atLeft, QCPAxis::atBottom, QCPAxis::atRight, QCPAxis::atTop}) {
        QCPAxis* side = panel.addAxis(type);
        side->setLayer(QStringLiteral("axes"));
        side->grid()->setLayer(QStringLiteral("grid"));
        side->setSubTicks(false);
        side->setTickLengthIn(0);
        const bool scale = type == QCPAxis::atLeft || type == QCPAxis::atBottom;
        side->grid()->setVisible(scale);
        side->setTicks(scale);
        side->setTickLabels(scale);
    }
    panel.axis(QCPAxis::atBottom)->setTicker(x);
    panel.axis(QCPAxis::atLeft)->setTicker(y);
    panel.axis(QCPAxis::atBottom)->setTickLength(0, 4);
    panel.axis(QCPAxis::atLeft)->setTickLength(0, 4);
}

void setFrameLook(QCPAxisRect& panel, const Theme& theme, const QFont& tick_font) {
    panel.setBackground(QBrush(theme.panelBackground));
    for (QCPAxis* side : panel.axes()) {
        side->setBasePen(QPen(theme.axis, 1));
        side->setTickPen(QPen(theme.axis, 1));
        side->setTickLabelColor(theme.text);
        side->setTickLabelFont(tick_font);
        side->grid()->setPen(QPen(theme.grid, 1));
        side->grid()->setZeroLinePen(QPen(theme.zeroLine, 1));
    }
}

QFont tickFont(const QFont& font) {
    QFont smaller = font;
    smaller.setPixelSize(std::max(9, font.pixelSize() - 1));
    return smaller;
}

FrameRoom frameRoom(PlotHead head) {
    return head == PlotHead::line ? FrameRoom() : FrameRoom{56, 0, 8, 4};
}

std::vector<MarginLine> marginLines(const QString& symbol, const QString& offset,
                                    const QString& unit, const QFont& font) {
    const QFont small = tickFont(font);
    const auto line = [&](const QString& text, bool muted) {
        return MarginLine{text, muted, indexTextWidth(text, muted ? small : font)};
    };
    std::vector<MarginLine> lines{line(symbol, false)};
    if (!offset.isEmpty()) {
        lines.push_back(line(offset.trimmed(), true));
    } else if (const MarginLine both = line(symbol + QStringLiteral(", ") + unit, false);
               !unit.isEmpty() && both.width + margin_edge < frameRoom(PlotHead::margin).left) {
        return {both};
    }
    if (!unit.isEmpty()) {
        lines.push_back(line(unit, true));
    }
    return lines;
}

int marginOf(const std::vector<MarginLine>& lines) {
    const double widest = lines.empty() ? 0 : std::ranges::max(lines, {}, &MarginLine::width).width;
    return static_cast<int>(std::ceil(widest + 2 * margin_edge));
}

void drawMarginLines(QCPPainter& painter, const QCPAxisRect& panel,
                     const std::vector<MarginLine>& lines, const Theme& theme, const QFont& font) {
    const QFont small = tickFont(font);
    const QFontMetricsF metrics(small);
    double base = panel.rect().top() + metrics.ascent();
    for (const MarginLine& line : lines) {
        painter.setPen(line.muted ? theme.mutedText : theme.text);
        drawIndexText(painter, {panel.outerRect().left() + margin_edge, base}, line.text,
                      line.muted ? small : font);
        base += metrics.height();
    }
}

void addStackedFrame(QCPAxisRect& panel, const QSharedPointer<PanelTicker>& time,
                     const QSharedPointer<PanelTicker>& values, PlotHead head,
                     std::function<std::vector<MarginLine>(const AxisTicks&)> lines,
                     const QFont& font) {
    addFrame(panel, time, values);
    panel.axis(QCPAxis::atBottom)->setTickLabelPadding(5);
    panel.axis(QCPAxis::atLeft)->setTickLabelPadding(4);
    // The labels under the lowest panel have a separate row, so that all panels are equally high.
    panel.setAutoMargins(QCP::msLeft);
    const FrameRoom room = frameRoom(head);
    panel.setMinimumMargins({room.left, 0, 0, 0});
    panel.setMargins({room.left, room.head, room.right, room.foot});
    if (head == PlotHead::line) {
        return;
    }
    values->setShared(
        [lines = std::move(lines)](const AxisTicks& ticks) {
            std::vector<double> widths;
            for (const MarginLine& line : lines(ticks)) {
                widths.push_back(line.width + margin_edge);
            }
            return widths;
        },
        room.left - 4);
    time->setShared([&font](const AxisTicks& ticks) {
        return std::vector<double>{indexTextWidth(timeAxisName(ticks), font)};
    });
}

}  // namespace vybeg::ui
