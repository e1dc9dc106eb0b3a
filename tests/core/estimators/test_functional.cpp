#include "core/estimators/batch/descent.h"
#include "tests/closeness.h"
#include "tests/core/estimators/still_windows.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <random>

namespace test_functional {

using namespace vybeg;
using test::Samples;

namespace {

Samples noise(std::int64_t n, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> sample(-1, 1);
    Samples samples;
    for (std::int64_t j = 0; j < n; ++j) {
        samples.c.push_back(sample(random));
        samples.d.push_back(sample(random));
    }
    return samples;
}

// n F straight from (6) and the samples.
double direct(const Samples& s, const Five<double>& p) {
    const auto& [a_A, a_B, two_theta_A, alpha, w] = p;
    const auto n = static_cast<double>(s.c.size());
    double sum = 0;
    for (std::size_t j = 0; j < s.c.size(); ++j) {
        const double tau = w * (static_cast<double>(j) - (n - 1) / 2) - alpha;
        const double a = a_A * std::cos(tau);
        const double b = a_B * std::sin(tau);
        const double cosine = std::cos(two_theta_A);
        const double sine = std::sin(two_theta_A);
        const double c = s.c[j] - (a * cosine - b * sine);
        const double d = s.d[j] - (a * sine + b * cosine);
        sum += c * c + d * d;
    }
    return sum;
}

Five<double> with(Five<double> p, std::size_t k, double step) {
    p[k] += step;
    return p;
}

WaveFunctional<double> evaluate(const Samples& s, const Five<double>& p) {
    return functional_at({s.c, s.d}, p);
}

}  // namespace

// Samples without any wave in them, random parameters: nothing cancels by luck.
class TestFunctional : public QObject {
    Q_OBJECT

private slots:
    void equalsTheSumOverTheSamples() {
        for (const std::int64_t n : {5, 6, 63, 64, 65, 1000, 100000}) {
            const Samples s = noise(n, 7 + static_cast<std::uint64_t>(n));
            double power = 0;
            for (std::size_t j = 0; j < s.c.size(); ++j) {
                power += s.c[j] * s.c[j] + s.d[j] * s.d[j];
            }
            const Five<double> p{0.9, -0.4, 1.1, 2.2, 0.97};
            const double expected = direct(s, p);
            VYBEG_CLOSE(power + evaluate(s, p).value, expected, 1e-12 * expected);
        }
    }

    void gradientAndHessianMatchCentralDifferences() {
        std::mt19937_64 random(99);
        std::uniform_real_distribution<double> angle(-3, 3);
        for (const std::int64_t n : {5, 22, 130}) {
            const Samples s = noise(n, static_cast<std::uint64_t>(n));
            for (int trial = 0; trial < 20; ++trial) {
                const Five<double> p{1.3, 0.3 * angle(random), angle(random), angle(random),
                                     1.4 + 0.3 * angle(random)};
                const WaveFunctional<double> f = evaluate(s, p);
                // Errors of the differences: of second order in the step, relative to n times the
                // power.
                for (std::size_t k = 0; k < 5; ++k) {
                    const double step = k == 4 ? 1e-4 / static_cast<double>(n) : 1e-4;
                    const double scale =
                        static_cast<double>(n) * (k == 4 ? static_cast<double>(n) : 1);
                    const double slope =
                        (direct(s, with(p, k, step)) - direct(s, with(p, k, -step))) / (2 * step);
                    VYBEG_CLOSE(slope, f.gradient[k], 1e-7 * scale,
                                qPrintable(QString("gradient %1").arg(k)));
                    const Five<double> above = evaluate(s, with(p, k, step)).gradient;
                    const Five<double> below = evaluate(s, with(p, k, -step)).gradient;
                    for (std::size_t m = 0; m < 5; ++m) {
                        const double column = (above[m] - below[m]) / (2 * step);
                        const double other = m == 4 ? static_cast<double>(n) : 1;
                        VYBEG_CLOSE(column, f.hessian[m][k], 1e-7 * scale * other,
                                    qPrintable(QString("hessian %1 %2").arg(m).arg(k)));
                    }
                }
            }
        }
    }

    void momentsMatchTheirSums() {
        for (const std::int64_t n : {5, 64, 129, 5000}) {
            const Samples s = noise(n, 3);
            for (const double w : {0.2, 0.999, 3.0}) {
                const WindowMoments m = window_moments({s.c, s.d}, w);
                std::array<std::complex<long double>, 3> expected{};
                double gram = 0;
                for (std::size_t j = 0; j < s.c.size(); ++j) {
                    const long double u = static_cast<long double>(j) - 0.5L * (n - 1);
                    const auto wave = std::polar(1.0L, -static_cast<long double>(w) * u);
                    expected[0] += wave * static_cast<long double>(s.d[j]);
                    expected[1] += wave * (u * s.d[j]);
                    expected[2] += wave * (u * u * s.d[j]);
                    gram += static_cast<double>(std::cos(w * u) * std::cos(w * u));
                }
                double size = static_cast<double>(n);
                for (std::size_t k = 0; k < 3; ++k, size *= static_cast<double>(n)) {
                    VYBEG_CLOSE(std::complex<double>(expected[k]), m.d[k], 1e-13 * size);
                }
                VYBEG_CLOSE(window_kernel(n, w).gram_cos, gram, 1e-12 * static_cast<double>(n));
            }
        }
    }
};

VYBEG_TEST(TestFunctional)

}  // namespace test_functional

#include "test_functional.moc"
