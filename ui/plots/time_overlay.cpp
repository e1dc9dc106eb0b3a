#include "ui/plots/time_overlay.h"

#include "ui/words/number_label.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg::ui {
namespace {

// The instant with the resolution of a pixel.
QString timeText(const TimePanel& panel, double time_s) {
    const double pixel = panel.time().span() / std::max(1, panel.width());
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(pixel))), 0, 9);
    return numberLabel(time_s, decimals) + ' ' + QCoreApplication::translate("DisplayUnits", "s");
}

// Clears the labels of ticks that a label over them leaves in part: "2" of "20". Below what the
// layer holds already.
void clearTouched(QCPPainter& painter, const TimePanel& panel, const QRectF& label) {
    const QFontMetricsF metrics(panel.timeAxis()->tickLabelFont());
    const AxisTicks& ticks = panel.timeTicks();
    painter.setCompositionMode(QPainter::CompositionMode_DestinationOver);
    for (std::size_t k = 0; k < ticks.positions.size(); ++k) {
        const double width = metrics.horizontalAdvance(ticks.labels[static_cast<qsizetype>(k)]) + 2;
        const double left = panel.timeAxis()->coordToPixel(ticks.positions[k]) - 0.5 * width;
        if (left < label.right() && left + width > label.left()) {
            painter.fillRect(QRectF(left, label.top(), width, label.height()),
                             panel.theme().plotBackground);
        }
    }
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
}

}  // namespace

TimeOverlay::TimeOverlay(const TimeStack& stack, std::function<HairLines()> hairs)
    : QCPLayerable(&stack.plot(), QStringLiteral("overlay")),
      stack_(stack),
      hairs_(std::move(hairs)) {
    stack.plot().layer(QStringLiteral("overlay"))->setMode(QCPLayer::lmBuffered);
}

void TimeOverlay::applyDefaultAntialiasingHint(QCPPainter* painter) const {
    painter->setAntialiasing(false);
}

void TimeOverlay::draw(QCPPainter* painter) {
    const Theme& theme = stack_.theme();
    const HairLines shown = hairs();
    drawHair(*painter, shown.cursor_a, theme.cursorA, QStringLiteral("A"));
    drawHair(*painter, shown.cursor_b, theme.cursorB, QStringLiteral("B"));
    drawHair(*painter, shown.tracker, theme.tracker, QString());
    if (band_) {
        QColor fill = theme.accent;
        fill.setAlphaF(0.15F);
        painter->setAntialiasing(false);
        painter->setPen(QPen(theme.accent, 1));
        painter->setBrush(fill);
        painter->drawRect(*band_);
        painter->setBrush(Qt::NoBrush);
    }
}

// Solid with a name below, or dashed with its time below.
void TimeOverlay::drawHair(QCPPainter& painter, std::optional<double> time_s, const QColor& color,
                           const QString& name) const {
    if (!time_s || stack_.frames().empty() || !stack_.frames().front()->time().contains(*time_s)) {
        return;
    }
    const TimePanel& first = *stack_.frames().front();
    const TimePanel& last = *stack_.frames().back();
    const double x = std::round(first.timeAxis()->coordToPixel(*time_s));
    painter.setAntialiasing(false);
    painter.setPen(QPen(color, 1, name.isEmpty() ? Qt::DashLine : Qt::SolidLine));
    for (const TimePanel* frame : stack_.frames()) {
        painter.drawLine(QLineF(x, frame->rect().top(), x, frame->rect().bottom()));
    }
    // Instead of tick labels, not over curves.
    const QFontMetricsF metrics(first.font());
    const QString text = name.isEmpty() ? timeText(first, *time_s) : name;
    const double width = metrics.horizontalAdvance(text) + 10;
    const QRectF area(first.rect());
    const double left = std::clamp(x - 0.5 * width, area.left(),
                                   std::max(area.left(), first.rect().right() - width));
    const QRectF label(left, last.rect().bottom() + 4, width, metrics.height() + 2);
    clearTouched(painter, last, label);
    painter.setAntialiasing(true);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRoundedRect(label, 3, 3);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(stack_.theme().plotBackground);
    painter.setFont(first.font());
    painter.drawText(label, int(Qt::AlignCenter), text);
}

}  // namespace vybeg::ui
