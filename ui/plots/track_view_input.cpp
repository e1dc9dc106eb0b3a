// Mouse and keyboard of a track view; the rest of the class is in track_view.cpp.
#include "ui/plots/hair_line.h"
#include "ui/plots/plot_overlay.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/plots/track_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg::ui {
namespace {

constexpr double least_band = 5;  // pixels; a smaller one is a click

double scaled(const QCPAxis& axis, double coordinate) {
    return axis.scaleType() == QCPAxis::stLogarithmic ? std::log(coordinate) : coordinate;
}

double unscaled(const QCPAxis& axis, double position) {
    return axis.scaleType() == QCPAxis::stLogarithmic ? std::exp(position) : position;
}

// An axis' range scaled about a fraction of it and shifted by a fraction, on its own scale.
AxisRange changed(const QCPAxis& axis, const AxisRange& range, double factor, double about,
                  double shift) {
    const double lower = scaled(axis, range.lower);
    const double span = scaled(axis, range.upper) - lower;
    const double from = lower + about * span * (1 - factor) + shift * span;
    return {unscaled(axis, from), unscaled(axis, from + factor * span)};
}

}  // namespace

double TrackView::timeAt(const QPointF& position) const {
    return stack_->panels().empty()
               ? 0
               : stack_->panels().front()->timeAxis()->pixelToCoord(position.x());
}

std::optional<Cursor> TrackView::cursorAt(const QPointF& position) const {
    if (stack_->panels().empty()) {
        return std::nullopt;
    }
    const auto at = hairAt(*stack_->panels().front(), cursors_, position.x());
    return at ? std::optional(static_cast<Cursor>(*at)) : std::nullopt;
}

// About the tracker where it is visible, else about the centre.
void TrackView::zoomByKey(double factor) {
    const AxisRange time = timeRange();
    const bool at_tracker = tracker_ && time.contains(*tracker_);
    zoom_.zoomTime(factor, at_tracker ? *tracker_ : 0.5 * (time.lower + time.upper),
                   Gesture::key_time);
}

void TrackView::changeValues(SlowVariable variable, double factor, double about, double shift,
                             Gesture gesture) {
    const PlotPanel* panel = stack_->panel(variable);
    if (!panel) {
        return;
    }
    ZoomState state = zoom_.current();
    state.fixed[variable] = changed(*panel->valueAxis(), panel->values(), factor, about, shift);
    zoom_.visit(std::move(state), gesture);
}

void TrackView::zoomToBand(const QRectF& band) {
    const PlotPanel* panel = press_variable_ ? stack_->panel(*press_variable_) : nullptr;
    if (!panel || band.width() < least_band) {
        return;
    }
    ZoomState state = zoom_.current();
    state.time = {timeAt(band.topLeft()), timeAt(band.topRight())};
    if (band.height() >= least_band) {
        state.fixed[panel->variable()] = {panel->valueAxis()->pixelToCoord(band.bottom()),
                                          panel->valueAxis()->pixelToCoord(band.top())};
    }
    zoom_.visit(std::move(state), Gesture::none);
}

void TrackView::moveTracker(std::optional<double> time_s) {
    if (time_s == tracker_) {
        return;
    }
    setTracker(time_s);
    time_s ? emit trackerMoved(*time_s) : emit trackerLeft();
}

void TrackView::moveCursor(Cursor which, std::optional<double> time_s) {
    setCursor(which, time_s);
    emit cursorsChanged();
}

void TrackView::mousePressEvent(QMouseEvent* event) {
    const PlotPanel* panel = stack_->panelAt(event->position());
    if (event->button() != Qt::LeftButton || !panel || !coveredTime(content_.analyses)) {
        QWidget::mousePressEvent(event);
        return;
    }
    focus_.give(panel->variable());
    press_ = event->position();
    press_state_ = zoom_.current();
    press_variable_ = panel->variable();
    press_values_ = panel->values();
    zoom_.endGesture();
    if (const auto which = cursorAt(press_); which && event->modifiers() == Qt::NoModifier) {
        drag_ = *which == Cursor::a ? Drag::cursorA : Drag::cursorB;
    } else {
        drag_ = event->modifiers() & Qt::ShiftModifier ? Drag::rubberBand : Drag::pan;
    }
}

void TrackView::pan(const QPointF& position) {
    const PlotPanel* panel = stack_->panel(*press_variable_);
    const QPointF moved = position - press_;
    ZoomState state = press_state_;
    const double step = moved.x() / std::max(1, panel->width()) * state.time.span();
    state.time = {state.time.lower - step, state.time.upper - step};
    // An automatic axis remains automatic; a fixed one moves along.
    if (state.fixed.contains(panel->variable())) {
        state.fixed[panel->variable()] = changed(*panel->valueAxis(), press_values_, 1, 0,
                                                 moved.y() / std::max(1, panel->height()));
    }
    zoom_.visit(std::move(state), Gesture::drag);
}

void TrackView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF position = event->position();
    switch (drag_) {
        case Drag::none:
            QWidget::setCursor(cursorAt(position) ? QCursor(Qt::SplitHCursor)
                                                  : QCursor(Qt::ArrowCursor));
            break;
        case Drag::pan: pan(position); return;  // without readout, which would flicker
        case Drag::rubberBand: {
            const QRectF area(stack_->panel(*press_variable_)->rect());
            const QRectF band = QRectF(press_, position).normalized().intersected(area);
            overlay_->setRubberBand(band);
            refreshOverlay();
            return;
        }
        case Drag::cursorA: moveCursor(Cursor::a, timeAt(position)); break;
        case Drag::cursorB: moveCursor(Cursor::b, timeAt(position)); break;
    }
    const PlotPanel* panel = stack_->panelAt(position);
    // At the margin, the meaning of the symbol that stands there.
    const bool margin = panel && position.x() < panel->rect().left();
    setToolTip(margin ? displayMeaning(panel->variable()) : QString());
    const double time = timeAt(position);
    const bool inside = panel && timeRange().contains(time) && coveredTime(content_.analyses);
    moveTracker(inside ? std::optional(time) : std::nullopt);
}

void TrackView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        QWidget::mouseReleaseEvent(event);
        return;
    }
    const Drag finished = std::exchange(drag_, Drag::none);
    zoom_.endGesture();
    if (finished == Drag::rubberBand) {
        const QRectF area(stack_->panel(*press_variable_)->rect());
        overlay_->setRubberBand(std::nullopt);
        refreshOverlay();
        zoomToBand(QRectF(press_, event->position()).normalized().intersected(area));
    }
}

void TrackView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        drag_ = Drag::none;
        fit();
    }
}

void TrackView::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    moveTracker(std::nullopt);
}

void TrackView::wheelEvent(QWheelEvent* event) {
    // Alt turns a wheel sideways on some desktops; touch pads report fractions of a notch.
    const double notches = event->angleDelta().y() / 120.;
    const PlotPanel* panel = stack_->panelAt(event->position());
    if (notches == 0 || !panel || !coveredTime(content_.analyses)) {
        event->ignore();
        return;
    }
    event->accept();
    const double factor = std::pow(ZoomNavigator::notch, notches);
    if (event->modifiers() & Qt::ControlModifier) {
        const double height = std::max(1, panel->height());
        const double about = std::clamp((panel->bottom() - event->position().y()) / height, 0., 1.);
        changeValues(panel->variable(), factor, about, 0, Gesture::wheel_value);
    } else {
        zoom_.zoomTime(factor, timeAt(event->position()), Gesture::wheel_time);
    }
}

bool TrackView::takeTimeKey(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Home: fit(); return true;
        case Qt::Key_Plus:
        case Qt::Key_Equal: zoomIn(); return true;
        case Qt::Key_Minus: zoomOut(); return true;
        case Qt::Key_1:
        case Qt::Key_2:
            if (tracker_) {
                moveCursor(event->key() == Qt::Key_1 ? Cursor::a : Cursor::b, tracker_);
            }
            return true;
        case Qt::Key_0:
            moveCursor(Cursor::a, std::nullopt);
            moveCursor(Cursor::b, std::nullopt);
            return true;
        default: return zoom_.takeKey(*event);
    }
}

bool TrackView::keyMoves(QKeyEvent* event) {
    const bool up = event->key() == Qt::Key_Up;
    const bool in = event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal;
    const SlowVariable variable = focus_.focused().value_or(content_.variables.front());
    if (up || event->key() == Qt::Key_Down) {
        changeValues(variable, 1, 0.5, up ? ZoomNavigator::arrow : -ZoomNavigator::arrow,
                     Gesture::key_value);
    } else if (event->modifiers() & Qt::ControlModifier && (in || event->key() == Qt::Key_Minus)) {
        changeValues(variable, in ? ZoomNavigator::notch : 1 / ZoomNavigator::notch, 0.5, 0,
                     Gesture::key_value);
    } else {
        return takeTimeKey(event);
    }
    return true;
}

void TrackView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && drag_ == Drag::rubberBand) {
        drag_ = Drag::none;
        overlay_->setRubberBand(std::nullopt);
        refreshOverlay();
        return;
    }
    if (content_.variables.empty() || !coveredTime(content_.analyses) || !keyMoves(event)) {
        QWidget::keyPressEvent(event);
    }
}

}  // namespace vybeg::ui
