#include "ui/charts/round_view.h"

#include <QAction>
#include <QChart>
#include <QChartView>
#include <QEvent>
#include <QLabel>
#include <QVBoxLayout>

namespace vybeg::ui {

RoundView::RoundView(bool polar, QWidget* parent)
    : QWidget(parent),
      view_(new QChartView(makeRoundChart(polar), this)),
      legend_(new QLabel(this)),
      copy_(new QAction(this)),
      export_(new QAction(this)),
      theme_(lightTheme()) {
    content_.polar = polar;
    view_->setRenderHint(QPainter::Antialiasing);
    view_->setFrameShape(QFrame::NoFrame);
    // The chart ignores the mouse, so that the wheel scrolls the panel around it.
    view_->setAttribute(Qt::WA_TransparentForMouseEvents);
    view_->setFocusPolicy(Qt::NoFocus);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(180, 180);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(1, 1, 1, 1);
    layout->setSpacing(0);
    layout->addWidget(view_, 1);
    layout->addWidget(legend_);
    legend_->setWordWrap(true);
    legend_->setAlignment(Qt::AlignHCenter);
    legend_->setAutoFillBackground(true);
    legend_->setContentsMargins(4, 0, 4, 4);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    copy_->setShortcut(QKeySequence::Copy);
    copy_->setShortcutContext(Qt::WidgetShortcut);
    addActions({copy_, export_});
    connect(copy_, &QAction::triggered, this,
            [this] { copyDrawing(roundDrawing(content_), {round_paper_size}); });
    connect(export_, &QAction::triggered, this, [this] { emit exportWanted(figure()); });
    retranslate();
    rebuild();
}

void RoundView::setContent(const RoundPlot& content) {
    content_ = content;
    rebuild();
}

void RoundView::setTheme(const Theme& theme) {
    theme_ = theme;
    rebuild();
}

void RoundView::setLegendShown(bool shown) {
    legend_shown_ = shown;
    rebuild();
}

Figure RoundView::figure() const {
    return {roundDrawing(content_), round_paper_size, objectName()};
}

void RoundView::rebuild() {
    const QString legend = legendOf(content_, theme_);
    legend_->setVisible(legend_shown_ && !legend.isEmpty());
    legend_->setText(legend);
    QPalette palette = legend_->palette();
    palette.setColor(QPalette::Window, theme_.plotBackground);
    palette.setColor(QPalette::WindowText, theme_.text);
    legend_->setPalette(palette);
    fillRoundChart(*view_->chart(), content_, theme_);
    view_->setBackgroundBrush(theme_.plotBackground);
    copy_->setEnabled(!content_.series.empty());
    export_->setEnabled(!content_.series.empty());
}

void RoundView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    rebuild();
}

void RoundView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        rebuild();
    }
}

void RoundView::retranslate() {
    copy_->setText(tr("Copy plot"));
    export_->setText(tr("Export plot…"));
}

}  // namespace vybeg::ui
