#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "ui/widgets/theme.h"

#include <QApplication>
#include <QCheckBox>
#include <QRadioButton>
#include <QStyle>
#include <QtTest>

namespace test_theme {

using namespace vybeg::ui;

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
