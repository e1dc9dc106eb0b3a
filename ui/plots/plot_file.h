#pragma once

#include "core/base/result.h"

#include <QImage>
#include <QPicture>
#include <QString>

class QCustomPlot;

namespace vybeg::ui {

// A plot without a window, drawn at a size in device-independent pixels.

QImage toImage(QCustomPlot& plot, QSize size, double scale);
QPicture toPicture(QCustomPlot& plot, QSize size);

// Format by the ending of `path`: .png (scale 2), .svg or .pdf (vectors, text as text). Drawn in
// memory and written by write_file(). Errors: output_format_unknown, output_failed, out_of_memory.
Status writePlot(QCustomPlot& plot, QSize size, const QString& path);

}  // namespace vybeg::ui
