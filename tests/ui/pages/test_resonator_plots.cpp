// Figures of an identification as values.
#include "tests/test_registry.h"
#include "ui/resonator/resonator_plots.h"

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

private slots:
    // An angle of the wave is less by the angle zero, and so is that of the first electrode.
    void electrodes_stand_where_the_angle_zero_puts_them() {
        using Angles = std::vector<double>;
        for (const auto& [zero, c, d] :
             {std::tuple{0., Angles{0, 90, 180, 270}, Angles{45, 135, 225, 315}},
              std::tuple{10., Angles{80, 170, 260, 350}, Angles{35, 125, 215, 305}},
              std::tuple{-100., Angles{10, 100, 190, 280}, Angles{55, 145, 235, 325}}}) {
            ResonatorOutcome outcome;
            outcome.identification.fit.model = ResonatorModel::structured;
            outcome.identification.settings.signal.calibration.angle_zero_deg = zero;
            const RoundPlot plot = rimPlot(outcome);
            QCOMPARE(electrodesOf(plot, "C"), c);
            QCOMPARE(electrodesOf(plot, "D"), d);
        }
    }
};

VYBEG_TEST(TestResonatorPlots)

}  // namespace test_resonator_plots

#include "test_resonator_plots.moc"
