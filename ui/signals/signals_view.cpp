#include "ui/signals/signals_view.h"

#include "ui/plots/hair_line.h"
#include "ui/plots/plot_stack.h"
#include "ui/signals/signal_overlay.h"
#include "ui/signals/signal_panel.h"
#include "ui/signals/signal_stack.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg::ui {
namespace {

constexpr double least_part = 5;  // pixels; a smaller one is a click

}  // namespace

SignalsView::SignalsView(TrackView& tracks, QWidget* parent)
    : QWidget(parent), tracks_(tracks), plot_(new QCustomPlot(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(1, 1, 1, 1);
    layout->addWidget(plot_);
    // The view handles the mouse itself, not QCustomPlot.
    plot_->setAttribute(Qt::WA_TransparentForMouseEvents);
    plot_->setFocusPolicy(Qt::NoFocus);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    preparePlot(*plot_, lightTheme());
    stack_ = std::make_unique<SignalStack>(
        *plot_, std::vector(all_signal_parts.begin(), all_signal_parts.end()), PlotHead::margin);
    overlay_ = new SignalOverlay(plot_, *stack_, tracks_);
}

SignalsView::~SignalsView() {
    // First the plot, because it uses the stack while it is drawn.
    delete plot_;
}

void SignalsView::setContent(SignalContent content) {
    content.time = tracks_.timeRange();
    plot_->setBackground(QBrush(content.theme.plotBackground));
    stack_->setContent(std::move(content), plot_->size());
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

const SignalContent& SignalsView::content() const {
    return stack_->content();
}

const SignalPicture& SignalsView::picture() const {
    return stack_->picture();
}

int SignalsView::timeWidth() const {
    return stack_->frameWidth(plot_->width());
}

void SignalsView::showCursors() {
    if (isVisible()) {
        plot_->layer(QStringLiteral("overlay"))->replot();
    }
}

double SignalsView::positionOf(double time_s) const {
    return stack_->panels().front()->timeAxis()->coordToPixel(time_s) + plot_->x();
}

double SignalsView::timeAt(const QPointF& position) const {
    return stack_->panels().front()->timeAxis()->pixelToCoord(position.x() - plot_->x());
}

bool SignalsView::inPlots(const QPointF& position) const {
    const QPoint in_plot = position.toPoint() - plot_->pos();
    return std::ranges::any_of(stack_->panels(), [&](const SignalPanel* panel) {
        return panel->outerRect().contains(in_plot);
    });
}

std::optional<Cursor> SignalsView::cursorAt(const QPointF& position) const {
    const auto at =
        hairAt(*stack_->panels().front(), {tracks_.cursor(Cursor::a), tracks_.cursor(Cursor::b)},
               position.x() - plot_->x());
    return at ? std::optional(static_cast<Cursor>(*at)) : std::nullopt;
}

void SignalsView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !inPlots(event->position())) {
        QWidget::mousePressEvent(event);
        return;
    }
    press_ = event->position();
    press_time_ = tracks_.timeRange();
    tracks_.zoom().endGesture();
    if (const auto which = cursorAt(press_); which && event->modifiers() == Qt::NoModifier) {
        drag_ = *which == Cursor::a ? Drag::cursorA : Drag::cursorB;
    } else {
        drag_ = event->modifiers() & Qt::ShiftModifier ? Drag::part : Drag::pan;
    }
}

void SignalsView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF position = event->position();
    const auto from_left = [&](const QPointF& at) { return at.x() - plot_->x(); };
    switch (drag_) {
        case Drag::none: setCursor(cursorAt(position) ? Qt::SplitHCursor : Qt::ArrowCursor); break;
        case Drag::pan: {
            const double step = (position.x() - press_.x()) / timeWidth() * press_time_.span();
            ZoomState state = tracks_.zoom().current();
            state.time = {press_time_.lower - step, press_time_.upper - step};
            tracks_.zoom().visit(std::move(state), Gesture::drag);
            return;  // without readout, which would flicker
        }
        case Drag::part:
            overlay_->setPart(AxisRange{from_left({std::min(press_.x(), position.x()), 0}),
                                        from_left({std::max(press_.x(), position.x()), 0})});
            showCursors();
            return;
        case Drag::cursorA: tracks_.moveCursor(Cursor::a, timeAt(position)); break;
        case Drag::cursorB: tracks_.moveCursor(Cursor::b, timeAt(position)); break;
    }
    const double time = timeAt(position);
    const bool inside = inPlots(position) && tracks_.timeRange().contains(time);
    tracks_.moveTracker(inside ? std::optional(time) : std::nullopt);
    showCursors();
}

void SignalsView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        QWidget::mouseReleaseEvent(event);
        return;
    }
    tracks_.zoom().endGesture();
    if (std::exchange(drag_, Drag::none) == Drag::part) {
        overlay_->setPart(std::nullopt);
        showCursors();
        const double other = event->position().x();
        if (std::abs(other - press_.x()) >= least_part) {
            ZoomState state = tracks_.zoom().current();
            state.time = {timeAt({std::min(press_.x(), other), 0}),
                          timeAt({std::max(press_.x(), other), 0})};
            tracks_.setZoom(std::move(state));
        }
    }
}

void SignalsView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        drag_ = Drag::none;
        tracks_.fit();
    }
}

void SignalsView::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    tracks_.moveTracker(std::nullopt);
    showCursors();
}

void SignalsView::wheelEvent(QWheelEvent* event) {
    // Touch pads report fractions of a notch.
    const double notches = event->angleDelta().y() / 120.;
    if (notches == 0 || !inPlots(event->position())) {
        event->ignore();
        return;
    }
    event->accept();
    tracks_.zoom().zoomTime(std::pow(ZoomNavigator::notch, notches), timeAt(event->position()),
                            Gesture::wheel_time);
}

void SignalsView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && drag_ == Drag::part) {
        drag_ = Drag::none;
        overlay_->setPart(std::nullopt);
        showCursors();
    } else if (!tracks_.takeTimeKey(event)) {
        QWidget::keyPressEvent(event);
    }
}

void SignalsView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    emit resized();
}

void SignalsView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange ||
        event->type() == QEvent::LocaleChange) {
        setContent(content());
    }
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

void SignalsView::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void SignalsView::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

}  // namespace vybeg::ui
