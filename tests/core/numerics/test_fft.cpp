#include "core/numerics/fft.h"
#include "tests/closeness.h"
#include "tests/largest_of.h"
#include "tests/test_registry.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <thread>
#include <vector>

namespace test_fft {

using Complex = std::complex<double>;

namespace {

std::vector<Complex> noise(std::size_t size) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    std::vector<Complex> x(size);
    std::ranges::generate(x, [&] { return Complex(normal(random), normal(random)); });
    return x;
}

double largest_difference(const std::vector<Complex>& a, const std::vector<Complex>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = vybeg::test::largest_of({largest, std::abs(a[i] - b[i])});
    }
    return largest;
}

}  // namespace

class TestFft : public QObject {
    Q_OBJECT

private slots:
    void it_is_the_discrete_fourier_transform_data() {
        QTest::addColumn<int>("size");
        for (const int size : {1, 2, 12, 60, 97, 256}) {
            QTest::newRow(qPrintable(QString::number(size))) << size;
        }
    }

    void it_is_the_discrete_fourier_transform() {
        QFETCH(int, size);
        const auto n = static_cast<std::size_t>(size);
        const std::vector<Complex> x = noise(n);
        std::vector<Complex> expected(n);
        for (std::size_t k = 0; k < n; ++k) {
            for (std::size_t j = 0; j < n; ++j) {
                expected[k] += x[j] * std::polar(1.0, -2 * std::numbers::pi *
                                                          static_cast<double>(j * k % n) / size);
            }
        }
        const vybeg::Fft fft(n);
        std::vector<Complex> transformed = x;
        fft.forward(transformed);
        // Sums of n terms of size about one, rounded at 1e-16 each.
        VYBEG_CLOSE(largest_difference(transformed, expected), 0, 1e-15 * (4 + size));

        fft.inverse(transformed);
        for (Complex& value : transformed) {
            value /= size;
        }
        VYBEG_CLOSE(largest_difference(transformed, x), 0, 1e-14);
    }

    void plans_may_be_made_and_used_from_several_threads_with_the_same_bits() {
        const std::size_t size = 4096;
        const std::vector<Complex> x = noise(size);
        std::vector<Complex> expected = x;
        const vybeg::Fft shared(size);
        shared.forward(expected);

        std::array<int, 4> differences{};
        std::vector<std::jthread> threads;
        for (int& count : differences) {
            threads.emplace_back([&] {
                for (int round = 0; round < 50; ++round) {
                    const vybeg::Fft own(size);
                    std::vector<Complex> a = x;
                    std::vector<Complex> b = x;
                    own.forward(a);
                    shared.forward(b);
                    count += (a != expected) + (b != expected);
                }
            });
        }
        threads.clear();
        QCOMPARE(differences, (std::array<int, 4>{}));
    }
};

VYBEG_TEST(TestFft, threads)

}  // namespace test_fft

#include "test_fft.moc"
