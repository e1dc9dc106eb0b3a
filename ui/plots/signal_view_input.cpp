// Mouse and keyboard of the overview strip; the rest is in signal_view.cpp.
#include "ui/plots/signal_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {
namespace {

constexpr double reach = 6;  // pixels from a handle
constexpr double notch_factor = 0.8;
constexpr double key_step = 0.1;  // of the range

// The range shifted as a whole into [0, seconds].
AxisRange inside(AxisRange range, double seconds) {
    const double span = std::min(range.span(), seconds);
    const double lower = std::clamp(range.lower, 0., seconds - span);
    return {lower, lower + span};
}

}  // namespace

bool SignalView::isBelow(const QPointF& position) const {
    return position.y() > plotArea().bottom();
}

SignalView::Grip SignalView::gripAt(const QPointF& position) const {
    if (!envelope_ || !rect().contains(position.toPoint())) {
        return Grip::none;
    }
    const AxisRange& range = isBelow(position) ? analysed_ : visible_;
    const double to_first = std::abs(toPixel(range.lower) - position.x());
    const double to_second = std::abs(toPixel(range.upper) - position.x());
    if (std::min(to_first, to_second) <= reach) {
        // With both handles within reach, the one on whose outer side the mouse is.
        const bool first =
            to_first == to_second ? position.x() < toPixel(range.lower) : to_first < to_second;
        return first ? Grip::from : Grip::to;
    }
    return range.contains(toTime(position.x())) ? Grip::all : Grip::none;
}

void SignalView::edit(bool analysed, AxisRange edited) {
    range(analysed) = edited;
    update();
    analysed ? emit analysedRangeEdited(edited.lower, edited.upper)
             : emit visibleRangeEdited(edited.lower, edited.upper);
}

void SignalView::drag(double time_s) {
    const double t = std::clamp(time_s, 0., seconds_);
    // A range is never reversed or smaller than a handle.
    const double least = std::abs(toTime(2) - toTime(0));
    const double shift = time_s - press_s_;
    const AxisRange now = range(grips_analysed_);
    switch (grip_) {
        case Grip::none: break;
        case Grip::from:
            edit(grips_analysed_, {std::max(0., std::min(t, now.upper - least)), now.upper});
            break;
        case Grip::to:
            edit(grips_analysed_, {now.lower, std::min(seconds_, std::max(t, now.lower + least))});
            break;
        case Grip::all:
            edit(grips_analysed_,
                 inside({press_range_.lower + shift, press_range_.upper + shift}, seconds_));
            break;
    }
}

void SignalView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !envelope_) {
        QWidget::mousePressEvent(event);
        return;
    }
    press_s_ = toTime(event->position().x());
    grip_ = gripAt(event->position());
    grips_analysed_ = isBelow(event->position());
    if (grip_ == Grip::none && !grips_analysed_) {
        const double half = 0.5 * visible_.span();
        edit(false, inside({press_s_ - half, press_s_ + half}, seconds_));
        grip_ = Grip::all;
    }
    press_range_ = range(grips_analysed_);
}

void SignalView::mouseMoveEvent(QMouseEvent* event) {
    if (grip_ != Grip::none) {
        drag(toTime(event->position().x()));
        return;
    }
    switch (gripAt(event->position())) {
        case Grip::none: setCursor(Qt::ArrowCursor); break;
        case Grip::all: setCursor(Qt::OpenHandCursor); break;
        default: setCursor(Qt::SizeHorCursor); break;
    }
    setToolTip(!envelope_ ? QString()
               : isBelow(event->position())
                   ? tr("Analysed range: drag the ends of the bar")
                   : tr("Visible range: drag the edges, or the inside to shift it"));
}

void SignalView::mouseReleaseEvent(QMouseEvent*) {
    grip_ = Grip::none;
}

void SignalView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (!envelope_) {
        return;
    }
    grip_ = Grip::none;
    edit(isBelow(event->position()), {0, seconds_});
}

void SignalView::zoomVisible(double factor, double about_s) {
    const double least = std::min(seconds_, 16 / rate_hz_);
    AxisRange range{about_s + factor * (visible_.lower - about_s),
                    about_s + factor * (visible_.upper - about_s)};
    if (range.span() < least) {
        return;
    }
    edit(false, inside(range, seconds_));
}

void SignalView::wheelEvent(QWheelEvent* event) {
    if (!envelope_ || event->angleDelta().y() == 0) {
        event->ignore();
        return;
    }
    event->accept();
    zoomVisible(std::pow(notch_factor, event->angleDelta().y() / 120.),
                std::clamp(toTime(event->position().x()), visible_.lower, visible_.upper));
}

void SignalView::keyPressEvent(QKeyEvent* event) {
    if (!envelope_) {
        QWidget::keyPressEvent(event);
        return;
    }
    const bool analysed = event->modifiers() & Qt::ShiftModifier;
    const AxisRange range = this->range(analysed);
    const auto edit = [&](AxisRange to) { this->edit(analysed, inside(to, seconds_)); };
    const double step = key_step * range.span();
    const double centre = 0.5 * (range.lower + range.upper);
    const auto scaled = [&](double factor) {
        const double half =
            0.5 * std::max(factor * range.span(), std::min(seconds_, 16 / rate_hz_));
        return AxisRange{centre - half, centre + half};
    };
    switch (event->key()) {
        case Qt::Key_Left: edit({range.lower - step, range.upper - step}); break;
        case Qt::Key_Right: edit({range.lower + step, range.upper + step}); break;
        case Qt::Key_Plus:
        case Qt::Key_Equal: edit(scaled(notch_factor)); break;
        case Qt::Key_Minus:
        case Qt::Key_Underscore: edit(scaled(1 / notch_factor)); break;
        case Qt::Key_Home: edit({0, seconds_}); break;
        default: QWidget::keyPressEvent(event);
    }
}

}  // namespace vybeg::ui
