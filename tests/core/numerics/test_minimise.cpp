#include "core/numerics/minimise.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

namespace test_minimise {

using namespace vybeg;

class TestMinimise : public QObject {
    Q_OBJECT

private slots:
    void findsTheMinimumFromEitherSide() {
        // A skew valley with its minimum at 1.25.
        const auto f = [](double x) { return std::cosh(x - 1.25) + 0.2 * std::pow(x - 1.25, 4); };
        for (double start = -5; start <= 5; start += 0.37) {
            for (const double step : {1e-3, 0.1, 2.0}) {
                const Minimum found = minimise(f, -6, start, 6, step, 1e-9);
                QVERIFY(!found.at_bound);
                // A minimum of height 1 is known to the root of the rounding.
                VYBEG_CLOSE(found.at, 1.25, 5e-8);
            }
        }
    }

    void takesFewEvaluationsOnAParabola() {
        int calls = 0;
        const auto f = [&calls](double x) {
            ++calls;
            return (x - 0.3) * (x - 0.3);
        };
        VYBEG_CLOSE(minimise(f, -1, 0.2, 1, 0.05, 1e-9).at, 0.3, 1e-8);
        VYBEG_AT_MOST(calls, 15);
    }

    void tellsWhenTheFunctionFallsToTheBound() {
        const auto rising = [](double x) { return x; };
        const Minimum low = minimise(rising, -1, 0.5, 2, 0.1, 1e-9);
        QVERIFY(low.at_bound);
        QCOMPARE(low.at, -1.0);
        const auto falling = [](double x) { return -x; };
        const Minimum high = minimise(falling, -1, 2, 2, 0.1, 1e-9);
        QVERIFY(high.at_bound);
        QCOMPARE(high.at, 2.0);
    }
};

VYBEG_TEST(TestMinimise)

}  // namespace test_minimise

#include "test_minimise.moc"
