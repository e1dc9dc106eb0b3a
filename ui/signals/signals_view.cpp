#include "ui/signals/signals_view.h"

#include "ui/signals/signal_panel.h"
#include "ui/signals/signal_stack.h"
#include "ui/widgets/page_parts.h"

#include <QLayout>
#include <QPainter>

namespace vybeg::ui {

SignalsView::SignalsView(TrackView& tracks, QWidget* parent)
    : TimeGestures(parent),
      tracks_(tracks),
      stack_(std::make_unique<SignalStack>(
          plot(), std::vector(all_signal_parts.begin(), all_signal_parts.end()), PlotHead::margin)),
      overlay_(new SignalOverlay(*stack_, [this] { return hairs(); })) {
    setPlots(*stack_, *overlay_);
    layout()->setContentsMargins(1, 1, 1, 1);  // the frame of the keyboard focus
    setFocusPolicy(Qt::StrongFocus);
    whenChanged(*this, {QEvent::LanguageChange, QEvent::LocaleChange, QEvent::FontChange},
                [this] { setContent(content()); });
}

SignalsView::~SignalsView() {
    removePlot();
}

void SignalsView::setContent(SignalContent content) {
    content.time = tracks_.timeRange();
    plot().setBackground(QBrush(content.theme.plotBackground));
    stack_->setContent(std::move(content), plot().size());
    plot().replot(QCustomPlot::rpQueuedReplot);
}

const SignalContent& SignalsView::content() const {
    return stack_->content();
}

const SignalPicture& SignalsView::picture() const {
    return stack_->picture();
}

int SignalsView::timeWidth() const {
    return stack_->frameWidth(plot().width());
}

void SignalsView::moveTracker(std::optional<double> time_s) {
    tracks_.moveTracker(time_s);
    refreshOverlay();
}

void SignalsView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    emit resized();
}

// The frame shows the keyboard focus.
void SignalsView::paintEvent(QPaintEvent* event) {
    QWidget::paintEvent(event);
    if (hasFocus()) {
        QPainter painter(this);
        painter.setPen(content().theme.accent);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

}  // namespace vybeg::ui
