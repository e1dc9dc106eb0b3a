#include "ui/widgets/theme.h"

#include <QApplication>
#include <QFile>
#include <QPainter>
#include <QPixmap>
#include <QProxyStyle>
#include <QStyleOption>
#include <QSvgRenderer>

#include <array>
#include <cmath>

namespace vybeg::ui {

namespace {

struct PaletteRow {
    QPalette::ColorRole role;
    const char* light;
    const char* dark;
};

constexpr std::array palette_rows{
    PaletteRow{QPalette::Window, "#f1f3f5", "#26292d"},
    PaletteRow{QPalette::WindowText, "#1b1f24", "#e2e5e9"},
    PaletteRow{QPalette::Base, "#ffffff", "#1c1e21"},
    PaletteRow{QPalette::AlternateBase, "#f6f7f9", "#222529"},
    PaletteRow{QPalette::Text, "#1b1f24", "#e2e5e9"},
    // The values that are in effect where nothing is typed, and units.
    PaletteRow{QPalette::PlaceholderText, "#5c6570", "#9aa3ac"},
    PaletteRow{QPalette::Button, "#f7f8fa", "#303439"},
    PaletteRow{QPalette::ButtonText, "#1b1f24", "#e2e5e9"},
    PaletteRow{QPalette::BrightText, "#ffffff", "#ffffff"},
    PaletteRow{QPalette::ToolTipBase, "#ffffff", "#1c1e21"},
    PaletteRow{QPalette::ToolTipText, "#1b1f24", "#e2e5e9"},
    PaletteRow{QPalette::Highlight, "#0a66b0", "#2f7fc4"},
    PaletteRow{QPalette::HighlightedText, "#ffffff", "#ffffff"},
    PaletteRow{QPalette::Link, "#0a5a9c", "#6cb2ee"},
    PaletteRow{QPalette::LinkVisited, "#0a5a9c", "#6cb2ee"},
    PaletteRow{QPalette::Light, "#ffffff", "#454a50"},
    PaletteRow{QPalette::Dark, "#b9c0c7", "#15171a"}};

struct ColorRow {
    QColor Theme::*member;
    const char* light;
    const char* dark;
};

constexpr std::array color_rows{ColorRow{&Theme::plotBackground, "#ffffff", "#1c1e21"},
                                ColorRow{&Theme::panelBackground, "#ffffff", "#1c1e21"},
                                ColorRow{&Theme::axis, "#8a929b", "#737b84"},
                                ColorRow{&Theme::grid, "#e6e9ec", "#2b2f33"},
                                ColorRow{&Theme::zeroLine, "#c3c9cf", "#4b5157"},
                                ColorRow{&Theme::text, "#1b1f24", "#e2e5e9"},
                                ColorRow{&Theme::mutedText, "#5c6570", "#9aa3ac"},
                                ColorRow{&Theme::accent, "#0a66b0", "#4a9fe3"},
                                ColorRow{&Theme::tracker, "#4a535d", "#b4bcc5"},
                                ColorRow{&Theme::cursorA, "#b3261e", "#ff8a80"},
                                ColorRow{&Theme::cursorB, "#1a6d3c", "#7fd89f"},
                                ColorRow{&Theme::warning, "#c2410c", "#ff8f4d"},
                                ColorRow{&Theme::kept, "#1a6d3c", "#6fcf97"},
                                ColorRow{&Theme::broken, "#b3261e", "#ff8a80"},
                                ColorRow{&Theme::signalC, "#3b6ea5", "#7fb0e6"},
                                ColorRow{&Theme::signalD, "#8a6d3b", "#d3b06f"}};

Theme makeTheme(bool is_dark) {
    Theme theme;
    theme.dark = is_dark;
    QPalette& palette = theme.palette;
    for (const PaletteRow& row : palette_rows) {
        palette.setColor(row.role, QColor(is_dark ? row.dark : row.light));
    }
    const QColor button = palette.color(QPalette::Button);
    const QColor dark = palette.color(QPalette::Dark);
    palette.setColor(QPalette::Midlight, button.lighter(105));
    palette.setColor(QPalette::Mid, dark.lighter(115));
    palette.setColor(QPalette::Shadow, dark.darker(150));
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText,
          QPalette::PlaceholderText}) {
        palette.setColor(QPalette::Disabled, role, QColor(is_dark ? "#7d858e" : "#8b939c"));
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, dark);
    for (const ColorRow& row : color_rows) {
        theme.*row.member = QColor(is_dark ? row.dark : row.light);
    }
    return theme;
}

// Fusion with frames round check and radio buttons: its own are darker than the window, which a
// dark window leaves invisible.
class FramedStyle : public QProxyStyle {
public:
    FramedStyle() : QProxyStyle(QStringLiteral("fusion")) {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        const bool box = element == PE_IndicatorCheckBox;
        if ((box || element == PE_IndicatorRadioButton) && isDark(option->palette)) {
            painter->save();
            painter->setRenderHint(QPainter::Antialiasing, !box);
            painter->setPen(option->palette.color(QPalette::PlaceholderText));
            painter->setBrush(Qt::NoBrush);
            const QRect frame = option->rect.adjusted(0, 0, -1, -1);
            box ? painter->drawRect(frame) : painter->drawEllipse(frame);
            painter->restore();
        }
    }
};

// Relative luminance after WCAG 2.
double luminance(const QColor& color) {
    const auto linear = [](double channel) {
        return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
           0.0722 * linear(color.blueF());
}

QPixmap drawn(const QByteArray& svg, const QColor& color, int size) {
    QByteArray recolored = svg;
    recolored.replace("#000000", color.name().toLatin1());
    QSvgRenderer renderer(recolored);
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    renderer.render(&painter);
    return pixmap;
}

}  // namespace

Theme lightTheme() {
    return makeTheme(false);
}

Theme darkTheme() {
    return makeTheme(true);
}

bool isDark(const QPalette& palette) {
    return luminance(palette.color(QPalette::Window)) <
           luminance(palette.color(QPalette::WindowText));
}

Theme themeOf(const QPalette& palette) {
    return makeTheme(isDark(palette));
}

Theme applyTheme(QApplication& app, ThemeMode mode) {
    // Only for another style, because setting a style resets the palette to that of the style.
    if (!dynamic_cast<FramedStyle*>(QApplication::style())) {
        QApplication::setStyle(new FramedStyle);
    }
    bool dark = mode == ThemeMode::dark;
    if (mode == ThemeMode::system) {
        QApplication::setPalette(QPalette());  // an empty palette resolves to the desktop's
        dark = isDark(QApplication::palette());
    }
    const Theme theme = makeTheme(dark);
    app.setPalette(theme.palette);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::ApplicationPaletteChange);
    return theme;
}

CurveStyle curveStyle(int index) {
    // Four of Okabe and Ito, a violet and an olive: their orange and light blue look like vermilion
    // and like the second shade of blue once they are readable on both grounds.
    static constexpr std::array<const char*, curve_colors> colors{"#0072b2", "#d55e00", "#009e73",
                                                                  "#cc79a7", "#b9b2ff", "#636336"};
    const int place = index < 0 ? -1 - index : index;
    const int color = place % curve_colors;
    return {
        QColor(colors.at(static_cast<std::size_t>(index < 0 ? curve_colors - 1 - color : color))),
        place / curve_colors % curve_shades};
}

QColor readable(const QColor& color, const Theme& theme, int shade) {
    constexpr double step = 0.01;
    float hue = 0;
    float saturation = 0;
    float lightness = 0;
    color.getHslF(&hue, &saturation, &lightness);
    QColor shown = color;
    double l = lightness;
    const auto reach = [&](double enough) {
        for (; contrast(shown, theme.panelBackground) < enough && 0 <= l && l <= 1;
             l += theme.dark ? step : -step) {
            shown = QColor::fromHslF(hue, saturation, static_cast<float>(l));
        }
    };
    // Thin lines need more contrast on black than on white.
    reach(theme.dark ? 4.5 : 3.2);
    // Shades are equal steps of contrast, up to four fifths of the way to white or black.
    const double first = contrast(shown, theme.panelBackground);
    const double last = contrast(theme.dark ? Qt::white : Qt::black, theme.panelBackground);
    reach(first * std::pow(last / first, 0.8 * (shade % curve_shades) / (curve_shades - 1)));
    return shown;
}

QColor translucent(QColor color, double part) {
    color.setAlphaF(static_cast<float>(part));
    return color;
}

double contrast(const QColor& a, const QColor& b) {
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

QColor inkColor(Ink ink, int style, const Theme& theme, int shades) {
    // Those after Ink::style.
    static constexpr std::array colors{&Theme::text,    &Theme::mutedText, &Theme::signalC,
                                       &Theme::signalD, &Theme::accent,    &Theme::warning};
    if (ink == Ink::style) {
        const CurveStyle curve = curveStyle(style);
        return readable(curve.color, theme, curve.shade + shades);
    }
    return theme.*colors.at(static_cast<std::size_t>(ink) - 1);
}

QIcon themedIcon(const QString& name, const QPalette& palette) {
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    const QByteArray svg = file.readAll();
    QIcon icon;
    for (const int size : {16, 20, 24, 32, 48, 64}) {
        icon.addPixmap(drawn(svg, palette.color(QPalette::ButtonText), size));
        icon.addPixmap(drawn(svg, palette.color(QPalette::Disabled, QPalette::ButtonText), size),
                       QIcon::Disabled);
    }
    return icon;
}

}  // namespace vybeg::ui
