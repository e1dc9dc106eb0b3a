#pragma once

#include "core/base/result.h"
#include "ui/plots/plot_content.h"

#include <QImage>
#include <QPicture>
#include <QString>

namespace vybeg::ui {

// Stacked plots as they are put on paper: always in the light theme, with the runs' names above
// where there are several. `size` is in device-independent pixels.

// The size of a figure of these plots: as wide as a page, each plot as high as in figure.h. It is
// the same whatever else the window holds.
QSize paperSize(const PlotContent& content);

// `scale` pixels of the image per pixel of `size`.
QImage plotImage(const PlotContent& content, QSize size, double scale = 2);

// As drawing commands, for a page that is being painted: painter.drawPicture() after scaling.
QPicture plotPicture(const PlotContent& content, QSize size);

// To a file by its ending: .png (scale 2), .svg or .pdf (vectors). Drawn in memory, written
// once and renamed when complete. Errors: output_format_unknown, output_failed.
Status exportPlots(const PlotContent& content, QSize size, const QString& path);

// The same with one plot alone.
PlotContent onePlot(PlotContent content, SlowVariable variable);

// The image (scale 2) to the clipboard.
void copyPlots(const PlotContent& content, QSize size);

}  // namespace vybeg::ui
