#include "core/numerics/control_chart.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace test_control_chart {

using namespace vybeg;

namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

}  // namespace

class TestControlChart : public QObject {
    Q_OBJECT

private slots:
    // NIST/SEMATECH e-Handbook of Statistical Methods, 6.3.2.2, flow rates of batches. The
    // deviation is that of the values; the handbook has it from the mean range, 1.665.
    void values_and_ranges_are_those_of_the_handbook() {
        const std::vector<double> flow{49.6, 47.6, 49.9, 51.3, 47.8, 51.2, 52.6, 52.4, 53.6, 52.1};
        const ControlCharts charts = control_charts(flow, std::vector<double>(10, absent), 10);
        VYBEG_CLOSE(charts.centre, 50.81, 1e-9);
        VYBEG_CLOSE(charts.deviations[0], 2.033852, 1e-6);  // statistics.stdev() of Python
        VYBEG_CLOSE(charts.individuals.values[0], 49.6 - 50.81, 1e-9);
        QVERIFY(std::isnan(charts.ranges.values[0]));
        VYBEG_CLOSE(charts.ranges.values[1], 2.0, 1e-9);
        for (std::size_t k = 0; k < flow.size(); ++k) {
            QVERIFY(!charts.is_out(k));
        }
    }

    // Of one alarm in 370 * 0.9 points a fifth is for values, a tenth for changes, the rest for the
    // average.
    void limits_allow_for_a_baseline_of_finite_length() {
        std::vector<double> values;
        for (int k = 0; k < 20; ++k) {
            values.push_back(k % 2 == 0 ? 1 : -1);
        }
        const ControlCharts charts = control_charts(values, std::vector<double>(20, absent), 20);
        const double value = student_limit(0.2 / (370 * 0.9), 19) * std::sqrt(1.05);
        const double range = student_limit(0.1 / (370 * 0.9), 19) * std::sqrt(2);
        VYBEG_CLOSE(charts.individuals.limits[3] / charts.deviations[3], value, 1e-9);
        VYBEG_CLOSE(charts.ranges.limits[3] / charts.deviations[3], range, 1e-9);
        QVERIFY(std::isnan(charts.ranges.limits[0]));
        VYBEG_CLOSE(charts.average.limits.back(), ewma_limit(0.2, 20, 370 * 0.9 / 0.7) / 3,
                    1e-3);  // sqrt(0.2 / 1.8)
    }

    // Abramowitz and Stegun, table 26.10: t of 0.05 and 0.001 on both sides together.
    void students_distribution_is_that_of_the_tables() {
        VYBEG_CLOSE(student_limit(0.05, 1), 12.706, 5e-4);
        VYBEG_CLOSE(student_limit(0.05, 2), 4.303, 5e-4);
        VYBEG_CLOSE(student_limit(0.05, 9), 2.262, 5e-4);
        VYBEG_CLOSE(student_limit(0.001, 10), 4.587, 5e-4);
        VYBEG_CLOSE(student_limit(0.001, 29), 3.659, 5e-4);
        VYBEG_CLOSE(student_beyond(student_limit(1e-4, 17), 17), 1e-4, 1e-12);
    }

    void a_jump_is_out_and_the_way_back_too() {
        std::vector<double> values{1, 2, 1, 2, 1, 2, 1, 2, 1, 2, absent, 19, 1};
        const ControlCharts charts =
            control_charts(values, std::vector<double>(values.size(), absent), 10);
        VYBEG_CLOSE(charts.centre, 1.5, 1e-12);
        std::vector<bool> out(values.size(), false);
        out[11] = true;
        QCOMPARE(charts.individuals.out, out);
        // From the last value that there is.
        VYBEG_CLOSE(charts.ranges.values[11], 17.0, 1e-12);
        QVERIFY(charts.ranges.out[11] && charts.ranges.out[12]);
        QVERIFY(charts.is_out(11) && !charts.is_out(10));
    }

    // The same, 6.3.2.4: weights of 0.3, started at 50 instead of at the baseline's mean.
    void averages_are_those_of_the_handbook() {
        const std::vector<double> values{52.0, 47.0, 53.0, 49.3, 50.1, 47.0, 51.0,
                                         50.1, 51.2, 50.5, 49.6, 47.6, 49.9, 51.3,
                                         47.8, 51.2, 52.6, 52.4, 53.6, 52.1};
        constexpr std::array told{50.60, 49.52, 50.56, 50.18, 50.16, 49.21, 49.75,
                                  49.85, 50.26, 50.33, 50.11, 49.36, 49.52, 50.05,
                                  49.38, 49.92, 50.73, 51.23, 51.94, 51.99};
        const std::vector<double> u(values.size(), absent);
        const ControlCharts charts = control_charts(values, u, values.size(), 0.3);
        const double deviation = charts.deviations[0];
        VYBEG_CLOSE(deviation, 1.969043, 1e-6);  // statistics.stdev() of Python
        const ControlChart& average = charts.average;
        for (std::size_t k = 0; k < values.size(); ++k) {
            const double start = (50 - charts.centre) * std::pow(0.7, static_cast<double>(k) + 1);
            VYBEG_CLOSE(charts.centre + deviation * average.values[k] + start, told[k], 6e-3);
        }
        // Of 0.3 at the first and sqrt(0.3 / 1.7) at the last.
        VYBEG_CLOSE(average.limits.back() / average.limits.front(), 1.4003, 1e-3);
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

    void results_count_by_their_own_uncertainties() {
        // Alternating scatter of 1, and one result that tells an uncertainty of 100.
        std::vector<double> values;
        for (int k = 0; k < 20; ++k) {
            values.push_back(k % 2 == 0 ? 1 : -1);
        }
        values[7] = 50;
        std::vector<double> u(values.size(), 0.1);
        u[7] = 100;
        const ControlCharts charts = control_charts(values, u, values.size());
        VYBEG_CLOSE(charts.centre, 0.05, 0.02);
        VYBEG_CLOSE(charts.deviations[6], 1.0, 0.05);
        VYBEG_CLOSE(charts.individuals.values[7] / charts.deviations[7], 0.5, 0.01);
        QVERIFY(!charts.individuals.out[7]);
    }

    // An u above the scatter holds parts that all results share: a step beyond the scatter is seen.
    void an_uncertainty_common_to_all_results_hides_no_step() {
        std::vector<double> values;
        for (int k = 0; k < 20; ++k) {
            values.push_back(k % 2 == 0 ? 1 : -1);
        }
        values.push_back(8);
        const ControlCharts charts = control_charts(values, std::vector<double>(21, 300.0), 20);
        VYBEG_CLOSE(charts.deviations[20], std::sqrt(20. / 19), 1e-9);
        QVERIFY(charts.individuals.out[20]);
    }

    void a_baseline_too_short_or_without_scatter_has_no_limits() {
        const std::vector<double> few{1, 2, 3, 1, 2, 3, 1, 2, 3};
        const ControlCharts charts = control_charts(few, std::vector<double>(9, absent), 9);
        QCOMPARE(charts.fault, BaselineFault::too_few);
        QCOMPARE(charts.used, std::size_t(9));
        QVERIFY(std::isnan(charts.centre) && std::isnan(charts.individuals.limits[5]));
        QVERIFY(!charts.is_out(5));
        const std::vector<double> same(20, 5.0);
        const ControlCharts alike = control_charts(same, std::vector<double>(20, absent), 20);
        QCOMPARE(alike.fault, BaselineFault::too_few);
        QVERIFY(!alike.is_out(19));
    }

    void a_trend_and_correlated_neighbours_in_the_baseline_are_named() {
        std::vector<double> rising;
        std::vector<double> alternating;
        std::vector<double> slow;
        std::mt19937_64 random(5);
        std::normal_distribution<double> normal;
        for (int k = 0; k < 30; ++k) {
            rising.push_back(0.1 * k + normal(random));
            alternating.push_back((k % 2 == 0 ? 1 : -1) + 0.3 * normal(random));
            slow.push_back(std::sin(0.6 * k) + 0.3 * normal(random));
        }
        const std::vector<double> u(30, absent);
        QCOMPARE(control_charts(rising, u, 30).fault, BaselineFault::trend);
        QCOMPARE(control_charts(alternating, u, 30).fault, BaselineFault::correlated);
        QCOMPARE(control_charts(slow, u, 30).fault, BaselineFault::correlated);
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
