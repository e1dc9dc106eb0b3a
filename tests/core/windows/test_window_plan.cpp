#include "core/windows/window_plan.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <numbers>

namespace test_window_plan {

using namespace vybeg;

class TestWindowPlan : public QObject {
    Q_OBJECT

private slots:
    void residualIsTheAverageOfTheDoubledCarrier() {
        for (const double f : {4000.0, 5300.0, 7071.0678, 16000.0}) {
            for (const std::int64_t n : {5, 6, 22, 60, 601, 10000}) {
                long double sum = 0;
                for (std::int64_t j = 0; j < n; ++j) {
                    const long double u =
                        static_cast<long double>(j) - 0.5L * static_cast<long double>(n - 1);
                    sum += std::cos(4 * std::numbers::pi_v<long double> * f / 33333 * u);
                }
                const double expected =
                    static_cast<double>(std::abs(sum) / static_cast<long double>(n));
                VYBEG_CLOSE(orthogonality_residual(n, f, 33333), expected, 1e-13);
            }
        }
    }

    void residualsAreThoseOfTheMethod() {
        // METHOD section 3: f = 5300, fs = 33333: n = 6 leaves 5.7 %, n = 60 leaves 0.5 %.
        VYBEG_CLOSE(orthogonality_residual(6, 5300, 33333), 0.057, 1e-3);
        VYBEG_CLOSE(orthogonality_residual(60, 5300, 33333), 0.005, 5e-4);
    }

    void snapFindsTheWindowsOfTheMethod() {
        QCOMPARE(snap_window(22, 5300, 33333), 22);
        QCOMPARE(snap_window(24, 5300, 33333), 22);
        QCOMPARE(snap_window(44, 5300, 33333), 44);
        QCOMPARE(snap_window(60, 5300, 33333), 63);
    }

    void snapNeverMakesTheResidualWorseNorMovesFartherThanHalfAPeriod() {
        for (const double f : {4000.0, 4321.98, 5300.0, 8999.9}) {
            const double half_period = 33333 / (2 * f);
            for (std::int64_t n = least_window(f, 33333); n < 700; n += 7) {
                const std::int64_t snapped = snap_window(n, f, 33333);
                VYBEG_WITHIN(static_cast<double>(snapped - n), 0, half_period);
                VYBEG_AT_MOST(orthogonality_residual(snapped, f, 33333),
                              orthogonality_residual(n, f, 33333));
                VYBEG_AT_LEAST(snapped, least_window(f, 33333));
            }
        }
    }

    void leastWindowIsThatOfTheCarrierAndOfItsImage() {
        QCOMPARE(least_window(5300, 33333), 5);
        QCOMPARE(least_window(1000, 33333), 25);
        QCOMPARE(least_window(0.4914 * 33333, 33333), 88);
        for (const double share : {0.4003, 0.4507, 0.4811, 0.4914, 0.4991, 0.49997}) {
            const std::int64_t least = least_window(share * 48000, 48000);
            QCOMPARE(least, least_window((0.5 - share) * 48000, 48000));
            VYBEG_MORE(static_cast<double>(least), 1 / (2 * (0.5 - share)));
            VYBEG_AT_LEAST(snap_window(5, share * 48000, 48000), least);
        }
        VYBEG_MORE(least_window(24000, 48000), std::int64_t{1} << 40);
    }

    void planHoldsEveryWindowThatFits() {
        for (const std::int64_t frames : {5, 59, 60, 61, 119, 120, 1000}) {
            for (const std::int64_t length : {5, 60}) {
                for (const std::int64_t hop : {1, 7, 60, 200}) {
                    const WindowPlan plan = plan_windows(10, 10 + frames, length, hop);
                    if (plan.count == 0) {
                        VYBEG_LESS(frames, length);
                        continue;
                    }
                    QCOMPARE(plan.start(0), 10);
                    VYBEG_AT_MOST(plan.start(plan.count - 1) + length, 10 + frames);
                    VYBEG_MORE(plan.start(plan.count) + length, 10 + frames);
                }
            }
        }
        // Centre of the first window of 6: 2.5 samples after its first.
        QCOMPARE(plan_windows(0, 100, 6, 6).centre_s(1, 10), 0.85);
    }
};

VYBEG_TEST(TestWindowPlan)

}  // namespace test_window_plan

#include "test_window_plan.moc"
