#include "core/numerics/control_chart.h"
#include "core/numerics/ewma_limit.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace test_control_chart {

using namespace vybeg;

namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

}  // namespace

class TestControlChart : public QObject {
    Q_OBJECT

private slots:
    // NIST/SEMATECH e-Handbook of Statistical Methods, 6.3.2.2, flow rates of batches.
    void individuals_are_those_of_the_handbook() {
        const std::vector<double> flow{49.6, 47.6, 49.9, 51.3, 47.8, 51.2, 52.6, 52.4, 53.6, 52.1};
        const IndividualsChart chart = individuals_chart(flow, flow.size());
        VYBEG_CLOSE(chart.centre, 50.81, 1e-9);
        VYBEG_CLOSE(chart.mean_range, 1.8778, 5e-5);
        VYBEG_CLOSE(chart.high, 55.8041, 2e-3);  // the handbook divides by 1.128 instead
        VYBEG_CLOSE(chart.low, 45.8159, 2e-3);
        VYBEG_CLOSE(chart.range_limit, 3.267 * 1.8778, 2e-4);
        QVERIFY(std::ranges::none_of(chart.out, [](bool out) { return out; }));
        QVERIFY(std::isnan(chart.ranges[0]));
        VYBEG_CLOSE(chart.ranges[1], 2.0, 1e-9);
    }

    void a_jump_is_out_in_both_charts_and_not_in_the_baseline() {
        std::vector<double> values{1, 2, 1, 2, 1, 2, absent, 9, 1};
        const IndividualsChart chart = individuals_chart(values, 6);
        VYBEG_CLOSE(chart.centre, 1.5, 1e-12);
        VYBEG_CLOSE(chart.high, 1.5 + 2.66, 1e-12);
        QCOMPARE(chart.out,
                 (std::vector<bool>{false, false, false, false, false, false, false, true, false}));
        // From the last value that there is.
        VYBEG_CLOSE(chart.ranges[7], 7.0, 1e-12);
        QVERIFY(chart.range_is_out[7] && chart.range_is_out[8]);
        QVERIFY(std::isnan(individuals_chart(values, 1).high));
    }

    // The same, 6.3.2.4: weights of 0.3, started at 50 instead of at the baseline's mean.
    void averages_are_those_of_the_handbook() {
        const std::vector<double> values{52.0, 47.0, 53.0, 49.3, 50.1, 47.0, 51.0,
                                         50.1, 51.2, 50.5, 49.6, 47.6, 49.9, 51.3,
                                         47.8, 51.2, 52.6, 52.4, 53.6, 52.1};
        constexpr std::array told{50.60, 49.52, 50.56, 50.18, 50.16, 49.21, 49.75,
                                  49.85, 50.26, 50.33, 50.11, 49.36, 49.52, 50.05,
                                  49.38, 49.92, 50.73, 51.23, 51.94, 51.99};
        const std::vector<double> sd(values.size(), absent);
        const EwmaChart chart = ewma_chart(values, sd, values.size(), {.lambda = 0.3});
        VYBEG_CLOSE(chart.scatter, 1.969043, 1e-6);  // statistics.stdev() of Python
        for (std::size_t k = 0; k < values.size(); ++k) {
            const double start = (50 - chart.centre) * std::pow(0.7, static_cast<double>(k) + 1);
            VYBEG_CLOSE(chart.centre + chart.scatter * chart.average[k] + start, told[k], 6e-3);
        }
        VYBEG_CLOSE(chart.limits.back() / chart.limit, 0.4201, 1e-4);  // sqrt(0.3 / 1.7)
        VYBEG_CLOSE(chart.limits.front() / chart.limit, 0.3, 1e-12);
    }

    // J. M. Lucas, M. S. Saccucci, Technometrics 32 (1990): 370 points at these limits.
    void run_lengths_are_those_of_the_literature_data() {
        QTest::addColumn<double>("lambda");
        QTest::addColumn<double>("limit");
        QTest::newRow("0.1") << 0.1 << 2.701;
        QTest::newRow("0.2") << 0.2 << 2.859;
        QTest::newRow("a Shewhart chart") << 1.0 << 3.0;
    }

    void run_lengths_are_those_of_the_literature() {
        QFETCH(double, lambda);
        QFETCH(double, limit);
        VYBEG_CLOSE(ewma_run_length(lambda, limit, 0, 1), 370.4, 1.0);
        // In units of the standard deviation.
        VYBEG_CLOSE(ewma_run_length(lambda, limit * 2, 0, 2), 370.4, 1.0);
    }

    // Against the same averages with 41 nodes, exact quantiles and SciPy 1.10.
    void the_limit_widens_as_the_baseline_shortens() {
        VYBEG_CLOSE(ewma_limit(0.2, 1000000, 370), 2.859, 2e-3);
        VYBEG_CLOSE(ewma_limit(0.2, 100, 370), 3.023, 3e-3);
        VYBEG_CLOSE(ewma_limit(0.2, 50, 370), 3.188, 3e-3);
        VYBEG_CLOSE(ewma_limit(0.2, 30, 370), 3.411, 5e-3);
        QVERIFY(std::isnan(ewma_limit(0.2, 9, 370)));
    }

    void results_count_by_their_own_deviations() {
        // Alternating scatter of 1, and one result that tells a deviation of 100.
        std::vector<double> values;
        for (int k = 0; k < 20; ++k) {
            values.push_back(k % 2 == 0 ? 1 : -1);
        }
        values[7] = 50;
        std::vector<double> sd(values.size(), 0.1);
        sd[7] = 100;
        const EwmaChart chart = ewma_chart(values, sd, values.size());
        VYBEG_CLOSE(chart.centre, 0.05, 0.02);
        VYBEG_CLOSE(chart.scatter, 1.0, 0.05);
        VYBEG_CLOSE(chart.z[7], 0.5, 0.01);
    }

    void deviations_that_explain_the_scatter_leave_none_between() {
        std::vector<double> values;
        for (int k = 0; k < 20; ++k) {
            values.push_back(k % 2 == 0 ? 1 : -1);
        }
        const std::vector<double> sd(values.size(), 3.0);
        const EwmaChart chart = ewma_chart(values, sd, values.size());
        QCOMPARE(chart.scatter, 0.0);
        VYBEG_CLOSE(chart.z[0], 1.0 / 3, 1e-12);
    }

    void a_baseline_too_short_or_without_scatter_has_no_limits() {
        const std::vector<double> few{1, 2, 3};
        const std::vector<double> no_sd(20, absent);
        const EwmaChart chart = ewma_chart(few, std::vector<double>(3, absent), 3);
        QVERIFY(std::isnan(chart.limit));
        QCOMPARE(chart.out, std::vector<bool>(3, false));
        const EwmaChart alike = ewma_chart(std::vector<double>(20, 5.0), no_sd, 20);
        QVERIFY(std::isnan(alike.limit));
        QCOMPARE(alike.out, std::vector<bool>(20, false));
    }

    void axes_near_the_end_of_their_range_do_not_jump() {
        const std::vector<double> moved =
            beside_first(std::vector{absent, 0.78, -0.78, 0.1}, M_PI / 2);
        QVERIFY(std::isnan(moved[0]));
        VYBEG_CLOSE(moved[1], 0.78, 1e-12);
        VYBEG_CLOSE(moved[2], M_PI / 2 - 0.78, 1e-12);
        VYBEG_CLOSE(moved[3], 0.1, 1e-12);
    }
};

VYBEG_TEST(TestControlChart)

}  // namespace test_control_chart

#include "test_control_chart.moc"
