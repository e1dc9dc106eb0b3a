// Mouse and keyboard of the values of a track view; the rest of the class is in track_view.cpp.
#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/plots/track_view.h"

#include <QKeyEvent>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {
namespace {

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

void TrackView::pressedAt(const QPointF& at) {
    const PlotPanel& panel = *stack_->panelAt(at);
    focus_.give(panel.variable());
    press_variable_ = panel.variable();
    press_values_ = panel.values();
}

// An automatic axis remains automatic; a fixed one moves along.
void TrackView::panValues(ZoomState& state, const QPointF& moved) {
    const PlotPanel* panel = stack_->panel(*press_variable_);
    if (panel && state.fixed.contains(panel->variable())) {
        state.fixed[panel->variable()] = changed(*panel->valueAxis(), press_values_, 1, 0,
                                                 moved.y() / std::max(1, panel->height()));
    }
}

QRectF TrackView::bandBetween(const QPointF& from, const QPointF& to) const {
    const PlotPanel* panel = stack_->panel(*press_variable_);
    return panel ? QRectF(from, to).normalized().intersected(QRectF(panel->rect())) : QRectF();
}

void TrackView::zoomValuesTo(ZoomState& state, const QRectF& band) {
    const PlotPanel* panel = stack_->panel(*press_variable_);
    if (panel && band.height() >= least_band) {
        state.fixed[panel->variable()] = {panel->valueAxis()->pixelToCoord(band.bottom()),
                                          panel->valueAxis()->pixelToCoord(band.top())};
    }
}

bool TrackView::zoomValues(const QPointF& at, double factor) {
    const PlotPanel& panel = *stack_->panelAt(at);
    const double about = (panel.bottom() - at.y()) / std::max(1, panel.height());
    changeValues(panel.variable(), factor, std::clamp(about, 0., 1.), 0, Gesture::wheel_value);
    return true;
}

// At the margin, the meaning of the symbol that stands there.
void TrackView::hoverAt(const QPointF& at) {
    const PlotPanel* panel = stack_->panelAt(at);
    const bool margin = panel && at.x() < panel->rect().left();
    setToolTip(margin ? displayMeaning(panel->variable()) : QString());
}

bool TrackView::takeKey(QKeyEvent* event) {
    if (content_.variables.empty()) {
        return false;
    }
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

}  // namespace vybeg::ui
