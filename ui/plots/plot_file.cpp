#include "ui/plots/plot_file.h"

#include "core/output/output_file.h"

#include <QBuffer>
#include <QClipboard>
#include <QFileInfo>
#include <QFontMetrics>
#include <QGuiApplication>
#include <QMimeData>
#include <QPageSize>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace vybeg::ui {

namespace {

constexpr int title_pixels = 15;
constexpr int settings_pixels = 11;
constexpr int caption_margin = 8;
constexpr int caption_flags = Qt::AlignCenter | Qt::TextWordWrap;
// The scale is Qt's: 100 does not compress. A plot takes two thirds of the time of Qt's own choice
// and a third more bytes.
constexpr int png_quality = 70;

void drawVectors(const Drawing& draw, QPaintDevice& device, QSize size, double scale) {
    QCPPainter painter;
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNonCosmetic);
    painter.begin(&device);
    painter.scale(scale, scale);
    draw(painter, size);
    painter.end();
}

void writeSvg(const Drawing& draw, QSize size, QIODevice& device) {
    QSvgGenerator svg;
    svg.setOutputDevice(&device);
    svg.setResolution(static_cast<int>(pixels_per_inch));
    svg.setSize(size);
    svg.setViewBox(QRect(QPoint(0, 0), size));
    drawVectors(draw, svg, size, 1);
}

void writePdf(const Drawing& draw, QSize size, QIODevice& device) {
    constexpr double points_per_pixel = 72. / pixels_per_inch;
    constexpr int resolution = 1200;
    QPdfWriter pdf(&device);
    pdf.setResolution(resolution);
    pdf.setPageMargins(QMarginsF());
    pdf.setPageSize(QPageSize(QSizeF(size) * points_per_pixel, QPageSize::Point));
    drawVectors(draw, pdf, size, resolution / pixels_per_inch);
}

// SVG and PDF are drawn in memory, because their writers ignore errors of the disk.
template <class Draw>
QByteArray drawn(const Draw& draw) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    draw(buffer);
    return bytes;
}

QFont captionFont(int pixels) {
    QFont font = QGuiApplication::font();
    font.setPixelSize(pixels);
    return font;
}

// Height of a text above or below the plots, in lines as the width has room for; 0: no text.
int textHeight(const QString& text, int pixels, int width) {
    if (text.isEmpty()) {
        return 0;
    }
    const QRect room(0, 0, std::max(1, width - 2 * caption_margin), QWIDGETSIZE_MAX);
    return QFontMetrics(captionFont(pixels)).boundingRect(room, caption_flags, text).height() +
           caption_margin;
}

}  // namespace

QImage toImage(const Drawing& draw, const Paper& paper) {
    const double scale = paper.dpi / pixels_per_inch;
    QImage image((QSizeF(paper.size) * scale).toSize(), QImage::Format_RGB32);
    // So that a pasted picture has its natural size.
    const int per_metre = static_cast<int>(std::lround(paper.dpi / mm_per_inch * 1000));
    image.setDotsPerMeterX(per_metre);
    image.setDotsPerMeterY(per_metre);
    image.fill(Qt::white);
    if (!image.isNull()) {
        QCPPainter painter(&image);
        painter.scale(scale, scale);
        draw(painter, paper.size);
    }
    return image;
}

QPicture toPicture(const Drawing& draw, QSize size) {
    QPicture picture;
    drawVectors(draw, picture, size, 1);
    picture.setBoundingRect(QRect(QPoint(0, 0), size));
    return picture;
}

int captionHeight(const QString& title, const QString& settings, int width) {
    return textHeight(title, title_pixels, width) + textHeight(settings, settings_pixels, width);
}

Drawing withCaption(const Drawing& draw, const QString& title, const QString& settings) {
    return [draw, title, settings](QCPPainter& painter, QSize size) {
        const int above = textHeight(title, title_pixels, size.width());
        const int below = textHeight(settings, settings_pixels, size.width());
        const auto text = [&](const QString& what, int pixels, const QRect& room) {
            painter.setFont(captionFont(pixels));
            painter.setPen(Qt::black);
            painter.drawText(room.adjusted(caption_margin, 0, -caption_margin, 0), caption_flags,
                             what);
        };
        painter.save();
        painter.fillRect(QRect(QPoint(0, 0), size), Qt::white);
        text(title, title_pixels, QRect(0, 0, size.width(), above));
        text(settings, settings_pixels, QRect(0, size.height() - below, size.width(), below));
        painter.translate(0, above);
        draw(painter, QSize(size.width(), size.height() - above - below));
        painter.restore();
    };
}

Status writeDrawing(const Drawing& draw, const Paper& paper, const QString& path) {
    const QString ending = QFileInfo(path).suffix().toLower();
    bool known = true;
    QByteArray bytes = drawn([&](QIODevice& device) {
        if (ending == QStringLiteral("png")) {
            toImage(draw, paper).save(&device, "PNG", png_quality);
        } else if (ending == QStringLiteral("svg")) {
            writeSvg(draw, paper.size, device);
        } else if (ending == QStringLiteral("pdf")) {
            writePdf(draw, paper.size, device);
        } else {
            known = false;
        }
    });
    if (!known) {
        return check_ending(std::filesystem::path(path.toStdU16String()), {".png", ".svg", ".pdf"});
    }
    if (bytes.isEmpty()) {
        return Error{ErrorCode::out_of_memory, {}, {}};
    }
    bytes = ending == QStringLiteral("pdf") ? withoutInstant(std::move(bytes)) : bytes;
    return write_file(std::filesystem::path(path.toStdU16String()),
                      {bytes.constData(), static_cast<std::size_t>(bytes.size())}, JobControl());
}

// Blanks, because the document's table has the place of each object.
QByteArray withoutInstant(QByteArray pdf) {
    const qsizetype from = pdf.indexOf("/CreationDate (D:");
    const qsizetype to = from < 0 ? from : pdf.indexOf(')', from);
    return to < 0 ? pdf : pdf.replace(from, to + 1 - from, QByteArray(to + 1 - from, ' '));
}

void copyDrawing(const Drawing& draw, const Paper& paper) {
    auto* data = new QMimeData;
    data->setImageData(toImage(draw, paper));
    data->setData(QStringLiteral("image/svg+xml"),
                  drawn([&](QIODevice& device) { writeSvg(draw, paper.size, device); }));
    QGuiApplication::clipboard()->setMimeData(data);
}

Figure stacked(const std::vector<Figure>& figures, const QString& name) {
    Figure all{{}, {}, name};
    for (const Figure& figure : figures) {
        all.size.setWidth(std::max(all.size.width(), figure.size.width()));
        all.size.rheight() += figure.size.height();
    }
    const int proposed = std::max(1, all.size.height());
    all.draw = [figures, proposed](QCPPainter& painter, QSize size) {
        int top = 0;
        for (const Figure& figure : figures) {
            const int height = size.height() * figure.size.height() / proposed;
            painter.save();
            painter.translate(0, top);
            figure.draw(painter, {size.width(), height});
            painter.restore();
            top += height;
        }
    };
    return all;
}

FigureSource sourceOf(const std::vector<std::pair<QString, Figure>>& figures, const QString& name,
                      const QString& title) {
    FigureSource source;
    std::vector<Figure> drawings;
    for (const auto& [plot, figure] : figures) {
        source.plots << plot;
        drawings.push_back(figure);
    }
    source.title = title;
    source.figure = [drawings, name](const std::vector<int>& places) {
        return stacked(atPlaces(drawings, places), name);
    };
    return source;
}

}  // namespace vybeg::ui
