#include "ui/plots/plot_overlay.h"

#include "ui/plots/decimated_graph.h"
#include "ui/plots/hair_line.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/values/covered_time.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

PlotOverlay::PlotOverlay(QCustomPlot* plot, const PlotStack* stack)
    : QCPLayerable(plot, QStringLiteral("overlay")), stack_(stack) {
    plot->layer(QStringLiteral("overlay"))->setMode(QCPLayer::lmBuffered);
}

void PlotOverlay::applyDefaultAntialiasingHint(QCPPainter* painter) const {
    painter->setAntialiasing(false);
}

void PlotOverlay::draw(QCPPainter* painter) {
    if (!hint_.isEmpty()) {
        painter->setPen(theme_.mutedText);
        painter->setFont(plotFont(*mParentPlot));
        painter->drawText(mParentPlot->viewport(), int(Qt::AlignCenter | Qt::TextWordWrap), hint_);
        return;
    }
    if (unlike_ > 0 && !stack_->panels().empty()) {
        const PlotPanel& first = *stack_->panels().front();
        painter->setPen(theme_.mutedText);
        painter->setFont(first.headFont());
        painter->drawText(QRectF(first.rect()).adjusted(6, 2, -6, -2),
                          int(Qt::AlignRight | Qt::AlignTop),
                          QCoreApplication::translate(
                              "PlotStack", "%n not drawn: other length or unit", nullptr, unlike_));
    }
    if (cursors_[0]) {
        drawHair(*painter, *cursors_[0], theme_.cursorA, QStringLiteral("A"));
    }
    if (cursors_[1]) {
        drawHair(*painter, *cursors_[1], theme_.cursorB, QStringLiteral("B"));
    }
    if (tracker_) {
        drawHair(*painter, *tracker_, theme_.tracker, QString());
        for (const PlotPanel* panel : stack_->panels()) {
            drawDots(*painter, *panel);
        }
    }
    if (band_) {
        QColor fill = theme_.accent;
        fill.setAlphaF(0.15f);
        painter->setAntialiasing(false);
        painter->setPen(QPen(theme_.accent, 1));
        painter->setBrush(fill);
        painter->drawRect(*band_);
        painter->setBrush(Qt::NoBrush);
    }
}

void PlotOverlay::drawHair(QCPPainter& painter, double time_s, const QColor& color,
                           const QString& name) const {
    if (!stack_->panels().empty()) {
        ui::drawHair(painter, {stack_->panels().begin(), stack_->panels().end()}, time_s,
                     {color, name, stack_->panels().front()->headFont(), theme_.plotBackground});
    }
}

void PlotOverlay::drawDots(QCPPainter& painter, const PlotPanel& panel) const {
    painter.setAntialiasing(true);
    for (const DecimatedGraph* graph : panel.graphs()) {
        if (!covers(graph->data().analysis(), *tracker_)) {
            continue;
        }
        const std::size_t row = graph->data().nearest(*tracker_);
        const double value = graph->scale().value(graph->data().value(row));
        const double time = graph->data().time(row);
        if (!std::isfinite(value) || !panel.values().contains(value) ||
            !panel.time().contains(time)) {
            continue;
        }
        painter.setPen(QPen(theme_.panelBackground, 1));
        painter.setBrush(graph->color());
        painter.drawEllipse(
            QPointF(panel.timeAxis()->coordToPixel(time), panel.valueAxis()->coordToPixel(value)),
            3.5, 3.5);
    }
    painter.setBrush(Qt::NoBrush);
}

}  // namespace vybeg::ui
