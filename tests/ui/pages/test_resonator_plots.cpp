// Figures of an identification as values.
#include "tests/test_registry.h"
#include "ui/charts/round_plot.h"
#include "ui/plots/plot_file.h"
#include "ui/resonator/resonator_plots.h"

#include <QChartView>
#include <QGraphicsTextItem>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

namespace test_resonator_plots {

using namespace vybeg;
using namespace vybeg::ui;

class TestResonatorPlots : public QObject {
    Q_OBJECT

    static std::vector<double> electrodesOf(const RoundPlot& plot, const QString& name) {
        const auto found = std::ranges::find(plot.series, name, &RoundSeries::name);
        std::vector<double> angles = found == plot.series.end() ? std::vector<double>() : found->x;
        std::ranges::sort(angles);
        return angles;
    }

    static QString svgOf(const RoundPlot& plot) {
        const QTemporaryDir folder;
        QFile file(folder.filePath("plot.svg"));
        if (!writeDrawing(roundDrawing(plot), {round_paper_size}, file.fileName()) ||
            !file.open(QIODevice::ReadOnly)) {
            return {};
        }
        return QString::fromUtf8(file.readAll());
    }

private slots:
    // An angle of the wave is less by the angle zero, and so is that of the first electrode.
    void electrodes_stand_where_the_angle_zero_puts_them() {
        using Angles = std::vector<double>;
        for (const auto& [zero, c, d] :
             {std::tuple{0., Angles{0, 90, 180, 270}, Angles{45, 135, 225, 315}},
              std::tuple{10., Angles{80, 170, 260, 350}, Angles{35, 125, 215, 305}},
              std::tuple{-100., Angles{10, 100, 190, 280}, Angles{55, 145, 235, 325}}}) {
            SetResult outcome;
            outcome.identification.fit.model = ResonatorModel::structured;
            outcome.identification.settings.signal.calibration.angle_zero_deg = zero;
            const RoundPlot plot = rimPlot(outcome);
            QCOMPARE(electrodesOf(plot, "C"), c);
            QCOMPARE(electrodesOf(plot, "D"), d);
        }
    }

    // A legend has as many lines as its names need.
    void a_figure_names_each_recording_in_full() {
        RoundPlot plot;
        QStringList names;
        for (int run = 0; run < 8; ++run) {
            names << QStringLiteral("HRG-17_%1_after_three_hours_at_room_temperature").arg(run);
            plot.series.push_back(
                {.name = names.back(), .color = Qt::blue, .x = {0, 90}, .y = {1, 1}});
        }
        const QString svg = svgOf(plot);
        for (const QString& name : names) {
            QVERIFY2(svg.contains(name), qPrintable(name));
        }
        QVERIFY(!svg.contains(QChar(0x2026)));
    }

    void numbers_at_the_axes_have_a_true_minus() {
        RoundPlot square;
        square.polar = false;
        square.reach = 1.2;
        square.series.push_back({.name = {}, .color = Qt::blue, .x = {-1, 1}, .y = {-1, 1}});
        const QString svg = svgOf(square);
        for (const char* number : {">−1.2<", ">−0.6<", ">0.0<", ">0.6<", ">1.2<"}) {
            QVERIFY2(QString(svg)
                         .remove(QRegularExpression("\\s+(?=<)|(?<=>)\\s+"))
                         .contains(QString::fromUtf8(number)),
                     number);
        }
        RoundPlot polar = square;
        polar.polar = true;
        polar.reach = 0.016;
        const QString radii = svgOf(polar);
        QVERIFY(radii.contains("0.008") && radii.contains("0.016") && radii.contains("315°"));
    }

    // Qt leaves no room for angles at the sides of the circle, and too little for numbers.
    void no_number_at_an_axis_is_cut() {
        RoundPlot plot;
        plot.reach = 0.6;
        plot.series.push_back({.name = {}, .color = Qt::blue, .x = {0, 1}, .y = {0.1, 0.2}});
        for (const QSize size : {QSize(484, 560), QSize(260, 260), QSize(600, 300)}) {
            for (const auto& [polar, numbers] :
                 {std::pair{true, QStringList{"0°", "90°", "180°", "270°"}},
                  std::pair{false, QStringList{"−0.60", "0.00", "0.60"}}}) {
                plot.polar = polar;
                RoundView view(polar);
                view.resize(size);
                view.setContent(plot);
                view.show();
                QCoreApplication::processEvents();
                const auto& chart = *view.findChild<QChartView*>();
                QStringList shown;
                for (const QGraphicsItem* item : chart.scene()->items()) {
                    const auto* text = qgraphicsitem_cast<const QGraphicsTextItem*>(item);
                    if (text && text->isVisible() && !text->toPlainText().isEmpty()) {
                        shown << text->toPlainText();
                        QVERIFY2(chart.sceneRect().contains(text->sceneBoundingRect()),
                                 qPrintable(shown.last()));
                    }
                }
                for (const QString& number : numbers) {
                    QVERIFY2(shown.contains(number), qPrintable(shown.join(' ')));
                }
            }
        }
    }

    // Colours are those of recordings.
    void the_axes_of_the_rim_have_no_colour() {
        SetResult outcome;
        ResonatorFit& fit = outcome.identification.fit;
        fit.model = ResonatorModel::structured;
        fit.resonator.theta_w_rad = fit.resonator.theta_tau_rad = {0.2, 0.01, {}};
        int axes = 0;
        for (const RoundSeries& series : rimPlot(outcome).series) {
            if (series.name.startsWith(QStringLiteral("θ"))) {
                QVERIFY(series.ink == Ink::text || series.ink == Ink::muted);
                ++axes;
            }
        }
        QCOMPARE(axes, 2);
        const QString legend = legendOf(rimPlot(outcome), lightTheme());
        QVERIFY2(legend.contains("θ<sub>w</sub>") && legend.contains("θ<sub>τ</sub>"),
                 qPrintable(legend));
    }
};

VYBEG_TEST(TestResonatorPlots)

}  // namespace test_resonator_plots

#include "test_resonator_plots.moc"
