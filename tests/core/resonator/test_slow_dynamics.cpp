#include "core/resonator/model/slow_dynamics.h"
#include "core/simulation/decay_motion.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>
#include <numbers>
#include <random>

namespace test_slow_dynamics {

using namespace vybeg;
using std::numbers::pi;

namespace {

using Matrix = Eigen::Matrix2cd;

// Rates at random; `scale` is that of the motion, 1/s. At 0 the modes coincide.
SlowRates random_rates(std::mt19937_64& random, double scale) {
    std::uniform_real_distribution<double> any(-scale, scale);
    SlowRates rates;
    for (double& rate : rates) {
        rate = any(random);
    }
    rates[decay_at] = std::abs(rates[decay_at]);
    return rates;
}

}  // namespace

class TestSlowDynamics : public QObject {
    Q_OBJECT

private slots:
    void thePropagatorIsThatOfTheSimulator() {
        const FreeDecay decay{.split_hz = 0.3,
                              .theta_w = 0.2,
                              .tau_s = 40,
                              .damping_anisotropy_per_s = 0.01,
                              .theta_tau = -0.5,
                              .omega_rad_s = 0.4};
        const SlowDynamics ours(SlowRates{0.3 * std::cos(0.8), 0.3 * std::sin(0.8),
                                          0.01 * std::cos(-2.0), 0.01 * std::sin(-2.0),
                                          2 * 0.277 * 0.4, 0, 1.0 / 40});
        const SlowMotion theirs(decay);
        for (const double t : {0.0, 1e-3, 0.9, 1.1, 28.0, 500.0}) {
            const double error = (ours.propagator(t) - theirs.propagator(t)).norm();
            VYBEG_LESS(error, 1e-13 * (1 + t));
        }
    }

    void theDerivativesAreCentralDifferences_data() {
        QTest::addColumn<double>("scale");
        for (const double scale : {0.0, 1e-6, 1e-3, 0.03, 0.3, 3.0}) {
            QTest::newRow(qPrintable(QString::number(scale))) << scale;
        }
    }

    void theDerivativesAreCentralDifferences() {
        QFETCH(double, scale);
        std::mt19937_64 random(7);
        for (int trial = 0; trial < 20; ++trial) {
            const SlowRates rates = random_rates(random, scale);
            for (const double t : {0.0, 0.02, 1.0, 28.0}) {
                const auto at = SlowDynamics(rates).propagation(t);
                for (int k = 0; k < rate_count; ++k) {
                    // The step keeps the turn it causes at 1e-4 rad: its cube and the rounding of
                    // the difference both stay below 1e-8 of t.
                    const double step = 1e-5 / std::max(t, 1.0);
                    SlowRates up = rates;
                    SlowRates down = rates;
                    up[k] += step;
                    down[k] -= step;
                    const Matrix difference =
                        (SlowDynamics(up).propagator(t) - SlowDynamics(down).propagator(t)) /
                        (2 * step);
                    const double error =
                        (difference - at.by_rate[static_cast<std::size_t>(k)]).norm();
                    // Relative to t times the larger of exp(M t) and the start's size.
                    const double size = std::max(t, 1.0) * std::max(at.value.norm(), 1.0);
                    VYBEG_LESS(error, 1e-7 * size);
                }
            }
        }
    }

    void seriesAndExponentialsMeet() {
        // |s t| passes 1, where the formula changes, at t = 1/(2 pi): no step in value or
        // derivative.
        const SlowDynamics motion(SlowRates{1.2, -1.6, 0, 0, 0, 0, 0.3});
        const double t = 1 / (2 * pi);
        const auto below = motion.propagation(t * (1 - 1e-9));
        const auto above = motion.propagation(t * (1 + 1e-9));
        VYBEG_LESS((below.value - above.value).norm(), 1e-8);
        for (std::size_t k = 0; k < rate_count; ++k) {
            VYBEG_LESS((below.by_rate[k] - above.by_rate[k]).norm(), 1e-8);
        }
    }

    void theMeanOverAWindowIsAnIntegral() {
        const SlowDynamics motion(SlowRates{3, 4, 0.3, 0, 1, 0.5, 1.2});
        const double offset = 0.7;
        const double length = 0.15;
        // Simpson's rule over 200 parts: its error is (|M| length/200)^4.
        Matrix sum = Matrix::Zero();
        for (int k = 0; k <= 200; ++k) {
            const double u = (k / 200.0 - 0.5) * length;
            const double weight = (k == 0 || k == 200 ? 1 : k % 2 == 1 ? 4 : 2) / 600.0;
            sum += weight * std::polar(1.0, 2 * pi * offset * u) * motion.propagator(u);
        }
        VYBEG_LESS((motion.window_mean(length, offset) - sum).norm(), 1e-8);
    }

    void ratesAndMatrixAreTheSame() {
        std::mt19937_64 random(3);
        const SlowRates rates = random_rates(random, 1);
        const SlowRates back = rates_of(SlowDynamics(rates).matrix());
        for (int k = 0; k < rate_count; ++k) {
            VYBEG_CLOSE(rates[k], back[k], 1e-14);
        }
    }

    void theEigenvaluesAreThoseOfTheMatrix() {
        std::mt19937_64 random(5);
        for (int trial = 0; trial < 10; ++trial) {
            const SlowRates rates = random_rates(random, 2);
            const SlowDynamics motion(rates);
            for (const double sign : {1.0, -1.0}) {
                const std::complex<double> eigenvalue =
                    sign * motion.half_difference() - rates[decay_at];
                const Matrix rest = motion.matrix() - eigenvalue * Matrix::Identity();
                VYBEG_CLOSE(rest(0, 0) * rest(1, 1), rest(0, 1) * rest(1, 0), 1e-12);
            }
        }
    }

    void theLogarithmGivesTheRatesBack() {
        std::mt19937_64 random(7);
        for (const double scale : {0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 0.4}) {
            for (int trial = 0; trial < 20; ++trial) {
                const SlowDynamics motion(random_rates(random, scale));
                const double seconds = 1.3;
                const Matrix found = logarithm(motion.propagator(seconds)) / seconds;
                VYBEG_LESS((found - motion.matrix()).norm(), 1e-14 + 1e-10 * scale);
            }
        }
        // Two modes that coincide in a single shape.
        Matrix jordan;
        jordan << 0.5, 2, 0, 0.5;
        Matrix expected;
        expected << std::log(0.5), 4, 0, std::log(0.5);
        VYBEG_LESS((logarithm(jordan) - expected).norm(), 1e-14);
    }

    void aLongRecordDoesNotOverflow() {
        const SlowDynamics motion(SlowRates{0, 0, 1.9, 0, 0, 0, 1});
        // Modes of decay 0.05 and 1.95 1/s: cosh(0.95 * 1000) by itself is infinite.
        const Matrix late = motion.propagator(1000);
        VYBEG_CLOSE(late(1, 1), std::exp(-50.0), 1e-12 * std::exp(-50.0));
        VYBEG_CLOSE(late(0, 0), 0, 1e-100);
    }
};

VYBEG_TEST(TestSlowDynamics)

}  // namespace test_slow_dynamics

#include "test_slow_dynamics.moc"
