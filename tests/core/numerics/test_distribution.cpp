#include "core/numerics/statistics.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace test_distribution {

using namespace vybeg;

namespace {

template <class Draw>
std::vector<double> drawn(std::size_t count, unsigned seed, Draw draw) {
    std::mt19937_64 random(seed);
    std::vector<double> x(count);
    for (double& value : x) {
        value = draw(random);
    }
    return x;
}

std::int64_t total(const Histogram& histogram) {
    return std::accumulate(histogram.counts.begin(), histogram.counts.end(),
                           histogram.below + histogram.above);
}

}  // namespace

class TestDistribution : public QObject {
    Q_OBJECT

private slots:
    void moments_of_a_few_numbers_are_those_by_hand() {
        const std::vector<double> x{1, 2, 3, 4, 10};
        const Moments moments = moments_of(x);
        QCOMPARE(moments.count, std::size_t(5));
        VYBEG_CLOSE(moments.mean, 4, 1e-15);
        VYBEG_CLOSE(moments.sd, std::sqrt(10.0), 1e-15);
        // Sums of the third and fourth powers: 180 and 1394.
        VYBEG_CLOSE(moments.skewness, 36 / std::pow(10, 1.5), 1e-14);
        VYBEG_CLOSE(moments.kurtosis, 278.8 / 100 - 3, 1e-14);
        VYBEG_CLOSE(moments.largest_z, 6 / std::sqrt(10.0), 1e-15);
    }

    void too_few_numbers_and_equal_ones_have_no_moments() {
        QVERIFY(std::isnan(moments_of({}).mean));
        const std::vector<double> three{1, 2, 4};
        QVERIFY(std::isfinite(moments_of(three).sd));
        QVERIFY(std::isnan(moments_of(three).skewness));
        const std::vector<double> equal(10, 0.5);
        QCOMPARE(moments_of(equal).sd, 0.0);
        QVERIFY(std::isnan(moments_of(equal).kurtosis));
        QVERIFY(histogram_of(equal, moments_of(equal)).counts.empty());
    }

    // Mean squares over 1000 samples; that of a nearly normal number has a relative sd of 4.5 %.
    void skewness_and_kurtosis_of_normal_numbers_scatter_as_stated_data() {
        QTest::addColumn<int>("count");
        for (const int count : {20, 200, 2000}) {
            QTest::addRow("%d", count) << count;
        }
    }

    void skewness_and_kurtosis_of_normal_numbers_scatter_as_stated() {
        QFETCH(int, count);
        constexpr int trials = 1000;
        double skewness = 0;
        double kurtosis = 0;
        Moments moments;
        for (unsigned seed = 1; seed <= trials; ++seed) {
            moments = moments_of(drawn(static_cast<std::size_t>(count), seed, [](auto& random) {
                return std::normal_distribution<double>(2, 3)(random);
            }));
            skewness += std::pow(moments.skewness / moments.sd_skewness, 2);
            // Its mean is -6/(n + 1).
            kurtosis += std::pow((moments.kurtosis + 6.0 / (count + 1)) / moments.sd_kurtosis, 2);
        }
        // The fourth moment of the kurtosis of few numbers is large.
        VYBEG_CLOSE_RATIO(skewness / trials, 1, 0.25);
        VYBEG_CLOSE_RATIO(kurtosis / trials, 1, count < 100 ? 0.5 : 0.25);
    }

    void an_exponential_distribution_is_recognised() {
        const Moments moments = moments_of(drawn(200000, 3, [](auto& random) {
            return std::exponential_distribution<double>(4)(random);
        }));
        VYBEG_CLOSE_RATIO(moments.skewness, 2, 0.05);
        VYBEG_CLOSE_RATIO(moments.kurtosis, 6, 0.15);
        VYBEG_LESS(moments.expected_beyond, 0.01);
    }

    void counts_add_up_to_all_numbers_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("outlier");
        for (const int count : {4, 20, 60, 1000, 100000}) {
            QTest::addRow("%d", count) << count << 0.0;
            QTest::addRow("%d and one far away", count) << count << 1e4;
        }
    }

    void counts_add_up_to_all_numbers() {
        QFETCH(int, count);
        QFETCH(double, outlier);
        std::vector<double> x = drawn(static_cast<std::size_t>(count), 5, [](auto& random) {
            return std::normal_distribution<double>()(random);
        });
        x.front() += outlier;
        const Moments moments = moments_of(x);
        const Histogram histogram = histogram_of(x, moments);
        QCOMPARE(total(histogram), std::int64_t(count));
        QCOMPARE(histogram.above > 0, moments.largest_z > 8);
        QCOMPARE(histogram.counts.size() % 2, std::size_t(1));
        VYBEG_CLOSE(histogram.low, -0.5 * histogram.width * double(histogram.counts.size()), 1e-9);
    }

    void counts_follow_the_normal_curve() {
        const auto x = drawn(1000000, 9, [](auto& random) {
            return std::normal_distribution<double>(-1, 0.01)(random);
        });
        const Histogram histogram = histogram_of(x, moments_of(x));
        VYBEG_MORE(histogram.counts.size(), 50);
        for (std::size_t k = 0; k < histogram.counts.size(); ++k) {
            const double from = histogram.low + histogram.width * double(k);
            const double share =
                0.5 * (std::erf((from + histogram.width) / M_SQRT2) - std::erf(from / M_SQRT2));
            const double expected = share * double(x.size());
            VYBEG_CLOSE(histogram.counts[k], expected, 5 * std::sqrt(expected) + 5);
        }
    }
};

VYBEG_TEST(TestDistribution)

}  // namespace test_distribution

#include "test_distribution.moc"
