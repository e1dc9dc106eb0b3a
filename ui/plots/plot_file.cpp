#include "ui/plots/plot_file.h"

#include "core/output/output_file.h"

#include <QBuffer>
#include <QFileInfo>
#include <QPageSize>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <qcustomplot.h>

#include <cmath>
#include <filesystem>

namespace vybeg::ui {
namespace {

constexpr double file_scale = 2;
constexpr int screen_dpi = 96;

void drawVectors(QCustomPlot& plot, QPaintDevice& device, QSize size, double scale) {
    QCPPainter painter;
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNonCosmetic);
    painter.begin(&device);
    painter.scale(scale, scale);
    plot.toPainter(&painter, size.width(), size.height());
    painter.end();
}

void writeSvg(QCustomPlot& plot, QSize size, QIODevice& device) {
    QSvgGenerator svg;
    svg.setOutputDevice(&device);
    svg.setResolution(screen_dpi);
    svg.setSize(size);
    svg.setViewBox(QRect(QPoint(0, 0), size));
    drawVectors(plot, svg, size, 1);
}

void writePdf(QCustomPlot& plot, QSize size, QIODevice& device) {
    constexpr double points_per_pixel = 72. / screen_dpi;
    constexpr int resolution = 1200;
    QPdfWriter pdf(&device);
    pdf.setResolution(resolution);
    pdf.setPageMargins(QMarginsF());
    pdf.setPageSize(QPageSize(QSizeF(size) * points_per_pixel, QPageSize::Point));
    drawVectors(plot, pdf, size, double(resolution) / screen_dpi);
}

}  // namespace

QImage toImage(QCustomPlot& plot, QSize size, double scale) {
    QImage image((QSizeF(size) * scale).toSize(), QImage::Format_RGB32);
    // 96 dpi per unit of scale, so that a pasted picture has its natural size.
    const int per_metre = static_cast<int>(std::lround(screen_dpi * scale / 0.0254));
    image.setDotsPerMeterX(per_metre);
    image.setDotsPerMeterY(per_metre);
    image.fill(Qt::white);
    QCPPainter painter(&image);
    painter.scale(scale, scale);
    plot.toPainter(&painter, size.width(), size.height());
    return image;
}

QPicture toPicture(QCustomPlot& plot, QSize size) {
    QPicture picture;
    drawVectors(plot, picture, size, 1);
    picture.setBoundingRect(QRect(QPoint(0, 0), size));
    return picture;
}

Status writePlot(QCustomPlot& plot, QSize size, const QString& path) {
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending != QStringLiteral("png") && ending != QStringLiteral("svg") &&
        ending != QStringLiteral("pdf")) {
        return Error{ErrorCode::output_format_unknown, path.toStdString(), {ending.toStdString()}};
    }
    // SVG and PDF are drawn in memory, because their writers ignore errors of the disk.
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    bool drawn = true;
    if (ending == QStringLiteral("png")) {
        drawn = toImage(plot, size, file_scale).save(&buffer, "PNG");
    } else if (ending == QStringLiteral("svg")) {
        writeSvg(plot, size, buffer);
    } else {
        writePdf(plot, size, buffer);
    }
    if (!drawn || bytes.isEmpty()) {
        return Error{ErrorCode::out_of_memory, {}, {}};
    }
    return write_file(std::filesystem::path(path.toStdU16String()),
                      {bytes.constData(), static_cast<std::size_t>(bytes.size())}, JobControl());
}

}  // namespace vybeg::ui
