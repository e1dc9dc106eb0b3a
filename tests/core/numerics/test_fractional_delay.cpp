#include "core/numerics/fractional_delay.h"
#include "tests/closeness.h"
#include "tests/largest_of.h"
#include "tests/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace test_fractional_delay {

using vybeg::FractionalDelay;

namespace {

std::vector<double> noise(std::size_t length) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<double> x(length);
    std::ranges::generate(x, [&] { return uniform(random); });
    return x;
}

// x(i - delay) for i in [0, length) of a sinusoid, from samples that reach exactly as far as asked.
double largest_error(double delay, double frequency, double phase, std::size_t length) {
    const FractionalDelay filter(delay);
    const auto sinusoid = [&](double t) {
        return std::cos(2 * std::numbers::pi * frequency * t + phase);
    };
    const std::int64_t before = filter.reach_before();
    std::vector<double> x;
    for (std::int64_t t = -before; t < static_cast<std::int64_t>(length) + filter.reach_after();
         ++t) {
        x.push_back(sinusoid(static_cast<double>(t)));
    }
    std::vector<double> y(length);
    filter.apply(x, before, y);
    double largest = 0;
    for (std::size_t i = 0; i < length; ++i) {
        largest = vybeg::test::largest_of(
            {largest, std::abs(y[i] - sinusoid(static_cast<double>(i) - delay))});
    }
    return largest;
}

}  // namespace

class TestFractionalDelay : public QObject {
    Q_OBJECT

private slots:
    void error_stays_below_1e_6_up_to_0_4_of_the_rate_for_every_fraction() {
        double worst = 0;
        for (int part = -64; part <= 64; ++part) {
            for (int step = 0; step <= 80; ++step) {
                const double frequency = 0.4 * step / 80;
                // Two phases a quarter turn apart meet the error wherever it points.
                for (const double phase : {0.0, std::numbers::pi / 2}) {
                    worst = vybeg::test::largest_of(
                        {worst, largest_error(part / 64.0, frequency, phase, 24)});
                }
            }
        }
        VYBEG_LESS(worst, 1e-6);
    }

    void error_stays_below_1e_6_for_large_and_negative_delays() {
        for (const double delay : {1.572, -1.572, 20.5, -20.5, 21.7, 1000.37, -1000.37, 65537.9}) {
            for (int step = 0; step <= 80; ++step) {
                const double worst = largest_error(delay, 0.4 * step / 80, 0.3, 100);
                VYBEG_LESS(worst, 1e-6,
                           qPrintable(QString("delay %1, frequency %2: %3")
                                          .arg(delay)
                                          .arg(0.4 * step / 80)
                                          .arg(worst)));
            }
        }
    }

    void whole_delays_are_exact_and_reach_no_further_than_they_must() {
        const std::vector<double> x = noise(3000);
        for (const std::int64_t delay : {0, 1, -1, 7, -30, 1000, -1000}) {
            const FractionalDelay filter(static_cast<double>(delay));
            QCOMPARE(filter.reach_before(), std::max<std::int64_t>(0, delay));
            QCOMPARE(filter.reach_after(), std::max<std::int64_t>(0, -delay));
            std::vector<double> y(1000);
            filter.apply(x, 1000, y);
            const std::vector<double> expected(x.begin() + (1000 - delay),
                                               x.begin() + (2000 - delay));
            QCOMPARE(y, expected);
        }
    }

    void a_delay_that_is_whole_but_for_rounding_counts_as_whole() {
        const double delay = 0.0003 * 10000;  // 3 - 4e-16
        QVERIFY(delay != 3);
        QCOMPARE(FractionalDelay(delay).reach_before(), 3);
        QCOMPARE(FractionalDelay(delay).reach_after(), 0);
        VYBEG_MORE(FractionalDelay(3 - 1e-6).reach_after(), 0);
    }

    void reach_is_exactly_what_is_read_data() {
        QTest::addColumn<double>("delay");
        for (const double delay : {0.0, 0.25, -0.25, 0.5, -0.5, 1.572, 3.0, -3.0, 20.3, -20.3}) {
            QTest::newRow(qPrintable(QString::number(delay))) << delay;
        }
    }

    void reach_is_exactly_what_is_read() {
        QFETCH(double, delay);
        const FractionalDelay filter(delay);
        const std::int64_t before = filter.reach_before();
        const std::int64_t after = filter.reach_after();
        const auto result_with_missing = [&](std::int64_t offset) {
            std::vector<double> x(static_cast<std::size_t>(before + after) + 3, 1.0);
            x[before + 1 + offset] = std::numeric_limits<double>::quiet_NaN();
            std::vector<double> y(1);
            filter.apply(x, before + 1, y);
            return y[0];
        };
        QVERIFY(!std::isnan(result_with_missing(-before - 1)));
        QVERIFY(!std::isnan(result_with_missing(after + 1)));
        // The far end is always needed; the near one where the reach is not cut off at the point.
        QVERIFY(before == 0 || std::isnan(result_with_missing(-before)));
        QVERIFY(after == 0 || std::isnan(result_with_missing(after)));
    }

    void a_delay_beyond_the_filter_reaches_to_one_side_only() {
        QCOMPARE(FractionalDelay(1000.37).reach_after(), 0);
        VYBEG_MORE(FractionalDelay(1000.37).reach_before(), 1000);
        QCOMPARE(FractionalDelay(-1000.37).reach_before(), 0);
        VYBEG_MORE(FractionalDelay(-1000.37).reach_after(), 1000);
    }

    void a_sample_has_the_same_bits_however_the_signal_is_cut() {
        const std::vector<double> x = noise(500);
        const FractionalDelay filter(1.572);
        std::vector<double> whole(400);
        filter.apply(x, 50, whole);
        for (const std::size_t piece : {1U, 2U, 7U, 15U, 16U, 17U, 33U, 100U}) {
            std::vector<double> cut(400);
            for (std::size_t at = 0; at < cut.size(); at += piece) {
                const std::size_t length = std::min(piece, cut.size() - at);
                filter.apply(x, static_cast<std::int64_t>(50 + at),
                             std::span(cut).subspan(at, length));
            }
            QVERIFY(std::memcmp(cut.data(), whole.data(), whole.size() * sizeof(double)) == 0);
        }
    }

    void a_constant_passes_to_rounding() {
        // 42 products and their sum: 42 units of 1.1e-16, relative to the constant.
        for (int part = -50; part <= 50; ++part) {
            const FractionalDelay filter(part / 100.0);
            const std::vector<double> x(100, 12345.678);
            std::vector<double> y(20);
            filter.apply(x, 40, y);
            for (const double value : y) {
                VYBEG_CLOSE_RATIO(value, 12345.678, 42 * 1.2e-16);
            }
        }
    }
};

VYBEG_TEST(TestFractionalDelay)

}  // namespace test_fractional_delay

#include "test_fractional_delay.moc"
