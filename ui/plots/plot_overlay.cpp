#include "ui/plots/plot_overlay.h"

#include "ui/plots/decimated_graph.h"
#include "ui/plots/plot_stack.h"
#include "ui/values/covered_time.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg::ui {

PlotOverlay::PlotOverlay(const PlotStack& stack, std::function<HairLines()> hairs)
    : TimeOverlay(stack, std::move(hairs)), stack_(stack) {}

void PlotOverlay::draw(QCPPainter* painter) {
    if (!hint_.isEmpty()) {
        painter->setPen(stack_.theme().mutedText);
        painter->setFont(plotFont(*mParentPlot));
        painter->drawText(mParentPlot->viewport(), int(Qt::AlignCenter | Qt::TextWordWrap), hint_);
        return;
    }
    if (unlike_ > 0 && !stack_.panels().empty()) {
        const PlotPanel& first = *stack_.panels().front();
        painter->setPen(stack_.theme().mutedText);
        painter->setFont(first.font());
        painter->drawText(QRectF(first.rect()).adjusted(6, 2, -6, -2),
                          int(Qt::AlignRight | Qt::AlignTop),
                          QCoreApplication::translate(
                              "PlotStack", "%n not drawn: other length or unit", nullptr, unlike_));
    }
    TimeOverlay::draw(painter);
    if (const auto time_s = hairs().tracker) {
        for (const PlotPanel* panel : stack_.panels()) {
            drawDots(*painter, *panel, *time_s);
        }
    }
}

void PlotOverlay::drawDots(QCPPainter& painter, const PlotPanel& panel, double time_s) const {
    painter.setAntialiasing(true);
    for (const DecimatedGraph* graph : panel.graphs()) {
        if (!covers(graph->data().analysis(), time_s)) {
            continue;
        }
        const std::size_t row = graph->data().nearest(time_s);
        const double value = graph->scale().value(graph->data().value(row));
        const double time = graph->data().time(row);
        if (!std::isfinite(value) || !panel.values().contains(value) ||
            !panel.time().contains(time)) {
            continue;
        }
        painter.setPen(QPen(stack_.theme().panelBackground, 1));
        painter.setBrush(graph->color());
        painter.drawEllipse(
            QPointF(panel.timeAxis()->coordToPixel(time), panel.valueAxis()->coordToPixel(value)),
            3.5, 3.5);
    }
    painter.setBrush(Qt::NoBrush);
}

}  // namespace vybeg::ui
