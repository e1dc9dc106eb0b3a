#pragma once

#include <qcustomplot.h>

#include <vector>

namespace vybeg::ui {

// Look of a hair line: solid with a name below, or dashed with its time below.
struct HairLook {
    QColor color;
    QString name;  // empty: the time
    QFont font;
    QColor label_text;
};

// A vertical line at an instant through stacked plots of one time axis; nothing outside it.
void drawHair(QCPPainter& painter, const std::vector<QCPAxisRect*>& panels, double time_s,
              const HairLook& look);

}  // namespace vybeg::ui
