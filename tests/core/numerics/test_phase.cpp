#include "core/numerics/phase.h"
#include "core/numerics/statistics.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <numbers>

namespace test_phase {

using namespace vybeg;

class TestPhase : public QObject {
    Q_OBJECT

private slots:
    void wrapsIntoTheHalfOpenTurn() {
        constexpr double pi = std::numbers::pi;
        QCOMPARE(wrap(pi), pi);
        QCOMPARE(wrap(-pi), pi);
        QVERIFY(std::isnan(wrap(std::nan(""))));
        for (int turns = -1000; turns <= 1000; turns += 77) {
            for (const double angle : {-3.0, -1e-9, 0.0, 2.5}) {
                VYBEG_CLOSE(wrap(angle + turns * 2 * pi), angle, 1e-12);
            }
        }
    }

    void followsTheNearestBranch() {
        QCOMPARE(nearest_branch(0.1, 10.0, 2.5), 10.1);
        QCOMPARE(nearest_branch(0.1, -4.8, 2.5), -4.9);
        QCOMPARE(nearest_branch(7.0, 6.5, 2.0), 7.0);
    }

    void lineThroughPointsLeavesOutWhatIsMissing() {
        const double nan = std::nan("");
        const std::array x{0.0, 1.0, nan, 3.0, 4.0};
        const std::array y{1.0, 3.0, 5.0, 7.0, nan};
        const LineFit line = fit_line(x, y);
        QCOMPARE(line.slope, 2.0);
        QCOMPARE(line.mean_y - line.slope * line.mean_x, 1.0);
    }
};

VYBEG_TEST(TestPhase)

}  // namespace test_phase

#include "test_phase.moc"
