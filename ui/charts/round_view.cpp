#include "ui/charts/round_view.h"

#include <QChart>
#include <QChartView>
#include <QLabel>
#include <QLayout>

namespace vybeg::ui {

RoundView::RoundView(bool polar, QWidget* parent)
    : PlotView(parent),
      view_(new QChartView(makeRoundChart(polar), this)),
      legend_(new QLabel(this)) {
    content_.polar = polar;
    view_->setRenderHint(QPainter::Antialiasing);
    view_->setFrameShape(QFrame::NoFrame);
    setMinimumSize(180, 180);
    addDrawing(view_);
    layout()->addWidget(legend_);
    legend_->setWordWrap(true);
    legend_->setAlignment(Qt::AlignHCenter);
    legend_->setAutoFillBackground(true);
    legend_->setContentsMargins(4, 0, 4, 4);
    rebuild();
}

void RoundView::setContent(const RoundPlot& content) {
    content_ = content;
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
    const QString legend = legendOf(content_, theme());
    legend_->setVisible(legend_shown_ && !legend.isEmpty());
    legend_->setText(legend);
    QPalette palette = legend_->palette();
    palette.setColor(QPalette::Window, theme().plotBackground);
    palette.setColor(QPalette::WindowText, theme().text);
    legend_->setPalette(palette);
    fillRoundChart(*view_->chart(), content_, theme());
    view_->setBackgroundBrush(theme().plotBackground);
    setDrawn(!content_.series.empty());
}

}  // namespace vybeg::ui
