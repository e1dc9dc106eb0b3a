#include "ui/plots/time_gestures.h"

#include "ui/plots/time_stack.h"
#include "ui/widgets/page_parts.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg::ui {

namespace {

// Longest pause between steps of one entry of the zoom history.
constexpr int gesture_pause_ms = 600;
// Longest useful history; its memory is negligible.
constexpr std::size_t longest = 200;

}  // namespace

ZoomNavigator::ZoomNavigator(std::function<ZoomState(ZoomState)> clipped)
    : clipped_(std::move(clipped)) {
    pause_.setSingleShot(true);
    pause_.setInterval(gesture_pause_ms);
}

void ZoomNavigator::visit(ZoomState state, Gesture gesture) {
    state = clipped_(std::move(state));
    if (state == current()) {
        return;
    }
    const bool same = gesture != Gesture::none && gesture == gesture_ && pause_.isActive();
    gesture_ = gesture;
    pause_.start();
    goTo(std::move(state), same);
}

void ZoomNavigator::goTo(ZoomState state, bool same_entry) {
    if (state != current()) {
        states_.resize(position_ + 1);
        if (same_entry) {
            states_.pop_back();
        } else if (states_.size() == longest) {
            states_.erase(states_.begin());
        }
        states_.push_back(std::move(state));
        position_ = states_.size() - 1;
    }
    emit moved();
}

void ZoomNavigator::restart(const ZoomState& state) {
    states_ = {state};
    position_ = 0;
    emit moved();
}

void ZoomNavigator::back() {
    if (canBack()) {
        endGesture();
        --position_;
        emit moved();
    }
}

void ZoomNavigator::forward() {
    if (canForward()) {
        endGesture();
        ++position_;
        emit moved();
    }
}

void ZoomNavigator::zoomTime(double factor, double about_s, Gesture gesture) {
    ZoomState state = current();
    const AxisRange old = state.time;
    state.time = {about_s + factor * (old.lower - about_s),
                  about_s + factor * (old.upper - about_s)};
    visit(std::move(state), gesture);
}

void ZoomNavigator::panTime(double fraction) {
    ZoomState state = current();
    const double step = fraction * state.time.span();
    state.time = {state.time.lower + step, state.time.upper + step};
    visit(std::move(state), Gesture::key_time);
}

bool ZoomNavigator::takeKey(const QKeyEvent& event) {
    const bool history = event.modifiers() & Qt::AltModifier;
    switch (event.key()) {
        case Qt::Key_R: back(); return true;
        case Qt::Key_Left: history ? back() : panTime(-arrow); return true;
        case Qt::Key_Right: history ? forward() : panTime(arrow); return true;
        default: return false;
    }
}

void ZoomNavigator::follow(const AxisRange& before, const AxisRange& now) {
    const AxisRange& shown = current().time;
    if (before != now && (shown == before || shown.lower >= now.upper || shown.upper > now.upper)) {
        restart({now, {}});
    }
}

TimeGestures::TimeGestures(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
    fill(new QVBoxLayout(this), {}, {plot_});
    // The view handles the mouse itself, not QCustomPlot.
    plot_->setAttribute(Qt::WA_TransparentForMouseEvents);
    plot_->setFocusPolicy(Qt::NoFocus);
    setMouseTracking(true);
    preparePlot(*plot_, lightTheme());
}

// First the plot, because it uses the stack.
TimeGestures::~TimeGestures() {
    delete plot_;
}

void TimeGestures::setPlots(const TimeStack* stack, TimeOverlay& overlay) {
    stack_.reset(stack);
    overlay_ = &overlay;
    connect(plot_, &QCustomPlot::afterLayout, this, [this] {
        if (isVisible() && !stack_->frames().empty()) {
            const QRect area = stack_->frames().front()->rect().translated(plot_->pos());
            emit timeAxisPlaced(area.left(), width() - 1 - area.right());
        }
    });
}

QPointF TimeGestures::inPlot(const QPointF& position) const {
    return position - plot_->pos();
}

double TimeGestures::timeAt(const QPointF& at) const {
    return stack_->frames().empty() ? 0
                                    : stack_->frames().front()->timeAxis()->pixelToCoord(at.x());
}

double TimeGestures::positionOf(double time_s) const {
    return stack_->frames().front()->timeAxis()->coordToPixel(time_s) + plot_->x();
}

std::optional<Cursor> TimeGestures::cursorAt(const QPointF& at) const {
    constexpr double reach = 4;  // pixels
    // The second is drawn above the first.
    for (const Cursor which : {Cursor::b, Cursor::a}) {
        const auto time_s = cursor(which);
        if (time_s && !stack_->frames().empty() &&
            std::abs(positionOf(*time_s) - plot_->x() - at.x()) <= reach) {
            return which;
        }
    }
    return std::nullopt;
}

// About the tracker where it is visible, else about the centre.
void TimeGestures::zoomByKey(double factor) {
    const AxisRange time = zoom().current().time;
    const bool at_tracker = tracker() && time.contains(*tracker());
    zoom().zoomTime(factor, at_tracker ? *tracker() : 0.5 * (time.lower + time.upper),
                    Gesture::key_time);
}

void TimeGestures::refreshOverlay() {
    if (isVisible()) {
        plot_->layer(QStringLiteral("overlay"))->replot();
    }
}

void TimeGestures::showBand(std::optional<QRectF> band) {
    overlay_->setBand(band);
    refreshOverlay();
}

// Through all plots.
QRectF TimeGestures::bandBetween(const QPointF& from, const QPointF& to) const {
    const QRectF area =
        QRectF(stack_->frames().front()->rect()).united(stack_->frames().back()->rect());
    return QRectF(QPointF(from.x(), area.top()), QPointF(to.x(), area.bottom()))
        .normalized()
        .intersected(area);
}

void TimeGestures::mousePressEvent(QMouseEvent* event) {
    const QPointF at = inPlot(event->position());
    if (event->button() != Qt::LeftButton || !stack_->frameAt(at) || !hasTime()) {
        QWidget::mousePressEvent(event);
        return;
    }
    press_ = at;
    press_state_ = zoom().current();
    pressedAt(at);
    zoom().endGesture();
    if (const auto which = cursorAt(at); which && event->modifiers() == Qt::NoModifier) {
        chosen_ = *which;
        drag_ = *which == Cursor::a ? Drag::cursorA : Drag::cursorB;
    } else {
        drag_ = event->modifiers() & Qt::ShiftModifier ? Drag::band : Drag::pan;
    }
}

void TimeGestures::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = inPlot(event->position());
    switch (drag_) {
        case Drag::none: setCursor(cursorAt(at) ? Qt::SplitHCursor : Qt::ArrowCursor); break;
        case Drag::pan: {
            const QPointF moved = at - press_;
            ZoomState state = press_state_;
            const double step =
                moved.x() / std::max(1, stack_->frames().front()->width()) * state.time.span();
            state.time = {state.time.lower - step, state.time.upper - step};
            panValues(state, moved);
            zoom().visit(std::move(state), Gesture::drag);
            return;  // without readout, which would flicker
        }
        case Drag::band: showBand(bandBetween(press_, at)); return;
        case Drag::cursorA: moveCursor(Cursor::a, timeAt(at)); break;
        case Drag::cursorB: moveCursor(Cursor::b, timeAt(at)); break;
    }
    hoverAt(at);
    const double time = timeAt(at);
    const bool inside = stack_->frameAt(at) && zoom().current().time.contains(time) && hasTime();
    moveTracker(inside ? std::optional(time) : std::nullopt);
}

void TimeGestures::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        QWidget::mouseReleaseEvent(event);
        return;
    }
    zoom().endGesture();
    if (std::exchange(drag_, Drag::none) != Drag::band) {
        return;
    }
    showBand(std::nullopt);
    const QRectF band = bandBetween(press_, inPlot(event->position()));
    if (band.width() >= least_band) {
        ZoomState state = zoom().current();
        state.time = {timeAt(band.topLeft()), timeAt(band.topRight())};
        zoomValuesTo(state, band);
        zoom().visit(std::move(state), Gesture::none);
    }
}

void TimeGestures::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        drag_ = Drag::none;
        fit();
    }
}

void TimeGestures::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    moveTracker(std::nullopt);
}

void TimeGestures::wheelEvent(QWheelEvent* event) {
    // Alt turns a wheel sideways on some desktops; touch pads report fractions of a notch.
    const double notches = event->angleDelta().y() / 120.;
    const QPointF at = inPlot(event->position());
    if (notches == 0 || !stack_->frameAt(at) || !hasTime()) {
        event->ignore();
        return;
    }
    event->accept();
    const double factor = std::pow(ZoomNavigator::notch, notches);
    if (!(event->modifiers() & Qt::ControlModifier) || !zoomValues(at, factor)) {
        zoom().zoomTime(factor, timeAt(at), Gesture::wheel_time);
    }
}

bool TimeGestures::takeTimeKey(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Home: fit(); return true;
        case Qt::Key_Plus:
        case Qt::Key_Equal: zoomIn(); return true;
        case Qt::Key_Minus: zoomOut(); return true;
        case Qt::Key_1:
        case Qt::Key_2:
            if (tracker()) {
                chosen_ = event->key() == Qt::Key_1 ? Cursor::a : Cursor::b;
                moveCursor(chosen_, tracker());
            }
            return true;
        case Qt::Key_0:
            moveCursor(Cursor::a, std::nullopt);
            moveCursor(Cursor::b, std::nullopt);
            return true;
        case Qt::Key_Left:
        case Qt::Key_Right:
            return (event->modifiers() & Qt::ShiftModifier &&
                    stepCursor(event->key() == Qt::Key_Left ? -1 : 1)) ||
                   zoom().takeKey(*event);
        default: return zoom().takeKey(*event);
    }
}

bool TimeGestures::stepCursor(int pixels) {
    if (!cursor(chosen_)) {
        chosen_ = chosen_ == Cursor::a ? Cursor::b : Cursor::a;
    }
    const auto time_s = cursor(chosen_);
    if (time_s && !stack_->frames().empty()) {
        const int width = std::max(1, stack_->frames().front()->width());
        moveCursor(chosen_, *time_s + pixels * zoom().current().time.span() / width);
    }
    return time_s.has_value();
}

void TimeGestures::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && drag_ == Drag::band) {
        drag_ = Drag::none;
        showBand(std::nullopt);
    } else if (!hasTime() || !takeKey(event)) {
        QWidget::keyPressEvent(event);
    }
}

}  // namespace vybeg::ui

#include "moc_time_gestures.cpp"
