#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "ui/values/curve_data.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace test_curve_data {

using namespace vybeg;
using namespace vybeg::ui;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// Windows one second apart from t = 0.
std::shared_ptr<Analysis> analysisOf(std::size_t rows, SlowVariable variable,
                                     const std::function<double(std::size_t)>& value) {
    auto analysis = std::make_shared<Analysis>();
    analysis->track = Track(rows);
    for (std::size_t row = 0; row < rows; ++row) {
        analysis->track.time_s()[row] = static_cast<double>(row);
        analysis->track.values(variable)[row] = value(row);
        analysis->track.sds(variable)[row] = 0.5;
    }
    return analysis;
}

double hash(std::size_t row) {
    return std::sin(static_cast<double>(row * row % 1009));
}

}  // namespace

class TestCurveData : public QObject {
    Q_OBJECT

private slots:
    // Against a plain scan of the windows between the columns' own ends.
    void every_column_has_the_least_and_greatest_value_of_its_windows() {
        constexpr std::size_t rows = 20000;
        const auto analysis = analysisOf(rows, SlowVariable::a_B, [](std::size_t row) {
            return row % 997 == 0 ? missing : hash(row) * static_cast<double>(row);
        });
        const CurveData data(analysis, SlowVariable::a_B);
        const auto values = analysis->track.values(SlowVariable::a_B);
        for (const AxisRange time :
             {AxisRange{0, 19999}, AxisRange{137, 9421}, AxisRange{5, 900}}) {
            const auto columns = data.columns(time, 300);
            VYBEG_AT_LEAST(columns.size(), 300);
            VYBEG_AT_MOST(columns.size(), 904);
            for (const CurveColumn& column : columns) {
                if (column.empty()) {
                    continue;
                }
                double low = INFINITY;
                double high = -INFINITY;
                double sum = 0;
                std::size_t count = 0;
                for (auto row = static_cast<std::size_t>(column.time_first);
                     row <= static_cast<std::size_t>(column.time_last); ++row) {
                    if (std::isfinite(values[row])) {
                        low = std::min(low, values[row]);
                        high = std::max(high, values[row]);
                        sum += values[row];
                        ++count;
                    }
                }
                QCOMPARE(column.min, low);
                QCOMPARE(column.max, high);
                QCOMPARE(column.count, count);
                VYBEG_WITHIN(column.sum, sum, 1e-9 * static_cast<double>(count) * 2e4);
                QCOMPARE(column.band_min, low - 0.5);
                QCOMPARE(column.band_max, high + 0.5);
                QCOMPARE(column.first, values[static_cast<std::size_t>(column.time_first)]);
                QCOMPARE(column.last, values[static_cast<std::size_t>(column.time_last)]);
            }
        }
    }

    void no_window_of_the_range_is_lost_between_columns() {
        const auto analysis =
            analysisOf(20000, SlowVariable::a_B, [](std::size_t row) { return double(row); });
        const CurveData data(analysis, SlowVariable::a_B);
        const auto columns = data.columns({137.4, 9421.7}, 300);
        VYBEG_AT_MOST(columns.front().time_first, 137);
        VYBEG_AT_LEAST(columns.back().time_last, 9421);
        for (std::size_t i = 1; i < columns.size(); ++i) {
            QCOMPARE(columns[i].first, columns[i - 1].last + 1);
            QVERIFY(columns[i].joined);
        }
    }

    void a_single_missing_window_among_thousands_is_told() {
        const auto analysis = analysisOf(
            100000, SlowVariable::a_B, [](std::size_t row) { return row == 54321 ? missing : 1.; });
        const auto columns = CurveData(analysis, SlowVariable::a_B).columns({0, 99999}, 1000);
        const auto told = std::count_if(columns.begin(), columns.end(),
                                        [](const CurveColumn& c) { return c.missing; });
        QCOMPARE(told, 1);
    }

    // Its values have either sign.
    void an_angle_about_pi_is_one_curve() {
        constexpr double pi = std::numbers::pi;
        const auto analysis = analysisOf(2000, SlowVariable::delta_phi_CD, [](std::size_t row) {
            const double angle = pi - 1e-4 * double(row) + 0.05 * hash(row);
            return angle > pi ? angle - 2 * pi : angle;
        });
        const CurveData data(analysis, SlowVariable::delta_phi_CD);
        const auto columns = data.columns({0, 1999}, 100);
        for (std::size_t i = 0; i < columns.size(); ++i) {
            QVERIFY(!columns[i].wraps && columns[i].joined == (i > 0));
            const double middle = pi - 1e-4 * columns[i].time_first;
            VYBEG_WITHIN(columns[i].min, middle, 0.06);
            VYBEG_WITHIN(columns[i].max, middle, 0.06);
        }
        VYBEG_WITHIN(data.value(0), pi, 0.06);
    }

    void no_line_leads_over_a_gap() {
        const auto analysis = analysisOf(40, SlowVariable::a_B, [](std::size_t row) {
            return 10 <= row && row < 13 ? missing : double(row);
        });
        const auto columns = CurveData(analysis, SlowVariable::a_B).columns({0, 39}, 1000);
        QCOMPARE(columns.size(), std::size_t(40));
        QVERIFY(columns[9].joined);
        for (std::size_t row = 10; row < 13; ++row) {
            QVERIFY(columns[row].empty() && columns[row].missing);
        }
        QVERIFY(!columns[13].joined);
        QVERIFY(columns[14].joined);
    }

    void a_dense_gap_leaves_columns_without_a_value() {
        const auto analysis = analysisOf(100000, SlowVariable::a_B, [](std::size_t row) {
            return 50000 <= row && row < 60000 ? missing : 1.;
        });
        const auto columns = CurveData(analysis, SlowVariable::a_B).columns({0, 99999}, 500);
        const auto empty = std::count_if(columns.begin(), columns.end(),
                                         [](const CurveColumn& c) { return c.empty(); });
        VYBEG_AT_LEAST(empty, 49);
        VYBEG_AT_MOST(empty, 51);
    }

    void an_infinite_value_counts_as_missing() {
        const auto analysis = analysisOf(100, SlowVariable::a_B, [](std::size_t row) {
            return row == 50 ? std::numeric_limits<double>::infinity() : 1.;
        });
        const auto columns = CurveData(analysis, SlowVariable::a_B).columns({0, 99}, 10);
        ValueRange range;
        range.add(columns, {}, true);
        VYBEG_LESS(range.range(false)->upper, 10);
    }

    void a_turn_from_pi_to_minus_pi_is_not_joined() {
        const auto analysis = analysisOf(20, SlowVariable::alpha,
                                         [](std::size_t row) { return row < 10 ? 3.1 : -3.1; });
        const auto columns = CurveData(analysis, SlowVariable::alpha).columns({0, 19}, 1000);
        for (std::size_t row = 1; row < 20; ++row) {
            QCOMPARE(columns[row].joined, row != 10);
        }
    }

    void a_turn_inside_a_column_leaves_the_middle_empty() {
        const auto analysis = analysisOf(100000, SlowVariable::alpha, [](std::size_t row) {
            return row % 2 == 0 ? 3. + 0.1 * hash(row) : -3. - 0.1 * hash(row);
        });
        const auto columns = CurveData(analysis, SlowVariable::alpha).columns({0, 99999}, 200);
        for (const CurveColumn& column : columns) {
            if (column.time_first == column.time_last) {
                continue;  // a window alone at the end
            }
            QVERIFY(column.wraps);
            VYBEG_LESS(column.negative_max, -2.8);
            VYBEG_MORE(column.positive_min, 2.8);
        }
    }

    void an_angle_that_is_not_wrapped_may_jump() {
        const auto analysis = analysisOf(20, SlowVariable::two_theta_A,
                                         [](std::size_t row) { return row < 10 ? 0. : 5.; });
        const auto columns = CurveData(analysis, SlowVariable::two_theta_A).columns({0, 19}, 1000);
        QVERIFY(columns[10].joined);
        QVERIFY(!columns[10].wraps);
    }

    // A wave that turns, on one branch: dense and window by window.
    void an_angle_on_a_branch_jumps_at_its_ends_alone() {
        constexpr double pi = std::numbers::pi;
        DisplayUnits units;
        units.wave_angle = WaveAngle::from_zero;
        const DisplayScale scale = displayScale(SlowVariable::two_theta_A, units, 0);
        constexpr double turn = 1e-3;  // from window to window: 1 of 3142 jumps
        const auto analysis = analysisOf(100000, SlowVariable::two_theta_A,
                                         [](std::size_t row) { return turn * double(row); });
        const CurveData data(analysis, SlowVariable::two_theta_A, scale);
        int wraps = 0;
        for (const CurveColumn& column : data.columns({0, 99999}, 200)) {
            VYBEG_AT_LEAST(column.min, 0);
            VYBEG_LESS(column.max, pi);
            wraps += column.wraps ? 1 : 0;
            if (column.wraps) {
                VYBEG_LESS(column.negative_max, pi / 2);
                VYBEG_MORE(column.positive_min, pi / 2);
            }
        }
        QCOMPARE(wraps, static_cast<int>(turn * 99999 / pi));
        const auto single = data.columns({3130, 3150}, 1000);
        const auto jumps = std::ranges::count_if(
            single, [](const CurveColumn& c) { return !c.joined && c.time_first > 3131; });
        QCOMPARE(jumps, 1);
        VYBEG_CLOSE(data.value(4000), 4 - pi, 1e-12);
    }

    void panning_does_not_move_column_borders() {
        const auto analysis =
            analysisOf(100000, SlowVariable::a_B, [](std::size_t row) { return hash(row); });
        const CurveData data(analysis, SlowVariable::a_B);
        const auto before = data.columns({10000, 60000}, 500);
        const auto after = data.columns({10033, 60033}, 500);
        // Every whole column of the first view that is a whole column of the second is the same.
        std::map<double, double> greatest;
        for (const CurveColumn& column : before) {
            greatest[column.time_first] = column.max;
        }
        int same = 0;
        for (std::size_t i = 1; i + 1 < after.size(); ++i) {
            const auto found = greatest.find(after[i].time_first);
            same += found != greatest.end() && found->second == after[i].max;
        }
        VYBEG_AT_LEAST(same, 498);
    }

    void the_nearest_window_is_found() {
        const auto analysis = analysisOf(10, SlowVariable::a_B, [](std::size_t) { return 1.; });
        const CurveData data(analysis, SlowVariable::a_B);
        QCOMPARE(data.nearest(-5), std::size_t(0));
        QCOMPARE(data.nearest(3.4), std::size_t(3));
        QCOMPARE(data.nearest(3.6), std::size_t(4));
        QCOMPARE(data.nearest(99), std::size_t(9));
    }

    void one_spike_does_not_flatten_the_curve() {
        const auto analysis = analysisOf(
            1000, SlowVariable::a_B, [](std::size_t row) { return row == 500 ? 1e6 : hash(row); });
        ValueRange range;
        range.add(CurveData(analysis, SlowVariable::a_B).columns({0, 999}, 1000), {}, false);
        const AxisRange found = *range.range(false);
        VYBEG_LESS(found.lower, -1);
        VYBEG_MORE(found.upper, 1);
        VYBEG_LESS(found.upper, 10);
    }

    void all_values_are_seen_where_nothing_stands_out() {
        const auto analysis =
            analysisOf(1000, SlowVariable::a_B, [](std::size_t row) { return double(row); });
        ValueRange range;
        range.add(CurveData(analysis, SlowVariable::a_B).columns({0, 999}, 1000), {}, false);
        VYBEG_LESS(range.range(false)->lower, 0);
        VYBEG_MORE(range.range(false)->upper, 999);
    }

    void a_wide_band_does_not_flatten_the_curve() {
        const auto analysis =
            analysisOf(1000, SlowVariable::a_B, [](std::size_t row) { return double(row); });
        for (std::size_t row = 0; row < 1000; ++row) {
            analysis->track.sds(SlowVariable::a_B)[row] = row < 300 ? 1e9 : 1;
        }
        ValueRange range;
        range.add(CurveData(analysis, SlowVariable::a_B).columns({0, 999}, 1000), {}, true);
        VYBEG_LESS(range.range(false)->upper, 3000);
    }

    void constant_data_have_an_axis() {
        const auto analysis = analysisOf(100, SlowVariable::f, [](std::size_t) { return 5300.; });
        ValueRange range;
        range.add(CurveData(analysis, SlowVariable::f).columns({0, 99}, 1000), {}, false);
        const AxisRange found = *range.range(false);
        VYBEG_LESS(found.lower, 5300);
        VYBEG_MORE(found.upper, 5300);
        VYBEG_LESS(found.span(), 1);
    }

    void no_value_has_no_axis() {
        const auto analysis = analysisOf(100, SlowVariable::f, [](std::size_t) { return missing; });
        const CurveData data(analysis, SlowVariable::f);
        QVERIFY(data.empty());
        ValueRange range;
        range.add(data.columns({0, 99}, 50), {}, true);
        QVERIFY(!range.range(false));
    }

    void a_logarithmic_axis_stays_above_zero() {
        const auto analysis = analysisOf(100, SlowVariable::a_A, [](std::size_t row) {
            return std::exp(-0.1 * static_cast<double>(row));
        });
        ValueRange range;
        range.add(CurveData(analysis, SlowVariable::a_A).columns({0, 99}, 50), {}, true);
        VYBEG_MORE(range.range(true)->lower, 0);
        VYBEG_MORE(range.range(true)->upper, 1);
    }
};

VYBEG_TEST(TestCurveData)

}  // namespace test_curve_data

#include "test_curve_data.moc"
