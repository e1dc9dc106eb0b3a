#include "core/numerics/kaiser.h"
#include "tests/closeness.h"
#include "tests/largest_of.h"
#include "tests/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace test_kaiser {

namespace {

// I0 by its power series, sum of ((x/2)^k / k!)^2.
double bessel_i0(double x) {
    double term = 1;
    double sum = 1;
    for (int k = 1; k < 200; ++k) {
        term *= x / (2 * k);
        sum += term * term;
    }
    return sum;
}

// Response of the symmetric filter with the half `taps` at a frequency in cycles per sample.
double response(const std::vector<double>& taps, double frequency) {
    double sum = taps[0];
    for (std::size_t m = 1; m < taps.size(); ++m) {
        sum += 2 * taps[m] * std::cos(2 * std::numbers::pi * frequency * static_cast<double>(m));
    }
    return sum;
}

}  // namespace

class TestKaiser : public QObject {
    Q_OBJECT

private slots:
    void the_window_is_the_ratio_of_bessel_functions() {
        for (const double beta : {0.0, 1.0, 8.6, 13.2}) {
            for (const double x : {-1.0, -0.6, 0.0, 0.25, 0.9, 1.0}) {
                const double expected = bessel_i0(beta * std::sqrt(1 - x * x)) / bessel_i0(beta);
                VYBEG_CLOSE_RATIO(vybeg::kaiser_window(x, beta), expected, 1e-13);
            }
            QCOMPARE(vybeg::kaiser_window(1.0001, beta), 0.0);
            QCOMPARE(vybeg::kaiser_window(-1.0001, beta), 0.0);
        }
    }

    void sinc_is_one_at_zero_and_vanishes_at_whole_numbers() {
        QCOMPARE(vybeg::sinc(0), 1.0);
        QCOMPARE(vybeg::sinc(0.5), 2 / std::numbers::pi);
        for (int k = 1; k < 10; ++k) {
            VYBEG_CLOSE(vybeg::sinc(k), 0, 1e-16);
            VYBEG_CLOSE(vybeg::sinc(-k), 0, 1e-16);
        }
    }

    void a_band_pass_keeps_its_ripple_on_both_sides_of_the_transitions_data() {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<double>("transition");
        QTest::newRow("narrow") << 0.158 << 0.161 << 0.0015;
        QTest::newRow("wide") << 0.1 << 0.4 << 0.1;
        QTest::newRow("low edge near zero") << 0.002 << 0.3 << 0.002;
        QTest::newRow("high edge near half the rate") << 0.2 << 0.495 << 0.005;
        QTest::newRow("short filter") << 0.2 << 0.3 << 0.15;
    }

    void a_band_pass_keeps_its_ripple_on_both_sides_of_the_transitions() {
        QFETCH(double, low);
        QFETCH(double, high);
        QFETCH(double, transition);
        const double attenuation_db = 80;
        const std::vector<double> taps =
            vybeg::band_pass_taps(low - transition / 2, high + transition / 2,
                                  vybeg::kaiser_design(attenuation_db, transition));
        // Both low-passes contribute 1e-4 at most.
        const double ripple = 2e-4;
        double pass = 0;
        double stop = 0;
        const int points = 8 * static_cast<int>(taps.size());
        for (int i = 0; i <= points; ++i) {
            const double f = 0.5 * i / points;
            if (f >= low && f <= high) {
                pass = vybeg::test::largest_of({pass, std::abs(response(taps, f) - 1)});
            } else if (f <= low - transition || f >= high + transition) {
                stop = vybeg::test::largest_of({stop, std::abs(response(taps, f))});
            }
        }
        VYBEG_LESS(pass, ripple);
        VYBEG_LESS(stop, ripple);
        // And it is no longer than it must be: the design comes near to its ripple.
        VYBEG_MORE(std::max(pass, stop), ripple / 8);
    }

    void the_length_goes_as_one_over_the_transition_and_never_overflows() {
        const auto length = [](double transition) {
            return vybeg::kaiser_design(80, transition).half_length;
        };
        QCOMPARE(length(0.05), 51);  // 72.05 / (4.57 pi 0.05) = 100.4 for both halves
        VYBEG_CLOSE_RATIO(static_cast<double>(length(0.0005)), 5018, 1e-3);
        QCOMPARE(length(1e-300), std::int64_t{1} << 53);
    }
};

VYBEG_TEST(TestKaiser)

}  // namespace test_kaiser

#include "test_kaiser.moc"
