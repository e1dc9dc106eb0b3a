#include "core/numerics/spectral_density.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

namespace test_spectral_density {

using namespace vybeg;

namespace {

std::vector<double> noise(std::size_t count, unsigned seed, double sd) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0, sd);
    std::vector<double> x(count);
    for (double& value : x) {
        value = normal(random);
    }
    return x;
}

// x[j] = rho x[j - 1] + noise, stationary from the start.
std::vector<double> autoregressive(std::size_t count, unsigned seed, double rho) {
    std::vector<double> x = noise(count, seed, std::sqrt(1 - rho * rho));
    x[0] /= std::sqrt(1 - rho * rho);
    for (std::size_t j = 1; j < count; ++j) {
        x[j] += rho * x[j - 1];
    }
    return x;
}

double sum_of(const std::vector<double>& x) {
    double sum = 0;
    for (const double value : x) {
        sum += value;
    }
    return sum;
}

}  // namespace

class TestSpectralDensity : public QObject {
    Q_OBJECT

private slots:
    void its_integral_is_the_mean_square_under_the_window() {
        for (const std::size_t size : {4, 60, 1024}) {
            constexpr double rate = 33333;
            const std::vector<double> x = noise(size, 1, 2);
            const std::vector<double> y = noise(size, 2, 0.5);
            SpectralDensity density(size, rate);
            Densities sums;
            density.add_to(sums, x, y);
            std::array<double, 2> expected{};
            double squares = 0;
            for (std::size_t j = 0; j < size; ++j) {
                const double hann =
                    0.5 - 0.5 * std::cos(2 * std::numbers::pi * double(j) / double(size));
                squares += hann * hann;
                expected[0] += hann * hann * x[j] * x[j];
                expected[1] += hann * hann * y[j] * y[j];
            }
            for (std::size_t channel = 0; channel < 2; ++channel) {
                QCOMPARE(sums[channel].size(), density.bins());
                VYBEG_CLOSE_RATIO(sum_of(sums[channel]) * density.bin_hz(),
                                  expected[channel] / squares, 1e-13);
            }
        }
    }

    // Parseval over segments: the weights of the samples in the middle are even within the scatter.
    void its_integral_is_the_variance_of_white_noise() {
        constexpr std::size_t size = 1024;
        constexpr std::size_t count = 256 * size;
        const std::vector<double> x = noise(count, 3, 2);
        const std::vector<double> y = noise(count, 4, 0.1);
        SpectralDensity density(size, 8000);
        Densities sums;
        const auto begins = segments_of(count, size);
        for (const std::size_t begin : begins) {
            density.add_to(sums, std::span(x).subspan(begin, size),
                           std::span(y).subspan(begin, size));
        }
        const double bins = density.bin_hz() / double(begins.size());
        // sd of a variance: sqrt(2/N), and 1.1 times that by uneven weights.
        const double scatter = 1.1 * std::sqrt(2.0 / count);
        VYBEG_CLOSE_RATIO(sum_of(sums[0]) * bins, 4, 5 * scatter);
        VYBEG_CLOSE_RATIO(sum_of(sums[1]) * bins, 0.01, 5 * scatter);
    }

    void a_line_is_in_its_own_channel_with_its_power() {
        constexpr std::size_t size = 4096;
        constexpr double rate = 33333;
        for (const double f : {50.0, 5300.123, 16000.0}) {
            std::vector<double> x(size);
            const std::vector<double> y(size);
            for (std::size_t j = 0; j < size; ++j) {
                x[j] = 0.3 * std::cos(2 * std::numbers::pi * f / rate * double(j) + 0.7);
            }
            SpectralDensity density(size, rate);
            Densities sums;
            density.add_to(sums, x, y);
            const auto peak = std::ranges::max_element(sums[0]) - sums[0].begin();
            VYBEG_WITHIN(double(peak) * density.bin_hz(), f, 0.5 * density.bin_hz());
            VYBEG_CLOSE_RATIO(sum_of(sums[0]) * density.bin_hz(), 0.045, 1e-3);
            VYBEG_CLOSE(sum_of(sums[1]) * density.bin_hz(), 0, 1e-16);
        }
    }

    void segments_cover_a_run_to_both_ends() {
        QVERIFY(segments_of(99, 100).empty());
        for (const std::size_t length : {100, 101, 149, 150, 1000, 1049, 12345}) {
            const auto begins = segments_of(length, 100);
            QCOMPARE(begins.front(), std::size_t(0));
            if (length >= 150) {
                QCOMPARE(begins.back(), length - 100);
            }
            for (std::size_t k = 1; k < begins.size(); ++k) {
                VYBEG_AT_LEAST(begins[k] - begins[k - 1], 49);
                VYBEG_AT_MOST(begins[k] - begins[k - 1], 100);
            }
        }
    }

    void a_ratio_is_exceeded_as_often_as_asked() {
        std::mt19937_64 random(11);
        std::exponential_distribution<double> exponential;
        for (const int segments : {1, 4, 40}) {
            const double ratio = ratio_exceeded(segments, 0.01);
            int exceeded = 0;
            constexpr int trials = 100000;
            for (int trial = 0; trial < trials; ++trial) {
                double sum = 0;
                for (int k = 0; k < segments; ++k) {
                    sum += exponential(random);
                }
                exceeded += sum > ratio * segments ? 1 : 0;
            }
            VYBEG_CLOSE(exceeded, 0.01 * trials, 5 * std::sqrt(0.01 * trials));
        }
        VYBEG_CLOSE(ratio_exceeded(1, 1e-6), 6 * std::numbers::ln10, 1e-6);
    }

    void the_correlation_is_that_of_the_sums() {
        const std::vector<double> x = noise(50, 5, 1);
        const std::vector<double> y = noise(50, 6, 3);
        LaggedProducts products(49);
        products.add(std::span(x).first(30), std::span(y).first(30));
        products.add(std::span(x).subspan(30), std::span(y).subspan(30));
        const auto found = products.correlations();
        for (std::size_t channel = 0; channel < 2; ++channel) {
            const std::vector<double>& signal = channel == 0 ? x : y;
            QCOMPARE(found[channel].size(), std::size_t(30));
            double squares = 0;
            for (const double value : signal) {
                squares += value * value / 50;
            }
            for (std::size_t lag = 0; lag < found[channel].size(); ++lag) {
                double sum = 0;
                double pairs = 0;
                for (std::size_t j = 0; j + lag < 50; ++j) {
                    if (j >= 30 || j + lag < 30) {
                        sum += signal[j] * signal[j + lag];
                        ++pairs;
                    }
                }
                VYBEG_CLOSE(found[channel][lag], sum / pairs / squares, 1e-13);
            }
        }
    }

    void nothing_has_no_correlation() {
        LaggedProducts products(10);
        QVERIFY(products.correlations()[0].empty());
        const std::vector<double> zeros(20);
        products.add(zeros, noise(20, 1, 1));
        QVERIFY(products.correlations()[0].empty());
        QCOMPARE(products.correlations()[1].size(), std::size_t(11));
    }

    // M. S. Bartlett: the variance of r(k) is the sum of (r(j+k) + r(j-k) - 2 r(j) r(k))^2 over
    // j > 0, by N; of an autoregressive process of order 1 in closed form.
    void the_correlation_of_an_autoregressive_process_is_a_power_of_rho_data() {
        QTest::addColumn<double>("rho");
        QTest::addColumn<unsigned>("seed");
        for (const double rho : {0.9, 0.5, -0.7, 0.0}) {
            for (unsigned seed = 1; seed <= 4; ++seed) {
                QTest::addRow("%g, seed %u", rho, seed) << rho << seed;
            }
        }
    }

    void the_correlation_of_an_autoregressive_process_is_a_power_of_rho() {
        QFETCH(double, rho);
        QFETCH(unsigned, seed);
        constexpr std::size_t count = 200000;
        LaggedProducts products(40);
        // Two runs of one process each.
        for (unsigned run = 0; run < 2; ++run) {
            products.add(autoregressive(count / 2, 10 * seed + run, rho),
                         autoregressive(count / 2, 1000 + 10 * seed + run, rho));
        }
        const auto found = products.correlations();
        for (const std::vector<double>& r : found) {
            for (int k = 1; k <= 40; ++k) {
                const double square = rho * rho;
                const double power = std::pow(square, k);
                const double variance =
                    ((1 - power) * (1 + square) / (1 - square) - 2 * k * power) / count;
                VYBEG_CLOSE(r[static_cast<std::size_t>(k)], std::pow(rho, k),
                            5 * std::sqrt(variance));
            }
        }
    }
};

VYBEG_TEST(TestSpectralDensity)

}  // namespace test_spectral_density

#include "test_spectral_density.moc"
