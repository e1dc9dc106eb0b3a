#pragma once

#include "core/recording/envelope/envelope.h"
#include "ui/widgets/theme.h"

#include <QColor>
#include <QRectF>

#include <initializer_list>
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

// Minima and maxima of channels; columns of samples only are paler. The part not read yet is
// hatched below them; marks at the foot are above them, where samples are missing.
void paintEnvelope(QPainter& painter, const ColumnRow& row,
                   const std::vector<EnvelopeBucket>& columns,
                   std::initializer_list<EnvelopeLane> lanes, const Theme& theme);

}  // namespace vybeg::ui
