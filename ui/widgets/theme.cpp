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

struct WidgetColors {
    const char* window;
    const char* base;
    const char* alternate;
    const char* button;
    const char* text;
    const char* disabled;
    const char* placeholder;  // the values that are in effect where nothing is typed, and units
    const char* highlight;
    const char* highlightedText;
    const char* link;
    const char* light;
    const char* dark;
};

QPalette makePalette(const WidgetColors& colors) {
    QPalette palette;
    palette.setColor(QPalette::Window, QColor(colors.window));
    palette.setColor(QPalette::WindowText, QColor(colors.text));
    palette.setColor(QPalette::Base, QColor(colors.base));
    palette.setColor(QPalette::AlternateBase, QColor(colors.alternate));
    palette.setColor(QPalette::Text, QColor(colors.text));
    palette.setColor(QPalette::PlaceholderText, QColor(colors.placeholder));
    palette.setColor(QPalette::Button, QColor(colors.button));
    palette.setColor(QPalette::ButtonText, QColor(colors.text));
    palette.setColor(QPalette::BrightText, QColor("#ffffff"));
    palette.setColor(QPalette::ToolTipBase, QColor(colors.base));
    palette.setColor(QPalette::ToolTipText, QColor(colors.text));
    palette.setColor(QPalette::Highlight, QColor(colors.highlight));
    palette.setColor(QPalette::HighlightedText, QColor(colors.highlightedText));
    palette.setColor(QPalette::Link, QColor(colors.link));
    palette.setColor(QPalette::LinkVisited, QColor(colors.link));
    palette.setColor(QPalette::Light, QColor(colors.light));
    palette.setColor(QPalette::Midlight, QColor(colors.button).lighter(105));
    palette.setColor(QPalette::Mid, QColor(colors.dark).lighter(115));
    palette.setColor(QPalette::Dark, QColor(colors.dark));
    palette.setColor(QPalette::Shadow, QColor(colors.dark).darker(150));
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText,
          QPalette::PlaceholderText}) {
        palette.setColor(QPalette::Disabled, role, QColor(colors.disabled));
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(colors.dark));
    return palette;
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
    Theme theme;
    theme.palette = makePalette({"#f1f3f5", "#ffffff", "#f6f7f9", "#f7f8fa", "#1b1f24", "#8b939c",
                                 "#5c6570", "#0a66b0", "#ffffff", "#0a5a9c", "#ffffff", "#b9c0c7"});
    theme.plotBackground = QColor("#ffffff");
    theme.panelBackground = QColor("#ffffff");
    theme.axis = QColor("#8a929b");
    theme.grid = QColor("#e6e9ec");
    theme.zeroLine = QColor("#c3c9cf");
    theme.text = QColor("#1b1f24");
    theme.mutedText = QColor("#5c6570");
    theme.accent = QColor("#0a66b0");
    theme.tracker = QColor("#4a535d");
    theme.cursorA = QColor("#b3261e");
    theme.cursorB = QColor("#1a6d3c");
    theme.warning = QColor("#c2410c");
    theme.kept = QColor("#1a6d3c");
    theme.broken = QColor("#b3261e");
    theme.signalC = QColor("#3b6ea5");
    theme.signalD = QColor("#8a6d3b");
    return theme;
}

Theme darkTheme() {
    Theme theme;
    theme.dark = true;
    theme.palette = makePalette({"#26292d", "#1c1e21", "#222529", "#303439", "#e2e5e9", "#7d858e",
                                 "#9aa3ac", "#2f7fc4", "#ffffff", "#6cb2ee", "#454a50", "#15171a"});
    theme.plotBackground = QColor("#1c1e21");
    theme.panelBackground = QColor("#1c1e21");
    theme.axis = QColor("#737b84");
    theme.grid = QColor("#2b2f33");
    theme.zeroLine = QColor("#4b5157");
    theme.text = QColor("#e2e5e9");
    theme.mutedText = QColor("#9aa3ac");
    theme.accent = QColor("#4a9fe3");
    theme.tracker = QColor("#b4bcc5");
    theme.cursorA = QColor("#ff8a80");
    theme.cursorB = QColor("#7fd89f");
    theme.warning = QColor("#ff8f4d");
    theme.kept = QColor("#6fcf97");
    theme.broken = QColor("#ff8a80");
    theme.signalC = QColor("#7fb0e6");
    theme.signalD = QColor("#d3b06f");
    return theme;
}

bool isDark(const QPalette& palette) {
    return luminance(palette.color(QPalette::Window)) <
           luminance(palette.color(QPalette::WindowText));
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
    const Theme theme = dark ? darkTheme() : lightTheme();
    app.setPalette(theme.palette);
    return theme;
}

CurveStyle curveStyle(int index) {
    // Okabe and Ito, without black (no good on dark) and yellow (no good on light), in an order
    // that separates neighbours for every kind of colour blindness.
    static constexpr std::array<const char*, curve_colors> colors{"#0072b2", "#d55e00", "#009e73",
                                                                  "#cc79a7", "#e69f00", "#56b4e9"};
    return {QColor(colors[static_cast<std::size_t>(index % curve_colors)]),
            index / curve_colors % curve_shades};
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

double contrast(const QColor& a, const QColor& b) {
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

QColor inkColor(Ink ink, int style, const Theme& theme, int shades) {
    switch (ink) {
        case Ink::style: {
            const CurveStyle curve = curveStyle(style);
            return readable(curve.color, theme, curve.shade + shades);
        }
        case Ink::text: return theme.text;
        case Ink::muted: return theme.mutedText;
        case Ink::channel_c: return theme.signalC;
        case Ink::channel_d: return theme.signalD;
        case Ink::accent: return theme.accent;
        case Ink::warning: return theme.warning;
    }
    return {};
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
