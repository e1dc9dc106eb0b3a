#pragma once

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QString>

class QApplication;
class QPalette;

namespace vybeg::ui {

enum class ThemeMode { system, light, dark };

// Colours of views, and the palette of widgets.
struct Theme {
    bool dark = false;
    QPalette palette;
    QColor plotBackground;   // around the axes
    QColor panelBackground;  // inside the axes
    QColor axis;             // frame and ticks
    QColor grid;
    QColor zeroLine;
    QColor text;
    QColor mutedText;
    QColor accent;   // handles, focus, the analysed range
    QColor tracker;  // hair line under the mouse
    QColor cursorA;
    QColor cursorB;
    QColor warning;  // missing samples and windows
    QColor kept;     // a limit
    QColor broken;   // likewise
    QColor signalC;
    QColor signalD;
};

// Style of the curve of an analysis: a colour, which is that of its recording, and a shade of it.
// Dashes are left to models and bounds: they chop a dense curve into bursts.
struct CurveStyle {
    QColor color;
    int shade = 0;  // from the colour itself away from the background
};
inline constexpr int curve_colors = 6;
inline constexpr int curve_shades = 5;

// Colours by meaning, so that a plot is the same value on screen, in both themes, and on paper.
enum class Ink { style, text, muted, channel_c, channel_d, accent, warning };

Theme lightTheme();
Theme darkTheme();

// Whether a palette is a dark one: the luminance of its window against that of its text.
bool isDark(const QPalette& palette);
// The theme that goes with a palette.
Theme themeOf(const QPalette& palette);

// Fusion style and the palette of the mode, which all widgets have on return; `system` uses the
// palette of the desktop. Call it again on QEvent::ThemeChange to follow the desktop.
Theme applyTheme(QApplication& app, ThemeMode mode);

// The index-th style: colours change fastest, then shades. -1 is the last colour, -2 the one before
// it, for curves that leave the first colours to others.
CurveStyle curveStyle(int index);

// The colour with its lightness changed until it is readable on the theme's panels: contrast 3.2 in
// the light, 4.5 in the dark theme. Shades (any >= 0) have more contrast.
QColor readable(const QColor& color, const Theme& theme, int shade = 0);

// The colour of an ink; `style`: number of curveStyle() for Ink::style, in another shade for
// `shades` > 0.
QColor inkColor(Ink ink, int style, const Theme& theme, int shades = 0);

// A colour of which a part, 0 to 1, covers the colours below it.
QColor translucent(QColor color, double part);

// Contrast of two opaque colours after WCAG 2, 1 to 21.
double contrast(const QColor& a, const QColor& b);

// An icon of resources/icons in the text colours of a palette, legible on light and dark.
QIcon themedIcon(const QString& name, const QPalette& palette);

}  // namespace vybeg::ui
