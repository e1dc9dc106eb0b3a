// Painting of the overview strip; the rest is in signal_view.cpp.
#include "ui/plots/envelope_paint.h"
#include "ui/plots/signal_view.h"

#include <QLocale>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>

namespace vybeg::ui {
namespace {

constexpr double fault_row = 4;

QFont smallFont(const QWidget& widget) {
    QFont font = widget.font();
    font.setPixelSize(std::max(9, QFontInfo(font).pixelSize() - 2));
    return font;
}

}  // namespace

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

void SignalView::drawEnvelope(QPainter& painter, const QRect& area) const {
    const double ratio = painter.device()->devicePixelRatioF();
    const int count = std::max(1, static_cast<int>(area.width() * ratio));
    paintEnvelope(painter, area, envelope_->buckets(0, envelope_->frames(), count), theme_);
}

void SignalView::drawFaults(QPainter& painter, const QRect& area) const {
    if (!faults_) {
        return;
    }
    const auto x_of = [&](std::int64_t frame) {
        return toPixel(static_cast<double>(frame) / rate_hz_);
    };
    // There may be thousands of clipped ranges; those of one pixel are drawn once.
    double drawn_to = area.left();
    for (const FrameRange& range : faults_->clipped) {
        const double from = std::max(x_of(range.first), drawn_to);
        const double to = std::max(x_of(range.end()), from + 1);
        if (x_of(range.end()) > drawn_to) {
            painter.fillRect(QRectF(from, area.top(), to - from, fault_row), theme_.warning);
            drawn_to = to;
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
    QColor plate = theme_.plotBackground;
    plate.setAlphaF(0.75f);
    painter.fillRect(box.adjusted(-2, 1, 2, -1), plate);
    painter.setPen(theme_.text);
    painter.drawText(box, alignment, text);
}

// The time axis is that of the plots below, at the same place; where they show a part of it, the
// recording's length is known from here.
void SignalView::drawLength(QPainter& painter, const QRect& area) const {
    const int digits = seconds_ < 10 ? 3 : 5;
    drawLabel(painter, area, int(Qt::AlignRight | Qt::AlignBottom),
              QStringLiteral("%1 %2").arg(QLocale().toString(seconds_, 'g', digits), tr("s")));
}

}  // namespace vybeg::ui
