#include "ui/plots/plot_view.h"

#include "ui/widgets/page_parts.h"

#include <QAction>
#include <QPainter>
#include <QVBoxLayout>

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
    whenChanged(*this, {QEvent::Resize}, [this] { rebuild(); });
}

void PlotView::addDrawing(QWidget* drawing) {
    drawing->setAttribute(Qt::WA_TransparentForMouseEvents);
    drawing->setFocusPolicy(Qt::NoFocus);
    static_cast<QVBoxLayout*>(layout())->addWidget(drawing, 1);
}

void PlotView::setTheme(const Theme& theme) {
    theme_ = theme;
    rebuild();
}

void PlotView::setDrawn(bool drawn) {
    copy_->setEnabled(drawn);
    export_->setEnabled(drawn);
}

void PlotView::paintEvent(QPaintEvent* event) {
    QWidget::paintEvent(event);
    if (hasFocus()) {
        QPainter painter(this);
        painter.setPen(theme_.accent);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void PlotView::retranslate() {
    copy_->setText(tr("Copy plot"));
    export_->setText(tr("Export plot…"));
}

}  // namespace vybeg::ui

#include "moc_plot_view.cpp"
