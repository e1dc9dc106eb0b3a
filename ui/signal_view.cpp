#include "ui/signal_view.h"

#include "ui/axis_ticks.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {
namespace {

constexpr int time_row = 15;  // tick labels
constexpr int range_row = 9;  // bar of the analysed range
constexpr int missing_row = 3;

QFont smallFont(const QWidget& widget) {
    QFont font = widget.font();
    font.setPixelSize(std::max(9, QFontInfo(font).pixelSize() - 2));
    return font;
}

}  // namespace

SignalView::SignalView(QWidget* parent) : QWidget(parent), theme_(lightTheme()) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Overview of the recording"));
}

void SignalView::clear() {
    envelope_.reset();
    seconds_ = 0;
    drawn_ = {};
    update();
}

void SignalView::setReading(double seconds) {
    envelope_.reset();
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

void SignalView::setVisibleRange(AxisRange range) {
    visible_ = range;
    update();
}

void SignalView::setAnalysedRange(AxisRange range) {
    analysed_ = range;
    update();
}

void SignalView::setTheme(const Theme& theme) {
    theme_ = theme;
    drawn_ = {};
    update();
}

void SignalView::setMargins(int left, int right) {
    left_ = left;
    right_ = right;
    drawn_ = {};
    update();
}

QRect SignalView::plotArea() const {
    return rect().adjusted(left_, 3, -right_, -(time_row + range_row));
}

double SignalView::toPixel(double time_s) const {
    const QRect area = plotArea();
    return area.left() + (seconds_ > 0 ? time_s / seconds_ : 0) * area.width();
}

double SignalView::toTime(double pixel) const {
    const QRect area = plotArea();
    return (pixel - area.left()) / std::max(1, area.width()) * seconds_;
}

void SignalView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    drawn_ = {};
}

void SignalView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        setAccessibleName(tr("Overview of the recording"));
    }
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
        painter.setPen(theme_.mutedText);
        painter.drawText(area, Qt::AlignCenter, tr("reading…"));
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
    }
    drawTimes(painter, area);
    if (hasFocus()) {
        painter.setPen(QPen(theme_.accent, 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void SignalView::drawEnvelope(QPainter& painter, const QRect& area) const {
    const double ratio = painter.device()->devicePixelRatioF();
    const int columns = std::max(1, static_cast<int>(area.width() * ratio));
    const auto buckets = envelope_->buckets(0, envelope_->frames(), columns);
    const int lane_height = (area.height() - 2) / 2;
    // One scale for both: their ratio tells how the wave lies.
    float top = 0;
    for (const EnvelopeBucket& bucket : buckets) {
        for (const float v : {bucket.c_min, bucket.c_max, bucket.d_min, bucket.d_max}) {
            top = std::isfinite(v) ? std::max(top, std::abs(v)) : top;
        }
    }
    const double scale = top > 0 ? 0.5 * (lane_height - 2) / static_cast<double>(top) : 0;
    const double middle_c = area.top() + 0.5 * lane_height;
    const double middle_d = area.bottom() - 0.5 * lane_height;
    QVector<QLineF> c;
    QVector<QLineF> d;
    QVector<QRectF> missing;
    for (std::size_t i = 0; i < buckets.size(); ++i) {
        const EnvelopeBucket& bucket = buckets[i];
        const double x = area.left() + (static_cast<double>(i) + 0.5) / ratio;
        const auto add = [&](QVector<QLineF>& lines, double middle, double low, double high) {
            if (std::isfinite(low) && std::isfinite(high)) {
                const double least = 0.5 / ratio;  // a constant signal is a line, not nothing
                lines.append({x, middle - scale * high - least, x, middle - scale * low + least});
            }
        };
        add(c, middle_c, static_cast<double>(bucket.c_min), static_cast<double>(bucket.c_max));
        add(d, middle_d, static_cast<double>(bucket.d_min), static_cast<double>(bucket.d_max));
        if (bucket.missing) {
            missing.append({x - 0.5, double(area.top()), 1, double(area.height())});
        }
    }
    const double width = 1 / ratio;
    painter.setPen(QPen(theme_.signalC, width, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(c);
    painter.setPen(QPen(theme_.signalD, width, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(d);
    QColor veil = theme_.warning;
    veil.setAlphaF(0.35f);
    for (const QRectF& mark : missing) {
        painter.fillRect(mark, veil);
        painter.fillRect(QRectF(mark.left() - 0.5, area.bottom() - missing_row + 1, 2, missing_row),
                         theme_.warning);
    }
}

void SignalView::drawRanges(QPainter& painter, const QRect& area) const {
    const auto clip = [&](double x) {
        return std::clamp(x, double(area.left()), double(area.right() + 1));
    };
    const double from = clip(toPixel(visible_.lower));
    const double to = clip(toPixel(visible_.upper));
    QColor veil = theme_.plotBackground;
    veil.setAlphaF(0.68f);
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
        painter.drawRoundedRect(QRectF(x - 3.5, area.center().y() - 9, 7, 18), 3, 3);
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
    painter.setPen(theme_.text);
    const int lane = (area.height() - 2) / 2;
    const auto name = [&](const QString& text, int top) {
        const QRectF box = painter.boundingRect(QRectF(area.left() + 6, top, 60, lane),
                                                int(Qt::AlignLeft | Qt::AlignTop), text);
        QColor plate = theme_.plotBackground;
        plate.setAlphaF(0.75f);
        painter.fillRect(box.adjusted(-2, 1, 2, -1), plate);
        painter.drawText(box, int(Qt::AlignLeft | Qt::AlignTop), text);
    };
    name(QStringLiteral("C"), area.top());
    name(QStringLiteral("D"), area.bottom() - lane);
}

void SignalView::drawTimes(QPainter& painter, const QRect& area) const {
    const QFontMetricsF metrics(painter.font());
    TickRoom room{double(area.width()), 72, 16,
                  [&](const QString& label) { return metrics.horizontalAdvance(label); }};
    const AxisTicks ticks = linearTicks({0, seconds_}, room);
    const QString unit = scaledUnit(tr("s"), true, ticks.exponent);
    painter.setPen(theme_.mutedText);
    const double base = height() - 0.5 * time_row + 0.5 * metrics.ascent() - 1;
    for (qsizetype i = 0; i < ticks.labels.size(); ++i) {
        const QString text = ticks.labels[i] + ' ' + unit;
        const double width = metrics.horizontalAdvance(text);
        const double x = toPixel(ticks.positions[static_cast<std::size_t>(i)]) - 0.5 * width;
        // At the ends a label moves inward rather than being cut.
        const double shown = std::clamp(x, 2., std::max(2., this->width() - width - 2));
        painter.drawText(QPointF(shown, base), text);
    }
}

}  // namespace vybeg::ui
