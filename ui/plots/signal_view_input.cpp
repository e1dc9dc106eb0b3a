// Mouse and keyboard of the overview strip; the rest is in signal_view.cpp.
#include "ui/plots/signal_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <array>
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

SignalView::Grip SignalView::gripAt(const QPointF& position) const {
    if (!envelope_ || !rect().contains(position.toPoint())) {
        return Grip::none;
    }
    struct Candidate {
        Grip grip;
        double time_s;
    };
    const bool analysed = position.y() > plotArea().bottom();
    const std::array<Candidate, 2> ends =
        analysed ? std::array<Candidate, 2>{{{Grip::analysed_from, analysed_.lower},
                                             {Grip::analysed_to, analysed_.upper}}}
                 : std::array<Candidate, 2>{
                       {{Grip::visible_from, visible_.lower}, {Grip::visible_to, visible_.upper}}};
    const double to_first = std::abs(toPixel(ends[0].time_s) - position.x());
    const double to_second = std::abs(toPixel(ends[1].time_s) - position.x());
    if (std::min(to_first, to_second) <= reach) {
        // With both handles within reach, the one on whose outer side the mouse is.
        if (to_first == to_second) {
            return position.x() < toPixel(ends[0].time_s) ? ends[0].grip : ends[1].grip;
        }
        return to_first < to_second ? ends[0].grip : ends[1].grip;
    }
    const AxisRange range = analysed ? analysed_ : visible_;
    if (range.contains(toTime(position.x()))) {
        return analysed ? Grip::analysed_all : Grip::visible_all;
    }
    return Grip::none;
}

void SignalView::editVisible(AxisRange range) {
    visible_ = range;
    update();
    emit visibleRangeEdited(range.lower, range.upper);
}

void SignalView::editAnalysed(AxisRange range) {
    analysed_ = range;
    update();
    emit analysedRangeEdited(range.lower, range.upper);
}

void SignalView::drag(double time_s) {
    const double t = std::clamp(time_s, 0., seconds_);
    // A range is never reversed or smaller than a handle.
    const double least = std::abs(toTime(2) - toTime(0));
    const double shift = time_s - press_s_;
    const AxisRange moved =
        inside({press_range_.lower + shift, press_range_.upper + shift}, seconds_);
    switch (grip_) {
        case Grip::none: break;
        case Grip::visible_from:
            editVisible({std::max(0., std::min(t, visible_.upper - least)), visible_.upper});
            break;
        case Grip::visible_to:
            editVisible({visible_.lower, std::min(seconds_, std::max(t, visible_.lower + least))});
            break;
        case Grip::visible_all: editVisible(moved); break;
        case Grip::analysed_from:
            editAnalysed({std::max(0., std::min(t, analysed_.upper - least)), analysed_.upper});
            break;
        case Grip::analysed_to:
            editAnalysed(
                {analysed_.lower, std::min(seconds_, std::max(t, analysed_.lower + least))});
            break;
        case Grip::analysed_all: editAnalysed(moved); break;
    }
}

void SignalView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !envelope_) {
        QWidget::mousePressEvent(event);
        return;
    }
    press_s_ = toTime(event->position().x());
    grip_ = gripAt(event->position());
    if (grip_ == Grip::none && event->position().y() <= plotArea().bottom()) {
        const double half = 0.5 * visible_.span();
        editVisible(inside({press_s_ - half, press_s_ + half}, seconds_));
        grip_ = Grip::visible_all;
    }
    const bool analysed =
        grip_ == Grip::analysed_from || grip_ == Grip::analysed_to || grip_ == Grip::analysed_all;
    press_range_ = analysed ? analysed_ : visible_;
}

void SignalView::mouseMoveEvent(QMouseEvent* event) {
    if (grip_ != Grip::none) {
        drag(toTime(event->position().x()));
        return;
    }
    switch (gripAt(event->position())) {
        case Grip::none: setCursor(Qt::ArrowCursor); break;
        case Grip::visible_all:
        case Grip::analysed_all: setCursor(Qt::OpenHandCursor); break;
        default: setCursor(Qt::SizeHorCursor); break;
    }
    const bool analysed = event->position().y() > plotArea().bottom();
    setToolTip(!envelope_ ? QString()
               : analysed ? tr("Analysed range: drag the ends of the bar")
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
    if (event->position().y() > plotArea().bottom()) {
        editAnalysed({0, seconds_});
    } else {
        editVisible({0, seconds_});
    }
}

void SignalView::zoomVisible(double factor, double about_s) {
    const double least = std::min(seconds_, 16 / rate_hz_);
    AxisRange range{about_s + factor * (visible_.lower - about_s),
                    about_s + factor * (visible_.upper - about_s)};
    if (range.span() < least) {
        return;
    }
    editVisible(inside(range, seconds_));
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
    const AxisRange range = analysed ? analysed_ : visible_;
    const auto edit = [&](AxisRange to) {
        analysed ? editAnalysed(inside(to, seconds_)) : editVisible(inside(to, seconds_));
    };
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
