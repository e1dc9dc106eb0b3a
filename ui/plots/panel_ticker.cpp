#include "ui/plots/panel_ticker.h"

namespace vybeg::ui {

void PanelTicker::setRoom(double length, const QFont& font, double beyond) {
    length_ = length;
    font_ = font;
    beyond_ = beyond;
}

void PanelTicker::generate(const QCPRange& range, const QLocale&, QChar, int,
                           QVector<double>& ticks, QVector<double>* subTicks,
                           QVector<QString>* tickLabels) {
    const QFontMetricsF metrics(font_);
    TickRoom room;
    room.length = length_;
    if (orientation_ == Qt::Horizontal) {
        room.spacing = 58;
        room.gap = 16;
        room.extent = [&](const QString& label) { return metrics.horizontalAdvance(label); };
    } else {
        room.spacing = 2.1 * metrics.height();
        room.gap = 1;
        room.extent = [&](const QString&) { return metrics.ascent() + metrics.descent(); };
    }
    const AxisRange shown{range.lower, range.upper};
    ticks_ = logarithmic_ ? logTicks(shown, room) : linearTicks(shown, room, steps_);
    ticks = QVector<double>(ticks_.positions.begin(), ticks_.positions.end());
    if (subTicks) {
        *subTicks = QVector<double>(ticks_.between.begin(), ticks_.between.end());
    }
    if (tickLabels) {
        *tickLabels = ticks_.labels;
        if (orientation_ == Qt::Horizontal && !tickLabels->isEmpty()) {
            // The last label is omitted if it would be cut.
            const double pixel = (ticks_.positions.back() - range.lower) / range.size() * length_;
            const double half = 0.5 * metrics.horizontalAdvance(tickLabels->last());
            if (pixel + half > length_ + beyond_) {
                tickLabels->last().clear();
            }
        }
    }
}

}  // namespace vybeg::ui
