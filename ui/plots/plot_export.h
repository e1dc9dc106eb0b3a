#pragma once

#include "core/base/result.h"
#include "ui/plots/plot_content.h"

#include <QImage>
#include <QPicture>
#include <QString>

namespace vybeg::ui {

// Stacked plots on paper: always in the light theme, with the names of several runs above. `size`
// is in device-independent pixels.

// The size of a figure of these plots: as wide as a page, each plot as high as in figure.h. It does
// not depend on the window.
QSize paperSize(const PlotContent& content);

// `scale` pixels of the image per pixel of `size`.
QImage plotImage(const PlotContent& content, QSize size, double scale = 2);

// The plots as drawing commands for a page: painter.drawPicture() after scaling.
QPicture plotPicture(const PlotContent& content, QSize size);

// Writes a file, format by its ending: .png (scale 2), .svg or .pdf (vectors). Drawn in memory,
// written once and renamed when complete. Errors: output_format_unknown, output_failed.
Status exportPlots(const PlotContent& content, QSize size, const QString& path);

// The content with one plot only.
PlotContent onePlot(PlotContent content, SlowVariable variable);

// Copies the image (scale 2) to the clipboard.
void copyPlots(const PlotContent& content, QSize size);

}  // namespace vybeg::ui
