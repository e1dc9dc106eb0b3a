#pragma once

#include "core/base/result.h"

#include <QImage>
#include <QPicture>
#include <QString>

class QCustomPlot;

namespace vybeg::ui {

// A plot that needs no window, drawn at a size in device-independent pixels.

QImage toImage(QCustomPlot& plot, QSize size, double scale);
QPicture toPicture(QCustomPlot& plot, QSize size);

// By the ending of `path`: .png (scale 2), .svg or .pdf (vectors, text as text). Written to a
// temporary file and renamed when complete. Errors: output_format_unknown, output_failed.
Status writePlot(QCustomPlot& plot, QSize size, const QString& path);

}  // namespace vybeg::ui
