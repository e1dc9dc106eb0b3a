#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "ui/widgets/theme.h"

#include <QApplication>
#include <QCheckBox>
#include <QRadioButton>
#include <QStyle>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace test_theme {

using namespace vybeg::ui;

namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

// Of linear light as full colour vision and the three kinds of dichromats see it (Machado, Oliveira
// and Fernandes 2009, severity 1).
constexpr Matrix full_vision{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr std::array<Matrix, 3> dichromats{{
    {{{0.152286, 1.052583, -0.204868},
      {0.114503, 0.786281, 0.099216},
      {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968},
      {0.280085, 0.672501, 0.047413},
      {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779},
      {-0.078411, 0.930809, 0.147602},
      {0.004733, 0.691367, 0.303900}}},
}};

Triple times(const Matrix& matrix, const Triple& x) {
    Triple y{};
    for (std::size_t k = 0; k < 3; ++k) {
        y[k] = std::inner_product(x.begin(), x.end(), matrix[k].begin(), 0.0);
    }
    return y;
}

// L*, a*, b* of a colour, sRGB with white D65, as a vision sees it.
Triple labOf(const QColor& color, const Matrix& vision) {
    Triple light{color.redF(), color.greenF(), color.blueF()};
    for (double& x : light) {
        x = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    }
    light = times(vision, light);
    for (double& x : light) {
        x = std::clamp(x, 0.0, 1.0);
    }
    Triple xyz = times({{{0.4124564, 0.3575761, 0.1804375},
                         {0.2126729, 0.7151522, 0.0721750},
                         {0.0193339, 0.1191920, 0.9503041}}},
                       light);
    const Triple white{0.95047, 1, 1.08883};
    for (std::size_t k = 0; k < 3; ++k) {
        const double t = xyz[k] / white[k];
        xyz[k] = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
    }
    return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

// CIEDE2000 (ISO/CIE 11664-6).
double distance(Triple p, Triple q) {
    constexpr double degree = std::numbers::pi / 180;
    const auto seventh = [](double chroma) {
        return std::sqrt(std::pow(chroma, 7) / (std::pow(chroma, 7) + std::pow(25.0, 7)));
    };
    const double g = 0.5 * (1 - seventh((std::hypot(p[1], p[2]) + std::hypot(q[1], q[2])) / 2));
    const auto hue = [&](Triple& lab) {
        lab[1] *= 1 + g;
        const double angle = std::atan2(lab[2], lab[1]) / degree;
        return angle < 0 ? angle + 360 : angle;
    };
    const double hp = hue(p);
    const double hq = hue(q);
    const double cp = std::hypot(p[1], p[2]);
    const double cq = std::hypot(q[1], q[2]);
    const double turn = cp * cq == 0 ? 0 : std::remainder(hq - hp, 360);
    const double h = hp + turn / 2;
    const double c = (cp + cq) / 2;
    const double l = (p[0] + q[0]) / 2 - 50;
    const auto cosine = [&](double times_h, double offset) {
        return std::cos((times_h * h + offset) * degree);
    };
    const double t = 1 - 0.17 * cosine(1, -30) + 0.24 * cosine(2, 0) + 0.32 * cosine(3, 6) -
                     0.20 * cosine(4, -63);
    const double lightness = (q[0] - p[0]) / (1 + 0.015 * l * l / std::sqrt(20 + l * l));
    const double chroma = (cq - cp) / (1 + 0.045 * c);
    const double hues = 2 * std::sqrt(cp * cq) * std::sin(turn / 2 * degree) / (1 + 0.015 * c * t);
    const double apart = std::remainder(h - 275, 360) / 25;
    const double rotation = -2 * seventh(c) * std::sin(60 * std::exp(-apart * apart) * degree);
    return std::sqrt(lightness * lightness + chroma * chroma + hues * hues +
                     rotation * chroma * hues);
}

}  // namespace

class TestTheme : public QObject {
    Q_OBJECT

private slots:
    void black_on_white_has_the_greatest_contrast() {
        VYBEG_CLOSE(contrast(Qt::black, Qt::white), 21, 1e-6);
        VYBEG_CLOSE(contrast(Qt::red, Qt::red), 1, 1e-12);
        // Worked example of WCAG 2: #777777 on white is 4.48.
        VYBEG_CLOSE(contrast(QColor("#777777"), Qt::white), 4.48, 0.005);
    }

    void text_is_readable_in_both_themes() {
        for (const Theme& theme : {lightTheme(), darkTheme()}) {
            VYBEG_AT_LEAST(contrast(theme.text, theme.plotBackground), 7);
            VYBEG_AT_LEAST(contrast(theme.mutedText, theme.plotBackground), 4.5);
            VYBEG_AT_LEAST(contrast(theme.cursorA, theme.panelBackground), 4.5);
            VYBEG_AT_LEAST(contrast(theme.cursorB, theme.panelBackground), 4.5);
            VYBEG_AT_LEAST(contrast(theme.warning, theme.panelBackground), 3);
            const QPalette& p = theme.palette;
            VYBEG_AT_LEAST(contrast(p.color(QPalette::Text), p.color(QPalette::Base)), 7);
            // The carrier that was found, the range, assumed tolerances.
            VYBEG_AT_LEAST(contrast(p.color(QPalette::PlaceholderText), p.color(QPalette::Base)),
                           4.5);
            VYBEG_AT_LEAST(contrast(p.color(QPalette::ButtonText), p.color(QPalette::Button)), 7);
            VYBEG_AT_LEAST(
                contrast(p.color(QPalette::HighlightedText), p.color(QPalette::Highlight)), 4);
        }
    }

    void run_colours_are_readable_in_both_themes() {
        for (const Theme& theme : {lightTheme(), darkTheme()}) {
            for (int i = 0; i < 30; ++i) {
                const QColor shown = readable(curveStyle(i).color, theme);
                VYBEG_AT_LEAST(contrast(shown, theme.panelBackground), (theme.dark ? 4.5 : 3.2),
                               qPrintable(shown.name()));
                // The hue, which tells runs apart, is kept (rounding of 8-bit colours: 2 degrees).
                const int turn = std::abs(shown.hslHue() - curveStyle(i).color.hslHue());
                VYBEG_AT_MOST(std::min(turn, 360 - turn), 2);
            }
        }
    }

    void thirty_runs_have_thirty_styles() {
        for (int i = 0; i < 30; ++i) {
            for (int k = 0; k < i; ++k) {
                QVERIFY(curveStyle(i).color != curveStyle(k).color ||
                        curveStyle(i).shade != curveStyle(k).shade);
            }
        }
    }

    void the_distance_of_colours_is_that_of_the_standard() {
        // Of the pairs that G. Sharma, W. Wu and E. N. Dalal published (2005).
        VYBEG_CLOSE(distance({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 1e-4);
        VYBEG_CLOSE(distance({50, 2.5, 0}, {73, 25, -18}), 27.1492, 1e-4);
        VYBEG_CLOSE(distance({2.0776, 0.0795, -1.135}, {0.9033, -0.0636, -0.5514}), 0.9082, 1e-4);
    }

    // Of twelve recordings, those of one hue apart: shades of it. Six for dichromats.
    void recordings_are_told_apart_in_both_themes() {
        for (const Theme& theme : {lightTheme(), darkTheme()}) {
            const auto seen = [&theme](int k, const Matrix& vision) {
                return labOf(readable(curveStyle(k).color, theme, curveStyle(k).shade), vision);
            };
            for (int k = 0; k < 2 * curve_colors; ++k) {
                for (int other = 0; other < k; ++other) {
                    const QString where = QString("%1, %2").arg(other + 1).arg(k + 1);
                    if (k - other != curve_colors) {
                        VYBEG_AT_LEAST(distance(seen(k, full_vision), seen(other, full_vision)), 18,
                                       qPrintable(where));
                    }
                    for (const Matrix& vision : dichromats) {
                        if (k < curve_colors) {
                            VYBEG_AT_LEAST(distance(seen(k, vision), seen(other, vision)), 8,
                                           qPrintable(where));
                        }
                    }
                }
            }
        }
    }

    void shades_of_a_colour_are_told_apart_and_readable() {
        for (const Theme& theme : {lightTheme(), darkTheme()}) {
            for (int i = 0; i < curve_colors; ++i) {
                double before =
                    contrast(readable(curveStyle(i).color, theme), theme.panelBackground);
                for (int shade = 1; shade < curve_shades; ++shade) {
                    const QColor shown = readable(curveStyle(i).color, theme, shade);
                    const double now = contrast(shown, theme.panelBackground);
                    VYBEG_AT_LEAST(now, 1.09 * before, qPrintable(shown.name()));
                    before = now;
                }
            }
        }
    }

    // Their frames, against the window around them.
    void unchecked_boxes_are_seen_in_both_themes() {
        for (const ThemeMode mode : {ThemeMode::light, ThemeMode::dark}) {
            applyTheme(*qApp, mode);
            for (QAbstractButton* const button :
                 std::initializer_list<QAbstractButton*>{new QCheckBox, new QRadioButton}) {
                const QImage image = button->grab().toImage();
                const QColor around = button->palette().color(QPalette::Window);
                double greatest = 1;
                for (int x = 0; x < image.width(); ++x) {
                    for (int y = 0; y < image.height(); ++y) {
                        if (!(image.pixelColor(x, y) == button->palette().color(QPalette::Base))) {
                            greatest = std::max(greatest, contrast(image.pixelColor(x, y), around));
                        }
                    }
                }
                VYBEG_AT_LEAST(greatest, (mode == ThemeMode::dark ? 3 : 1.5));
                delete button;
            }
        }
        applyTheme(*qApp, ThemeMode::light);
    }

    void a_mode_gives_its_palette() {
        const Theme dark = applyTheme(*qApp, ThemeMode::dark);
        QVERIFY(dark.dark);
        QVERIFY(isDark(QApplication::palette()));
        const Theme light = applyTheme(*qApp, ThemeMode::light);
        QVERIFY(!light.dark);
        QVERIFY(!isDark(QApplication::palette()));
        const QStyle* before = QApplication::style();
        applyTheme(*qApp, ThemeMode::dark);
        QCOMPARE(QApplication::style(), before);
    }

    void the_systems_own_palette_decides_after_another_mode() {
        QApplication::setPalette(QPalette());
        const bool system = isDark(QApplication::palette());
        applyTheme(*qApp, system ? ThemeMode::light : ThemeMode::dark);
        QCOMPARE(applyTheme(*qApp, ThemeMode::system).dark, system);
    }
};

VYBEG_TEST(TestTheme)

}  // namespace test_theme

#include "test_theme.moc"
