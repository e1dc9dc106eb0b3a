#pragma once

#include "core/recording/envelope/envelope.h"
#include "ui/widgets/theme.h"

#include <QColor>
#include <QRectF>

#include <vector>

class QPainter;

namespace vybeg::ui {

// Where columns lie: one beside the other from the left edge of the area on, pixels.
struct ColumnRow {
    QRectF area;
    double width = 1;  // of one column
};

// One channel of the columns: a value v lies at zero - scale v.
struct EnvelopeLane {
    QColor color;
    double zero = 0;
    double scale = 1;
    ChannelRange EnvelopeBucket::*range = nullptr;
};

// Minima and maxima of a channel; columns of samples only are paler.
void paintLane(QPainter& painter, const ColumnRow& row, const std::vector<EnvelopeBucket>& columns,
               const EnvelopeLane& lane);
// Marks at the foot where samples are missing.
void paintMissing(QPainter& painter, const ColumnRow& row,
                  const std::vector<EnvelopeBucket>& columns, const Theme& theme);
// Hatches what is not read yet.
void paintUnread(QPainter& painter, const ColumnRow& row,
                 const std::vector<EnvelopeBucket>& columns, const Theme& theme);

}  // namespace vybeg::ui
