#pragma once

#include "core/recording/envelope/envelope.h"
#include "ui/widgets/theme.h"

#include <QRect>

#include <vector>

class QPainter;

namespace vybeg::ui {

// Paints minima and maxima of both channels, one column per device pixel, C in the upper half of
// the area and D in the lower, with one scale. Columns of samples only are paler, unread ones
// hatched, missing samples marked at the foot.
void paintEnvelope(QPainter& painter, const QRect& area, const std::vector<EnvelopeBucket>& columns,
                   const Theme& theme);

}  // namespace vybeg::ui
