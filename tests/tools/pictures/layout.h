#pragma once

#include <QImage>
#include <QRect>
#include <QSize>
#include <QString>
#include <QWidget>

#include <vector>

namespace vybeg::test {

// How a window divides its area. Shares are fractions of the area of the whole window.
struct Layout {
    QSize window;              // device-independent pixels
    int frames = 0;            // of plots, wholly visible
    double frame_share = 0;    // area of these frames
    double inkless_share = 0;  // pixels outside of frames whose left and upper neighbours are equal
    double blank_share = 0;    // pixels outside of frames without ink within `blank_reach`
};

// Half the height of a row of text: space between letters and lines is not blank.
inline constexpr int blank_reach = 8;  // device-independent pixels

// The frame of a plot is the rectangle of its axes: of QCustomPlot's axis rectangles and of the
// charts of Qt Charts. The overview strip, which has no axes of values, is not among them.
struct PlotFrame {
    QRect shown;  // its visible part in the window, device-independent pixels
    bool whole = false;
};

// The frames of the visible plots of a window, those hidden by scrolling left out.
std::vector<PlotFrame> plot_frames(const QWidget& window);

// `picture` shows `window` at any device pixel ratio.
Layout measure_layout(const QWidget& window, const QImage& picture);

// The table layout.csv: its line of names, and a row.
QString layout_names();
QString layout_row(const QString& picture, const Layout& layout);

}  // namespace vybeg::test
