#include "ui/plots/envelope_paint.h"

#include <QPainter>
#include <QVector>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {
namespace {

using Buckets = std::vector<EnvelopeBucket>;

void paintLane(QPainter& painter, const ColumnRow& row, const Buckets& columns,
               const EnvelopeLane& lane) {
    QVector<QLineF> read;
    QVector<QLineF> looked_at;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const ChannelRange& range = columns[i].*lane.range;
        const auto low = static_cast<double>(range.min);
        const auto high = static_cast<double>(range.max);
        if (std::isfinite(low) && std::isfinite(high)) {
            const double x = row.area.left() + (static_cast<double>(i) + 0.5) * row.width;
            const double least = 0.5 * row.width;  // a constant signal remains visible as a line
            auto& lines = columns[i].coverage == Coverage::all ? read : looked_at;
            lines.append({x, lane.zero - lane.scale * high - least, x,
                          lane.zero - lane.scale * low + least});
        }
    }
    painter.setPen(QPen(lane.color, row.width, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(read);
    painter.setPen(QPen(translucent(lane.color, 0.45), row.width, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(looked_at);
}

}  // namespace

void paintEnvelope(QPainter& painter, const ColumnRow& row, const Buckets& columns,
                   std::initializer_list<EnvelopeLane> lanes, const Theme& theme) {
    for (std::size_t i = 0; i < columns.size();) {
        std::size_t end = i;
        while (end < columns.size() && columns[end].coverage == Coverage::none) {
            ++end;
        }
        if (end > i) {
            painter.fillRect(
                QRectF(row.area.left() + static_cast<double>(i) * row.width, row.area.top(),
                       static_cast<double>(end - i) * row.width, row.area.height()),
                QBrush(theme.grid, Qt::BDiagPattern));
        }
        i = std::max(end, i + 1);
    }
    for (const EnvelopeLane& lane : lanes) {
        paintLane(painter, row, columns, lane);
    }
    constexpr int missing_row = 3;
    const QColor veil = translucent(theme.warning, 0.35);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i].missing) {
            const double x = row.area.left() + (static_cast<double>(i) + 0.5) * row.width;
            painter.fillRect(QRectF(x - 0.5, row.area.top(), 1, row.area.height()), veil);
            painter.fillRect(QRectF(x - 1, row.area.bottom() - missing_row, 2, missing_row),
                             theme.warning);
        }
    }
}

}  // namespace vybeg::ui
