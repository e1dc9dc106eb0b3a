#include "ui/plots/plot_overlay.h"

#include "ui/plots/decimated_graph.h"
#include "ui/plots/hair_line.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/plots/plot_strip.h"
#include "ui/values/covered_time.h"

#include <algorithm>
#include <cmath>

namespace vybeg::ui {
namespace {

constexpr double reading_sample_length = 14;
constexpr double reading_sample_gap = 5;
constexpr double value_gap = 14;

struct Reading {
    QString text;
    const DecimatedGraph* graph = nullptr;
    double width = 0;
};

// Values of all analyses at the tracker, as many as fit; deviations are omitted before values.
std::vector<Reading> readings(const PlotPanel& panel, double time_s, const QFontMetricsF& metrics) {
    for (const bool with_sd : {true, false}) {
        std::vector<Reading> list;
        double total = 0;
        for (const DecimatedGraph* graph : panel.graphs()) {
            const CurveData& data = graph->data();
            if (!covers(data.analysis(), time_s)) {
                continue;
            }
            const std::size_t row = data.nearest(time_s);
            const double stored = data.value(row);
            const double sd = with_sd ? graph->scale().sd(stored, data.sd(row))
                                      : std::numeric_limits<double>::quiet_NaN();
            Reading reading{valueText(graph->scale().value(stored), sd), graph, 0};
            reading.width = reading_sample_length + reading_sample_gap +
                            metrics.horizontalAdvance(reading.text) + value_gap;
            total += reading.width;
            list.push_back(std::move(reading));
        }
        if (total - value_gap <= panel.readoutArea().width()) {
            return list;
        }
        if (!with_sd) {
            while (!list.empty() && total - value_gap > panel.readoutArea().width()) {
                total -= list.back().width;
                list.pop_back();
            }
            return list;
        }
    }
    return {};
}

}  // namespace

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
    for (const PlotPanel* panel : stack_->panels()) {
        drawReadout(*painter, *panel);
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

void PlotOverlay::drawReadout(QCPPainter& painter, const PlotPanel& panel) const {
    const QFont& font = panel.headFont();
    const QFontMetricsF metrics(font);
    const QRectF area = panel.readoutArea();
    const double base = panel.rect().top() - 7;
    painter.setFont(font);
    if (!tracker_) {
        const QString meaning = displayMeaning(panel.variable());
        if (metrics.horizontalAdvance(meaning) <= area.width()) {
            painter.setPen(theme_.mutedText);
            painter.drawText(QPointF(area.right() - metrics.horizontalAdvance(meaning), base),
                             meaning);
        }
        return;
    }
    const std::vector<Reading> list = readings(panel, *tracker_, metrics);
    double x = area.right() + value_gap;
    for (const Reading& reading : list) {
        x -= reading.width;
    }
    for (const Reading& reading : list) {
        if (panel.graphs().size() > 1) {
            painter.fillRect(QRectF(x + 3, base - 0.72 * metrics.ascent(), 9, 9),
                             reading.graph->color());
        }
        painter.setAntialiasing(true);
        painter.setPen(theme_.text);
        painter.drawText(QPointF(x + reading_sample_length + reading_sample_gap, base),
                         reading.text);
        x += reading.width;
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
