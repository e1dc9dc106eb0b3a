#pragma once

#include <qcustomplot.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace vybeg::ui {

// Look of a hair line: solid with a name below, or dashed with its time below.
struct HairLook {
    QColor color;
    QString name;  // empty: the time
    QFont font;
    QColor label_text;  // as the plot's background
};

// A vertical line at an instant through stacked plots of one time axis; nothing outside it.
void drawHair(QCPPainter& painter, const std::vector<QCPAxisRect*>& panels, double time_s,
              const HairLook& look);

// The number of the hair line within reach of the mouse at a pixel of the plot, the upper one of
// two.
std::optional<std::size_t> hairAt(const QCPAxisRect& panel,
                                  const std::array<std::optional<double>, 2>& times_s, double x);

}  // namespace vybeg::ui
