#pragma once

#include "core/base/result.h"

#include <QByteArray>
#include <QImage>
#include <QPicture>
#include <QSize>
#include <QString>
#include <QStringList>

#include <functional>
#include <utility>
#include <vector>

class QCPPainter;

namespace vybeg::ui {

// Draws a figure of a size in device-independent pixels, 96 to the inch, without a window.
using Drawing = std::function<void(QCPPainter&, QSize)>;

inline constexpr double pixels_per_inch = 96;
inline constexpr double mm_per_inch = 25.4;

// Size of a figure, device-independent pixels, and the pixels to the inch of its image.
struct Paper {
    QSize size;
    double dpi = 2 * pixels_per_inch;
};

// A figure that can be exported.
struct Figure {
    Drawing draw;
    QSize size;    // as proposed
    QString name;  // of the file, as proposed, without its ending
};

QImage toImage(const Drawing& draw, const Paper& paper);
QPicture toPicture(const Drawing& draw, QSize size);

// A title above the figure and settings below it, in as many lines as they need.
Drawing withCaption(const Drawing& draw, const QString& title, const QString& settings);
// Height that the caption adds to a figure of that width.
int captionHeight(const QString& title, const QString& settings, int width);

// Format by the ending of `path`: .png, .svg or .pdf (vectors, text as text). Drawn in memory and
// written by write_file(). Errors: output_format_unknown, output_failed, out_of_memory.
Status writeDrawing(const Drawing& draw, const Paper& paper, const QString& path);

// A PDF of Qt without the instant of its making, so that the same document is the same bytes.
QByteArray withoutInstant(QByteArray pdf);

// To the clipboard: as image and, for programs that take vectors, as SVG.
void copyDrawing(const Drawing& draw, const Paper& paper);

// What a page offers for export: plots, of which some or all make one figure.
struct FigureSource {
    QStringList plots;  // their names; empty: nothing to export
    // The figure of these plots, by their places in `plots`, ascending.
    std::function<Figure(const std::vector<int>&)> figure;
    QString title;     // as proposed
    QString settings;  // of the analyses shown
};

// Those of all at these places.
template <class Value>
std::vector<Value> atPlaces(const std::vector<Value>& all, const std::vector<int>& places) {
    std::vector<Value> some;
    some.reserve(places.size());
    for (const int place : places) {
        some.push_back(all[static_cast<std::size_t>(place)]);
    }
    return some;
}

// Figures with their names, from which some are chosen; one below the other.
FigureSource sourceOf(const std::vector<std::pair<QString, Figure>>& figures, const QString& name,
                      const QString& title);

// Figures one below the other, of the width of the widest.
Figure stacked(const std::vector<Figure>& figures, const QString& name);

}  // namespace vybeg::ui
