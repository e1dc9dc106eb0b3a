#include "ui/plots/plot_view.h"

#include "ui/plots/time_stack.h"
#include "ui/widgets/page_parts.h"

#include <QAction>
#include <QHelpEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <algorithm>

namespace vybeg::ui {

PlotView::PlotView(QWidget* parent)
    : QWidget(parent), copy_(new QAction(this)), export_(new QAction(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(1, 1, 1, 1);
    layout->setSpacing(0);
    setFocusPolicy(Qt::StrongFocus);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    copy_->setShortcut(QKeySequence::Copy);
    copy_->setShortcutContext(Qt::WidgetShortcut);
    addActions({copy_, export_});
    connect(copy_, &QAction::triggered, this, [this] {
        const Figure copied = figure();
        copyDrawing(copied.draw, {copied.size});
    });
    connect(export_, &QAction::triggered, this, [this] { emit exportWanted(figure()); });
    retranslate();
    whenChanged(*this, {QEvent::LanguageChange}, [this] {
        retranslate();
        rebuild();
    });
    whenChanged(*this, {QEvent::Resize, QEvent::PaletteChange}, [this] { rebuild(); });
}

void PlotView::addDrawing(QWidget* drawing) {
    drawing->setAttribute(Qt::WA_TransparentForMouseEvents);
    drawing->setFocusPolicy(Qt::NoFocus);
    static_cast<QVBoxLayout*>(layout())->addWidget(drawing, 1);
}

void PlotView::setDrawn(bool drawn) {
    copy_->setEnabled(drawn);
    export_->setEnabled(drawn);
}

void PlotView::paintEvent(QPaintEvent* event) {
    QWidget::paintEvent(event);
    if (hasFocus()) {
        QPainter painter(this);
        painter.setPen(theme().accent);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void PlotView::retranslate() {
    copy_->setText(tr("Copy plot"));
    export_->setText(tr("Export plot…"));
}

XYPlotView::XYPlotView(QWidget* parent) : PlotView(parent), plot_(new QCustomPlot(this)) {
    constexpr int height_in_panel = 250;
    addDrawing(plot_);
    setFixedHeight(height_in_panel);
}

void XYPlotView::setContent(const XYPlot& content) {
    content_ = content;
    rebuild();
}

int XYPlotView::head() const {
    return headOf(content_, plotFont(*plot_), layout()->contentsRect().width());
}

Figure XYPlotView::figure() const {
    XYPlot alone = content_;  // without the plot below that names the axis of both
    alone.x_below = false;
    return {xyDrawing(alone), {640, 420}, objectName()};
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

MeasuredPage::MeasuredPage(QWidget* parent) : QWidget(parent) {
    whenChanged(*this, {QEvent::LanguageChange}, [this] { retranslate(); });
    whenChanged(*this, {QEvent::PaletteChange}, [this] { showAgain(); });
}

void MeasuredPage::setUnits(const DisplayUnits& units) {
    units_ = units;
    std::ranges::for_each(parts_, [&units](MeasuredPage* part) { part->setUnits(units); });
    showAgain();
}

XYPlotView* MeasuredPage::addPlot(const char* name, int least_height) {
    constexpr int least_width = 180;
    auto* plot = withPart(withName(new XYPlotView(this), name));
    plot->setMinimumSize(least_width, least_height);
    plot->setMaximumHeight(QWIDGETSIZE_MAX);
    return plot;
}

}  // namespace vybeg::ui

#include "moc_plot_view.cpp"
