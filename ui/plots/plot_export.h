#pragma once

#include "ui/plots/plot_content.h"
#include "ui/plots/plot_file.h"

namespace vybeg::ui {

// Stacked plots on paper: always in the light theme, with the names of several analyses above.
Drawing plotsDrawing(const PlotContent& content);

// The size of a figure of these plots: as wide as a page, each plot as high as in figure.h. It does
// not depend on the window.
QSize paperSize(const PlotContent& content);

}  // namespace vybeg::ui
