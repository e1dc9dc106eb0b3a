#include "ui/plots/xy_plot_view.h"

#include <QAction>
#include <QEvent>
#include <QFocusEvent>
#include <QHelpEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QVBoxLayout>
#include <qcustomplot.h>

namespace vybeg::ui {

namespace {

constexpr int height_in_panel = 250;

}  // namespace

XYPlotView::XYPlotView(QWidget* parent)
    : QWidget(parent),
      plot_(new QCustomPlot(this)),
      copy_(new QAction(this)),
      export_(new QAction(this)),
      theme_(lightTheme()) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(1, 1, 1, 1);
    layout->addWidget(plot_);
    // The plot ignores the mouse, so that the wheel scrolls the panel around it.
    plot_->setAttribute(Qt::WA_TransparentForMouseEvents);
    plot_->setFocusPolicy(Qt::NoFocus);
    setFocusPolicy(Qt::StrongFocus);
    setFixedHeight(height_in_panel);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    copy_->setShortcut(QKeySequence::Copy);
    copy_->setShortcutContext(Qt::WidgetShortcut);
    addActions({copy_, export_});
    connect(copy_, &QAction::triggered, this,
            [this] { copyDrawing(xyDrawing(content_), {xy_paper_size}); });
    connect(export_, &QAction::triggered, this, [this] { emit exportWanted(figure()); });
    retranslate();
}

void XYPlotView::setContent(const XYPlot& content) {
    content_ = content;
    rebuild();
}

void XYPlotView::setTheme(const Theme& theme) {
    theme_ = theme;
    rebuild();
}

Figure XYPlotView::figure() const {
    return {xyDrawing(content_), xy_paper_size, objectName()};
}

void XYPlotView::setPickable(std::optional<std::size_t> series) {
    pickable_ = series;
    setMouseTracking(pickable_.has_value());
}

void XYPlotView::setPointTips(const QStringList& tips) {
    setPointTips([tips](std::size_t point) { return tips.value(static_cast<qsizetype>(point)); });
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
    return QWidget::event(event);
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
        QWidget::keyPressEvent(event);
    }
}

void XYPlotView::rebuild() {
    layOutXYPlot(*plot_, content_, theme_, plot_->size());
    plot_->replot(QCustomPlot::rpQueuedReplot);
    copy_->setEnabled(!content_.series.empty());
    export_->setEnabled(!content_.series.empty());
}

void XYPlotView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    rebuild();
}

// The frame shows the keyboard focus.
void XYPlotView::paintEvent(QPaintEvent* event) {
    QWidget::paintEvent(event);
    if (hasFocus()) {
        QPainter painter(this);
        painter.setPen(theme_.accent);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void XYPlotView::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void XYPlotView::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

void XYPlotView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

void XYPlotView::retranslate() {
    copy_->setText(tr("Copy plot"));
    export_->setText(tr("Export plot…"));
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
