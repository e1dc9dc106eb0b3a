#include "ui/plots/time_gestures.h"

#include "ui/widgets/page_parts.h"
#include "ui/words/display_units.h"

#include <QCoreApplication>
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

// The instant with the resolution of a pixel.
QString timeText(const TimePanel& panel, double time_s) {
    const double pixel = panel.time().span() / std::max(1, panel.width());
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(pixel))), 0, 9);
    return numberLabel(time_s, decimals) + ' ' + QCoreApplication::translate("DisplayUnits", "s");
}

// Clears the labels of ticks that a label over them leaves in part: "2" of "20". Below what the
// layer holds already.
void clearTouched(QCPPainter& painter, const TimePanel& panel, const QRectF& label) {
    const QFontMetricsF metrics(panel.timeAxis()->tickLabelFont());
    const AxisTicks& ticks = panel.timeTicks();
    painter.setCompositionMode(QPainter::CompositionMode_DestinationOver);
    for (std::size_t k = 0; k < ticks.positions.size(); ++k) {
        const double width = metrics.horizontalAdvance(ticks.labels[static_cast<qsizetype>(k)]) + 2;
        const double left = panel.timeAxis()->coordToPixel(ticks.positions[k]) - 0.5 * width;
        if (left < label.right() && left + width > label.left()) {
            painter.fillRect(QRectF(left, label.top(), width, label.height()),
                             panel.theme().plotBackground);
        }
    }
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
}

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

TimeOverlay::TimeOverlay(const TimeStack& stack, const TimeGestures& gestures)
    : QCPLayerable(&stack.plot(), QStringLiteral("overlay")), stack_(stack), gestures_(gestures) {
    stack.plot().layer(QStringLiteral("overlay"))->setMode(QCPLayer::lmBuffered);
}

void TimeOverlay::applyDefaultAntialiasingHint(QCPPainter* painter) const {
    painter->setAntialiasing(false);
}

void TimeOverlay::draw(QCPPainter* painter) {
    const Theme& theme = stack_.theme();
    drawHair(*painter, gestures_.cursor(Cursor::a), theme.cursorA, QStringLiteral("A"));
    drawHair(*painter, gestures_.cursor(Cursor::b), theme.cursorB, QStringLiteral("B"));
    drawHair(*painter, gestures_.tracker(), theme.tracker, QString());
    if (band_) {
        painter->setAntialiasing(false);
        painter->setPen(QPen(theme.accent, 1));
        painter->setBrush(translucent(theme.accent, 0.15));
        painter->drawRect(*band_);
        painter->setBrush(Qt::NoBrush);
    }
}

// Solid with a name below, or dashed with its time below.
void TimeOverlay::drawHair(QCPPainter& painter, std::optional<double> time_s, const QColor& color,
                           const QString& name) const {
    if (!time_s || stack_.frames().empty() || !stack_.frames().front()->time().contains(*time_s)) {
        return;
    }
    const TimePanel& first = *stack_.frames().front();
    const TimePanel& last = *stack_.frames().back();
    const double x = std::round(first.timeAxis()->coordToPixel(*time_s));
    painter.setAntialiasing(false);
    painter.setPen(QPen(color, 1, name.isEmpty() ? Qt::DashLine : Qt::SolidLine));
    for (const TimePanel* frame : stack_.frames()) {
        painter.drawLine(QLineF(x, frame->rect().top(), x, frame->rect().bottom()));
    }
    // Instead of tick labels, not over curves.
    const QFontMetricsF metrics(first.font());
    const QString text = name.isEmpty() ? timeText(first, *time_s) : name;
    const double width = metrics.horizontalAdvance(text) + 10;
    const QRectF area(first.rect());
    const double left = std::clamp(x - 0.5 * width, area.left(),
                                   std::max(area.left(), first.rect().right() - width));
    const QRectF label(left, last.rect().bottom() + 4, width, metrics.height() + 2);
    clearTouched(painter, last, label);
    painter.setAntialiasing(true);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRoundedRect(label, 3, 3);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(stack_.theme().plotBackground);
    painter.setFont(first.font());
    painter.drawText(label, int(Qt::AlignCenter), text);
}

}  // namespace vybeg::ui

#include "moc_time_gestures.cpp"
