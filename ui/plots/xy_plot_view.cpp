#include "ui/plots/xy_plot_view.h"

#include <QHelpEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QToolTip>
#include <qcustomplot.h>

namespace vybeg::ui {

namespace {

constexpr int height_in_panel = 250;

}  // namespace

XYPlotView::XYPlotView(QWidget* parent) : PlotView(parent), plot_(new QCustomPlot(this)) {
    addDrawing(plot_);
    setFixedHeight(height_in_panel);
}

void XYPlotView::setContent(const XYPlot& content) {
    content_ = content;
    rebuild();
}

Figure XYPlotView::figure() const {
    return {xyDrawing(content_), xy_paper_size, objectName()};
}

void XYPlotView::setPickable(std::optional<std::size_t> series) {
    pickable_ = series;
    setMouseTracking(pickable_.has_value());
}

QPointF XYPlotView::positionOf(std::size_t series, std::size_t point) const {
    const QCPAxisRect* panel = plot_->axisRects().front();
    const XYSeries& values = content_.series[series];
    const QPointF in_plot(panel->axis(QCPAxis::atBottom)->coordToPixel(values.x[point]),
                          panel->axis(QCPAxis::atLeft)->coordToPixel(values.y[point]));
    return in_plot + QPointF(plot_->pos());
}

std::optional<std::size_t> XYPlotView::pointAt(const QPointF& position) const {
    constexpr double reach = 14;  // pixels
    std::optional<std::size_t> nearest;
    double least = reach;
    if (!pickable_ || *pickable_ >= content_.series.size()) {
        return nearest;
    }
    for (std::size_t point = 0; point < content_.series[*pickable_].x.size(); ++point) {
        const double distance = QLineF(position, positionOf(*pickable_, point)).length();
        if (distance < least) {
            least = distance;
            nearest = point;
        }
    }
    return nearest;
}

bool XYPlotView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto point = pointAt(help->pos());
        const QString tip = point && tip_ ? tip_(*point) : QString();
        if (!tip.isEmpty()) {
            QToolTip::showText(help->globalPos(), tip, this);
            return true;
        }
    }
    return PlotView::event(event);
}

void XYPlotView::mouseMoveEvent(QMouseEvent* event) {
    setCursor(pointAt(event->position()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void XYPlotView::mouseReleaseEvent(QMouseEvent* event) {
    const auto point = pointAt(event->position());
    if (point && event->button() == Qt::LeftButton) {
        emit pointClicked(static_cast<int>(*point));
    }
}

void XYPlotView::mouseDoubleClickEvent(QMouseEvent* event) {
    const auto point = pointAt(event->position());
    if (point && event->button() == Qt::LeftButton) {
        emit pointActivated(static_cast<int>(*point));
    }
}

void XYPlotView::keyPressEvent(QKeyEvent* event) {
    if (pickable_ && (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)) {
        emit stepWanted(event->key() == Qt::Key_Left ? -1 : 1);
    } else {
        PlotView::keyPressEvent(event);
    }
}

void XYPlotView::rebuild() {
    layOutXYPlot(*plot_, content_, theme(), plot_->size());
    plot_->replot(QCustomPlot::rpQueuedReplot);
    setDrawn(!content_.series.empty());
}

FigureSource figuresOf(const std::vector<const XYPlotView*>& plots, const QString& name,
                       const QString& title) {
    std::vector<std::pair<QString, Figure>> figures;
    for (const XYPlotView* plot : plots) {
        if (!plot->content().series.empty()) {
            figures.emplace_back(plot->accessibleName(), plot->figure());
        }
    }
    return sourceOf(figures, name, title);
}

}  // namespace vybeg::ui

#include "moc_xy_plot_view.cpp"
