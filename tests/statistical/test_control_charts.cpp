#include "core/numerics/control_chart.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace test_control_charts {

using namespace vybeg;

namespace {

// A laboratory's history of one parameter: a hundred results set the limits. Each has a deviation
// of its own of 0.6 and one between the results of 0.8, together 1, unknown to the chart.
constexpr int baseline = 100;
constexpr double own_sd = 0.6;
constexpr double between_sd = 0.8;

std::vector<double> series_of(std::mt19937_64& random, int count) {
    std::normal_distribution<double> own(0, own_sd);
    std::normal_distribution<double> between(0, between_sd);
    std::vector<double> values;
    for (int k = 0; k < count; ++k) {
        values.push_back(own(random) + between(random));
    }
    return values;
}

// Alarms of the three charts after the baseline, which begin anew after each.
int alarms_of(const ControlCharts& charts, std::size_t from, double lambda) {
    double average = charts.average.values[from - 1];
    double rest = 0;  // of the start in the average, squared; after the baseline there is none left
    bool compare_with_before = true;
    int alarms = 0;
    for (std::size_t k = from; k < charts.deviations.size(); ++k) {
        const double z = charts.individuals.values[k] / charts.deviations[k];
        average = lambda * z + (1 - lambda) * average;
        rest *= (1 - lambda) * (1 - lambda);
        const double limit = charts.average.limits.back() * std::sqrt(1 - rest);
        const bool out = charts.individuals.out[k] ||
                         (compare_with_before && charts.ranges.out[k]) || std::abs(average) > limit;
        compare_with_before = !out;
        if (out) {
            ++alarms;
            average = 0;
            rest = 1;
        }
    }
    return alarms;
}

// Share of the series in which a step of `step` deviations is found within ten results.
double share_found(std::uint64_t seed, int count, double step) {
    std::mt19937_64 random(seed);
    const std::vector<double> u(baseline + 30, own_sd);
    int found = 0;
    for (int trial = 0; trial < count; ++trial) {
        std::vector<double> values = series_of(random, baseline + 30);
        // 20 results as before, then the step.
        const auto after = values.begin() + baseline + 20;
        std::for_each(after, values.end(), [step](double& value) { value += step; });
        const ControlCharts charts = control_charts(values, u, baseline);
        bool is_out = false;
        for (std::size_t k = baseline + 20; k < values.size(); ++k) {
            is_out = is_out || charts.is_out(k);
        }
        found += is_out ? 1 : 0;
    }
    return static_cast<double>(found) / count;
}

}  // namespace

class TestControlCharts : public QObject {
    Q_OBJECT

private slots:
    void a_step_of_one_and_a_half_deviations_is_found_within_ten_results() {
        const double found = share_found(1, 200, 1.5);
        qInfo("found in %.1f %% of 200 series", 100 * found);
        VYBEG_AT_LEAST(found, 0.9);
    }

    // The share above is known to 2 % only; this one to 0.5 %.
    void over_many_series_too() {
        const double found = share_found(2, 3000, 1.5);
        qInfo("found in %.1f %% of 3000 series", 100 * found);
        VYBEG_AT_LEAST(found, 0.905);
    }

    void false_alarms_of_the_three_charts_are_one_in_370_results_data() {
        QTest::addColumn<int>("length");
        QTest::addColumn<int>("series");
        QTest::newRow("10") << 10 << 6000;
        QTest::newRow("20") << 20 << 4000;
        QTest::newRow("40") << 40 << 2000;
        QTest::newRow("100") << 100 << 1000;
    }

    // Baselines differ in their rate by more than its size where they are short: the mean over
    // these series of 200 results after their baseline is known to about 6 %.
    void false_alarms_of_the_three_charts_are_one_in_370_results() {
        QFETCH(int, length);
        QFETCH(int, series);
        constexpr int after = 200;
        std::mt19937_64 random(3);
        const std::vector<double> u(static_cast<std::size_t>(length + after), own_sd);
        double alarms = 0;
        for (int trial = 0; trial < series; ++trial) {
            const std::vector<double> values = series_of(random, length + after);
            const auto begin = static_cast<std::size_t>(length);
            alarms += alarms_of(control_charts(values, u, begin), begin, last_weight);
        }
        const double points_per_alarm = series * 1.0 * after / alarms;
        qInfo("baseline %d: one false alarm in %.0f results", length, points_per_alarm);
        VYBEG_MORE(points_per_alarm, 370 / 1.15);
        VYBEG_LESS(points_per_alarm, 370 * 1.15);
    }

    // As a laboratory sees it: 20 results set the limits of 30. At one alarm in 370 it is 7.8 %.
    void a_stable_series_of_thirty_seldom_alarms() {
        constexpr int series = 4000;
        std::mt19937_64 random(4);
        const std::vector<double> u(30, own_sd);
        int alarmed = 0;
        int named = 0;
        for (int trial = 0; trial < series; ++trial) {
            const ControlCharts charts = control_charts(series_of(random, 30), u, 20);
            bool out = false;
            for (std::size_t k = 0; k < 30; ++k) {
                out = out || charts.is_out(k);
            }
            alarmed += out ? 1 : 0;
            named += charts.fault != BaselineFault::none ? 1 : 0;
        }
        const double share = static_cast<double>(alarmed) / series;
        const double faulted = static_cast<double>(named) / series;
        qInfo("%.1f %% of series alarm, %.2f %% of baselines are named", 100 * share,
              100 * faulted);
        VYBEG_LESS(share, 0.078);
        // Two tests at 0.005 each; 4000 series tell the share to 0.16 %.
        VYBEG_LESS(faulted, 2 * baseline_level + 0.005);
    }
};

VYBEG_TEST(TestControlCharts)

}  // namespace test_control_charts

#include "test_control_charts.moc"
