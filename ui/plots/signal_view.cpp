#include "ui/plots/signal_view.h"

#include "ui/plots/envelope_paint.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/display_units.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

namespace {

constexpr double fault_row = 4;

QFont smallFont(const QWidget& widget) {
    QFont font = widget.font();
    font.setPixelSize(std::max(9, QFontInfo(font).pixelSize() - 2));
    return font;
}

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

SignalView::SignalView(QWidget* parent) : QWidget(parent), theme_(themeOf(palette())) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Overview of the recording"));
    whenChanged(*this, {QEvent::Resize}, [this] { drawn_ = {}; });
}

void SignalView::setReading(double seconds) {
    envelope_.reset();
    faults_.reset();
    seconds_ = seconds;
    visible_ = analysed_ = {0, seconds};
    drawn_ = {};
    update();
}

void SignalView::setEnvelope(std::shared_ptr<const Envelope> envelope, double rate_hz) {
    envelope_ = std::move(envelope);
    rate_hz_ = rate_hz;
    seconds_ = static_cast<double>(envelope_->frames()) / rate_hz;
    drawn_ = {};
    update();
}

void SignalView::setFaults(std::shared_ptr<const SampleFaults> faults) {
    if (faults != faults_) {
        faults_ = std::move(faults);
        update();
    }
}

void SignalView::setMargins(int left, int right) {
    if (left == left_ && right == right_) {
        return;
    }
    left_ = left;
    right_ = right;
    drawn_ = {};
    update();
}

double SignalView::toPixel(double time_s) const {
    const QRect area = plotArea();
    return area.left() + (seconds_ > 0 ? time_s / seconds_ : 0) * area.width();
}

double SignalView::toTime(double pixel) const {
    const QRect area = plotArea();
    return (pixel - area.left()) / std::max(1, area.width()) * seconds_;
}

void SignalView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        setAccessibleName(tr("Overview of the recording"));
    }
    theme_ = themeOf(palette());
    drawn_ = {};
    update();
}

void SignalView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), theme_.plotBackground);
    const QRect area = plotArea();
    if (seconds_ <= 0 || area.width() < 8 || area.height() < 8) {
        return;
    }
    painter.setFont(smallFont(*this));
    if (!envelope_) {
        painter.fillRect(area, QBrush(theme_.grid, Qt::BDiagPattern));
    } else {
        if (drawn_.isNull()) {
            const double ratio = devicePixelRatioF();
            drawn_ = QPixmap((QSizeF(size()) * ratio).toSize());
            drawn_.setDevicePixelRatio(ratio);
            drawn_.fill(Qt::transparent);
            QPainter cache(&drawn_);
            cache.setFont(smallFont(*this));
            drawEnvelope(cache, area);
        }
        painter.drawPixmap(0, 0, drawn_);
        drawRanges(painter, area);
        drawFaults(painter, area);  // above the veil, also outside the visible range
    }
    if (!envelope_ || !envelope_->whole()) {
        drawLabel(painter, area, int(Qt::AlignRight | Qt::AlignTop), tr("reading…"));
    }
    drawLength(painter, area);
    if (hasFocus()) {
        painter.setPen(QPen(theme_.accent, 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

// Minima and maxima of both channels, one column per device pixel, C in the upper half of the area
// and D in the lower.
void SignalView::drawEnvelope(QPainter& painter, const QRect& area) const {
    const double ratio = painter.device()->devicePixelRatioF();
    const int count = std::max(1, static_cast<int>(area.width() * ratio));
    const std::vector<EnvelopeBucket> columns = envelope_->buckets(0, envelope_->frames(), count);
    const ColumnRow row{QRectF(area), 1 / ratio};
    const int lane_height = (area.height() - 2) / 2;
    // One scale for both, because their ratio shows the angle of the wave.
    float top = 0;
    for (const EnvelopeBucket& column : columns) {
        for (const float v : {column.c.min, column.c.max, column.d.min, column.d.max}) {
            top = std::isfinite(v) ? std::max(top, std::abs(v)) : top;
        }
    }
    const double scale = top > 0 ? 0.5 * (lane_height - 2) / static_cast<double>(top) : 0;
    paintEnvelope(painter, row, columns,
                  {{theme_.signalC, area.top() + 0.5 * lane_height, scale, &EnvelopeBucket::c},
                   {theme_.signalD, area.bottom() - 0.5 * lane_height, scale, &EnvelopeBucket::d}},
                  theme_);
}

void SignalView::drawFaults(QPainter& painter, const QRect& area) const {
    if (!faults_) {
        return;
    }
    const auto x_of = [&](std::int64_t frame) {
        return toPixel(static_cast<double>(frame) / rate_hz_);
    };
    // There may be thousands of ranges; those of one pixel are drawn once.
    for (const auto* const ranges : {&faults_->clipped, &faults_->still}) {
        double drawn_to = area.left();
        for (const FrameRange& range : *ranges) {
            const double from = std::max(x_of(range.first), drawn_to);
            const double to = std::max(x_of(range.end()), from + 1);
            if (x_of(range.end()) > drawn_to) {
                painter.fillRect(QRectF(from, area.top(), to - from, fault_row), theme_.warning);
                drawn_to = to;
            }
        }
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(theme_.warning);
    for (const PhaseStep& step : faults_->steps) {
        const double x = x_of(step.frame);
        painter.setPen(QPen(theme_.warning, 1));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setPen(Qt::NoPen);
        painter.drawPolygon(QPolygonF({{x - fault_row, double(area.top())},
                                       {x + fault_row, double(area.top())},
                                       {x, area.top() + 1.5 * fault_row}}));
    }
    painter.restore();
}

void SignalView::drawRanges(QPainter& painter, const QRect& area) const {
    const auto clip = [&](double x) {
        return std::clamp(x, double(area.left()), double(area.right() + 1));
    };
    const double from = clip(toPixel(visible_.lower));
    const double to = clip(toPixel(visible_.upper));
    const QColor veil = translucent(theme_.plotBackground, 0.68);
    painter.fillRect(QRectF(area.left(), area.top(), from - area.left(), area.height()), veil);
    painter.fillRect(QRectF(to, area.top(), area.right() + 1 - to, area.height()), veil);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme_.axis, 1));
    painter.drawRect(
        QRectF(from, area.top(), to - from, area.height()).adjusted(0.5, 0.5, -0.5, -0.5));
    painter.setPen(QPen(theme_.plotBackground, 1));
    painter.setBrush(theme_.text);
    for (const double x : {from, to}) {
        painter.drawRoundedRect(QRectF(x - 3.5, area.center().y() - 8, 7, 16), 3, 3);
    }
    // The analysed range: a bar below the signals with a handle at each end.
    const double first = clip(toPixel(analysed_.lower));
    const double last = clip(toPixel(analysed_.upper));
    const double y = area.bottom() + 0.5 * range_row + 1;
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme_.grid);
    painter.drawRect(QRectF(area.left(), y - 1, area.width(), 2));
    painter.setBrush(theme_.accent);
    painter.drawRect(QRectF(first, y - 1.5, last - first, 3));
    painter.setPen(QPen(theme_.plotBackground, 1));
    for (const double x : {first, last}) {
        painter.drawEllipse(QPointF(x, y), 4.5, 4.5);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setRenderHint(QPainter::Antialiasing, false);
    const int lane = (area.height() - 2) / 2;
    const QRect first_lane(area.left(), area.top(), area.width(), lane);
    drawLabel(painter, first_lane, int(Qt::AlignLeft | Qt::AlignTop), QStringLiteral("C"));
    drawLabel(painter, first_lane.translated(0, area.height() - lane),
              int(Qt::AlignLeft | Qt::AlignTop), QStringLiteral("D"));
}

void SignalView::drawLabel(QPainter& painter, const QRect& area, int alignment,
                           const QString& text) const {
    const QRectF box = painter.boundingRect(QRectF(area.adjusted(6, 0, -6, 0)), alignment, text);
    painter.fillRect(box.adjusted(-2, 1, 2, -1), translucent(theme_.plotBackground, 0.75));
    painter.setPen(theme_.text);
    painter.drawText(box, alignment, text);
}

// The time axis is that of the plots below, at the same place; where they show a part of it, the
// recording's length is known from here.
void SignalView::drawLength(QPainter& painter, const QRect& area) const {
    const int digits = seconds_ < 10 ? 3 : 5;
    drawLabel(painter, area, int(Qt::AlignRight | Qt::AlignBottom),
              QStringLiteral("%1 %2").arg(shortNumberText(seconds_, digits), tr("s")));
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

void SignalView::setRange(bool analysed, AxisRange range) {
    this->range(analysed) = range;
    update();
}

void SignalView::edit(bool analysed, AxisRange edited) {
    setRange(analysed, edited);
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

#include "moc_signal_view.cpp"
