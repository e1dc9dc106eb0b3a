#include "ui/plots/xy_plot_view.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QFocusEvent>
#include <QGuiApplication>
#include <QPainter>
#include <QVBoxLayout>
#include <qcustomplot.h>

namespace vybeg::ui {

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
    setFixedHeight(sizeHint().height());
    setContextMenuPolicy(Qt::ActionsContextMenu);
    copy_->setShortcut(QKeySequence::Copy);
    copy_->setShortcutContext(Qt::WidgetShortcut);
    addActions({copy_, export_});
    connect(copy_, &QAction::triggered, this, [this] {
        QGuiApplication::clipboard()->setImage(xyPlotImage(content_, xy_paper_size));
    });
    connect(export_, &QAction::triggered, this, &XYPlotView::exportWanted);
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

}  // namespace vybeg::ui
