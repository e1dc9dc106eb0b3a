#include "tests/tools/pictures/layout.h"

#include <QChart>
#include <QChartView>
#include <QStringList>
#include <qcustomplot.h>

#include <algorithm>
#include <cstdint>

namespace vybeg::test {
namespace {

// A rectangle in `widget` as the scrolled areas and other widgets around it leave it, in the
// window.
QRect visible_part(const QRect& rectangle, const QWidget& widget, const QWidget& window) {
    QRect part(widget.mapTo(&window, rectangle.topLeft()), rectangle.size());
    for (const QWidget* around = &widget; around; around = around->parentWidget()) {
        part &= QRect(around->mapTo(&window, QPoint()), around->size());
        if (around == &window) {
            break;
        }
    }
    return part;
}

void add_frame(std::vector<PlotFrame>& frames, const QRect& frame, const QWidget& plot,
               const QWidget& window) {
    const QRect shown = visible_part(frame, plot, window);
    if (!shown.isEmpty()) {
        frames.push_back({shown, shown.size() == frame.size()});
    }
}

// Sums of ink over rectangles from the picture's corner, from which those over any rectangle
// follow.
class InkSums {
public:
    // A pixel has ink where it differs from the one at its left or above it.
    explicit InkSums(const QImage& picture)
        : width_(picture.width()),
          sums_(static_cast<std::size_t>(width_ + 1) *
                static_cast<std::size_t>(picture.height() + 1)) {
        const QRgb* above = nullptr;
        for (int y = 0; y < picture.height(); ++y) {
            const auto* line = reinterpret_cast<const QRgb*>(picture.constScanLine(y));
            std::int32_t in_line = 0;
            for (int x = 0; x < width_; ++x) {
                in_line += (x > 0 && line[x] != line[x - 1]) || (above && line[x] != above[x]);
                sums_[place(x + 1, y + 1)] = sums_[place(x + 1, y)] + in_line;
            }
            above = line;
        }
    }

    // In columns from `left` and lines from `top`, before `right` and `bottom`.
    std::int32_t between(int left, int top, int right, int bottom) const {
        return sums_[place(right, bottom)] - sums_[place(left, bottom)] - sums_[place(right, top)] +
               sums_[place(left, top)];
    }

private:
    std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 1) +
               static_cast<std::size_t>(x);
    }

    int width_;
    std::vector<std::int32_t> sums_;
};

// Device pixels of a rectangle of device-independent ones.
QRect scaled(const QRect& rectangle, double ratio) {
    return QRectF(rectangle.x() * ratio, rectangle.y() * ratio, rectangle.width() * ratio,
                  rectangle.height() * ratio)
        .toAlignedRect();
}

void add_empty_shares(Layout& layout, const std::vector<PlotFrame>& frames, const QImage& picture) {
    const int width = picture.width();
    const int height = picture.height();
    const double ratio = picture.devicePixelRatio();
    const int reach = static_cast<int>(blank_reach * ratio);
    const InkSums ink(picture);
    std::vector<std::uint8_t> in_frame(static_cast<std::size_t>(width) *
                                       static_cast<std::size_t>(height));
    for (const PlotFrame& frame : frames) {
        const QRect covered = scaled(frame.shown, ratio) & picture.rect();
        for (int y = covered.top(); y <= covered.bottom(); ++y) {
            std::fill_n(in_frame.begin() + std::ptrdiff_t{y} * width + covered.left(),
                        covered.width(), std::uint8_t{1});
        }
    }
    std::int64_t inkless = 0;
    std::int64_t blank = 0;
    for (int y = 0; y < height; ++y) {
        const int top = std::max(0, y - reach);
        const int bottom = std::min(height, y + reach + 1);
        for (int x = 0; x < width; ++x) {
            if (in_frame[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(x)] != 0) {
                continue;
            }
            inkless += ink.between(x, y, x + 1, y + 1) == 0;
            blank += ink.between(std::max(0, x - reach), top, std::min(width, x + reach + 1),
                                 bottom) == 0;
        }
    }
    const double all = static_cast<double>(width) * height;
    layout.inkless_share = static_cast<double>(inkless) / all;
    layout.blank_share = static_cast<double>(blank) / all;
}

}  // namespace

std::vector<PlotFrame> plot_frames(const QWidget& window) {
    std::vector<PlotFrame> frames;
    for (const QCustomPlot* plot : window.findChildren<QCustomPlot*>()) {
        if (!plot->isVisible()) {
            continue;
        }
        for (const QCPAxisRect* panel : plot->axisRects()) {
            const QCPAxis* axis = panel->axis(QCPAxis::atLeft);
            // Without an analysis the view of the tracks hides its axes.
            if (axis && axis->layer()->visible()) {
                add_frame(frames, panel->rect(), *plot, window);
            }
        }
    }
    for (const QChartView* view : window.findChildren<QChartView*>()) {
        if (view->isVisible()) {
            const QRectF area = view->chart()->mapRectToScene(view->chart()->plotArea());
            add_frame(frames, view->mapFromScene(area).boundingRect(), *view, window);
        }
    }
    return frames;
}

Layout measure_layout(const QWidget& window, const QImage& picture) {
    const std::vector<PlotFrame> frames = plot_frames(window);
    Layout layout{window.size()};
    const double all = static_cast<double>(window.width()) * window.height();
    for (const PlotFrame& frame : frames) {
        if (frame.whole) {
            ++layout.frames;
            layout.frame_share +=
                static_cast<double>(frame.shown.width()) * frame.shown.height() / all;
        }
    }
    add_empty_shares(layout, frames, picture.convertToFormat(QImage::Format_RGB32));
    return layout;
}

QString layout_names() {
    return QStringLiteral("picture,width,height,frames,frame_share,inkless_share,blank_share");
}

QString layout_row(const QString& picture, const Layout& layout) {
    const auto share = [](double value) { return QString::number(value, 'f', 4); };
    return QStringList{picture,
                       QString::number(layout.window.width()),
                       QString::number(layout.window.height()),
                       QString::number(layout.frames),
                       share(layout.frame_share),
                       share(layout.inkless_share),
                       share(layout.blank_share)}
        .join(',');
}

}  // namespace vybeg::test
