#include "core/recording/times/time_grid.h"
#include "tests/closeness.h"
#include "tests/core/recording/times/timed_signal.h"
#include "tests/largest_of.h"
#include "tests/test_registry.h"

#include <random>

namespace test_time_grid {

using namespace vybeg;
using namespace vybeg::test;

class TestTimeGrid : public QObject {
    Q_OBJECT

private slots:
    void a_cubic_comes_out_exactly_between_uneven_nodes() {
        const std::vector<double> nodes = {0, 0.7, 2.1, 2.9, 4.4, 5};
        const auto cubic = [](double x) { return 1 - 2 * x + 0.5 * x * x - 0.3 * x * x * x; };
        std::vector<double> values;
        for (const double node : nodes) {
            values.push_back(cubic(node));
        }
        std::vector<double> out(51);
        interpolate_cubic(nodes, values, 0, 0.1, out);
        for (std::size_t i = 0; i < out.size(); ++i) {
            VYBEG_CLOSE(out[i], cubic(0.1 * static_cast<double>(i)), 1e-12);
        }
    }

    void few_nodes_make_a_polynomial_of_lower_degree() {
        std::vector<double> out(3);
        interpolate_cubic(std::vector{1.0}, std::vector{7.0}, 1, 0, std::span(out).first(1));
        QCOMPARE(out[0], 7.0);
        interpolate_cubic(std::vector{0.0, 1.0}, std::vector{0.0, 2.0}, 0, 0.5, out);
        VYBEG_CLOSE(worst_difference(out, {0, 1, 2}), 0, 1e-15);
        interpolate_cubic(std::vector{0.0, 0.5, 2.0}, std::vector{0.0, 0.25, 4.0}, 0, 1, out);
        VYBEG_CLOSE(worst_difference(out, {0, 1, 4}), 0, 1e-15);
    }

    void even_times_keep_every_sample_to_the_last_bit() {
        const TimedSamples samples = samples_at(even_times(1000, 12));
        const UniformSamples grid = gridded(samples);
        QCOMPARE(grid.c, samples.c);
        QCOMPARE(grid.d, samples.d);
        QVERIFY(grid.diagnostics.empty());
    }

    void jitter_is_resampled_within_the_error_of_the_cubic() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> jitter(-0.1, 0.1);
        std::vector<double> times = even_times(5000);
        double largest = 0;
        for (std::size_t i = 1; i < times.size(); ++i) {
            const double shift = jitter(random);
            times[i] += shift / rate;
            largest = largest_of({largest, std::abs(shift)});
        }
        const UniformSamples grid = gridded(samples_at(times));
        // Standard deviation of the slope of a line through 5000 times with jitter of 0.2/sqrt(12).
        const double sd = 0.2 / std::sqrt(5000.0 * 5000.0 * 5000.0);
        VYBEG_CLOSE_RATIO(grid.rate_hz, rate, 4 * sd);

        VYBEG_AT_LEAST(grid.c.size(), 4999);
        VYBEG_AT_MOST(grid.c.size(), 5001);
        std::vector<double> at;
        for (std::size_t i = 0; i < grid.c.size(); ++i) {
            at.push_back(times[0] + static_cast<double>(i) / grid.rate_hz);
        }
        // 3/128 h^4 max|f''''| is for even nodes; inside, jitter makes the product of distances at
        // most 1.2^4 as large, and at the two ends a cubic is used outside of its middle interval.
        const double even = 3.0 / 128 * std::pow(2 * std::numbers::pi * cycles_per_sample, 4);
        const auto inside = [&](const std::vector<double>& values, double (*signal)(double)) {
            double worst = 0;
            for (std::size_t i = 2; i + 2 < values.size(); ++i) {
                worst = largest_of({worst, std::abs(values[i] - signal(at[i]))});
            }
            return worst;
        };
        VYBEG_CLOSE(inside(grid.c, signal_c), 0, 2.1 * even);
        VYBEG_CLOSE(inside(grid.d, signal_d), 0, 2.1 * 0.5 * even);
        VYBEG_CLOSE(worst_difference(grid.c, sampled(signal_c, at)), 0, 4 * even);

        QCOMPARE(grid.diagnostics.size(), 1u);
        const Diagnostic& uneven = grid.diagnostics[0];
        QCOMPARE(uneven.kind, DiagnosticKind::time_uneven);
        VYBEG_CLOSE(*parse_number(english(uneven.args.at(1))), largest, 0.01);
        VYBEG_CLOSE(*parse_number(english(uneven.args.at(0))), largest / rate, 0.01 / rate);
    }

    void deviations_are_reported_from_a_thousandth_of_a_sample_on_data() {
        QTest::addColumn<double>("shift");  // samples, of one time in the middle
        QTest::addColumn<bool>("reported");
        QTest::newRow("0.0009") << 0.0009 << false;
        QTest::newRow("-0.0009") << -0.0009 << false;
        QTest::newRow("0.0012") << 0.0012 << true;
        QTest::newRow("-0.0012") << -0.0012 << true;
    }

    void deviations_are_reported_from_a_thousandth_of_a_sample_on() {
        QFETCH(double, shift);
        QFETCH(bool, reported);
        std::vector<double> times = even_times(1000);
        times[400] += shift / rate;
        const UniformSamples grid = gridded(samples_at(times));
        QCOMPARE(!grid.diagnostics.empty(), reported);
        if (reported) {
            QCOMPARE(grid.diagnostics[0].kind, DiagnosticKind::time_uneven);
            VYBEG_WITHIN(static_cast<double>(grid.diagnostics[0].first_frame), 400, 1);
        }
    }

    void lost_samples_become_gaps_where_they_were() {
        std::vector<double> times = even_times(1000);
        std::vector<double> expected = times;
        for (const std::size_t lost : {100u, 300u, 301u, 302u}) {
            expected[lost] = no_value;
        }
        times.erase(times.begin() + 300, times.begin() + 303);
        times.erase(times.begin() + 100);
        const Folder folder;
        const Recording recording = opened(folder.write("run", text_of(times, "%.7f")));
        QCOMPARE(recording.frames(), 1000);
        QCOMPARE(worst_difference(read_all(recording).c, sampled(signal_c, expected)), 0.0);
        QCOMPARE(worst_difference(read_all(recording).d, sampled(signal_d, expected)), 0.0);
        VYBEG_CLOSE_RATIO(recording.rate_hz, rate, 1e-6);
        QCOMPARE(recording.diagnostics.size(), 2u);
        QCOMPARE(recording.diagnostics[0].kind, DiagnosticKind::time_gap);
        QCOMPARE(recording.diagnostics[0].first_frame, 100);
        QCOMPARE(recording.diagnostics[0].count, 1);
        QCOMPARE(recording.diagnostics[1].args.at(0), std::string("3"));
        VYBEG_CLOSE(*parse_number(english(recording.diagnostics[1].args.at(1))), 300 / rate, 1e-7);
        QCOMPARE(recording.diagnostics[1].first_frame, 300);
    }

    void lost_samples_of_jittered_times_become_gaps_too() {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> jitter(-0.05, 0.05);
        std::vector<double> times = even_times(2000);
        for (double& time : times) {
            time += jitter(random) / rate;
        }
        times.erase(times.begin() + 1200, times.begin() + 1210);
        const UniformSamples grid = gridded(samples_at(times));
        std::size_t first = 0;
        while (first < grid.c.size() && !std::isnan(grid.c[first])) {
            ++first;
        }
        const auto missing = std::count_if(grid.c.begin(), grid.c.end(),
                                           [](double value) { return std::isnan(value); });
        VYBEG_AT_LEAST(first, 1200);
        VYBEG_AT_MOST(first, 1201);
        VYBEG_AT_LEAST(missing, 9);
        VYBEG_AT_MOST(missing, 11);
        QCOMPARE(grid.diagnostics.size(), 2u);
        QCOMPARE(grid.diagnostics[1].kind, DiagnosticKind::time_gap);
        QCOMPARE(grid.diagnostics[1].first_frame, static_cast<std::int64_t>(first));
        QCOMPARE(grid.diagnostics[1].count, static_cast<std::int64_t>(missing));
        // The samples behind the gap are those of their own time.
        const double at = times[0] + 1500 / grid.rate_hz;
        VYBEG_CLOSE(grid.c[1500], signal_c(at), 1e-3);
    }

    void a_clock_as_coarse_as_the_sample_period_still_shows_lost_samples() {
        const auto thousand_per_second_without = [](int lost, int count) {
            const Folder folder;
            std::string text = "t,C,D\n";
            for (int i = 0; i < 500; ++i) {
                if (i < lost || i >= lost + count) {
                    text += "0." + QString("%1").arg(i, 3, 10, QChar('0')).toStdString() + "," +
                            std::to_string(i % 7) + ",1\n";
                }
            }
            return opened(folder.write("run", text));
        };
        const Recording two = thousand_per_second_without(250, 2);
        VYBEG_CLOSE_RATIO(two.rate_hz, 1000, 1e-9);
        QCOMPARE(two.frames(), 500);
        QCOMPARE(two.diagnostics.size(), 1u);
        QCOMPARE(two.diagnostics[0].first_frame, 250);
        QCOMPARE(two.diagnostics[0].count, 2);
        QVERIFY(std::isnan(read_all(two).c[250]));
        // One long step of the last digit may as well be that of a rate of 998 Hz: the deviation of
        // the rate leaves both open.
        const Recording one = thousand_per_second_without(250, 1);
        VYBEG_WITHIN(one.rate_hz, 1000, 2 * one.rate_relative_sd * one.rate_hz);
    }

    void a_clock_coarser_than_half_a_period_makes_no_gaps_of_its_own() {
        // 700 Hz with times in whole milliseconds: steps of 1 and 2 ms.
        const Folder folder;
        std::string text = "t,C,D\n";
        for (int i = 0; i < 700; ++i) {
            text += QString::number(i / 700.0, 'f', 3).toStdString() + ",0,1\n";
        }
        const Recording recording = opened(folder.write("run", text));
        QCOMPARE(recording.frames(), 700);
        QVERIFY(recording.diagnostics.empty());
        VYBEG_CLOSE_RATIO(recording.rate_hz, 700, 1e-3);  // 1 ms over 1 s
    }

    void at_most_twenty_gaps_are_listed_and_none_is_forgotten_data() {
        QTest::addColumn<int>("gaps");
        for (const int gaps : {19, 20, 21, 100}) {
            QTest::addRow("%d gaps", gaps) << gaps;
        }
    }

    void at_most_twenty_gaps_are_listed_and_none_is_forgotten() {
        QFETCH(int, gaps);
        std::vector<double> times;
        for (int i = 0; i < 10 * gaps + 10; ++i) {
            if (i % 10 != 0 || i == 0 || i > 10 * gaps) {
                times.push_back(i / rate);
            }
        }
        const UniformSamples grid = gridded(samples_at(times));
        QCOMPARE(grid.diagnostics.size(), static_cast<std::size_t>(std::min(gaps, 20)));
        std::int64_t lost = 0;
        for (const Diagnostic& gap : grid.diagnostics) {
            lost += gap.count;
        }
        QCOMPARE(lost, gaps);
        QCOMPARE(grid.diagnostics.back().first_frame, 10 * std::min(gaps, 20));
    }

    void a_missing_sample_stays_missing_at_its_own_time() {
        TimedSamples samples = samples_at(even_times(100));
        samples.d[40] = no_value;
        const UniformSamples even = gridded(samples);
        QVERIFY(std::isnan(even.d[40]));
        QCOMPARE(
            std::count_if(even.d.begin(), even.d.end(), [](double x) { return std::isnan(x); }), 1);
        // Where it had to be interpolated, it takes the two frames on either side along at most.
        samples.time_s[70] += 0.01 / rate;
        const UniformSamples uneven = gridded(samples);
        QCOMPARE(uneven.d.size(), 100u);
        QVERIFY(std::isnan(uneven.d[40]));
        for (std::size_t i = 0; i < 100; ++i) {
            QVERIFY(!std::isnan(uneven.c[i]));
            QVERIFY(!std::isnan(uneven.d[i]) || (i >= 38 && i <= 42));
        }
    }

    void no_sample_between_huge_ones_is_infinite() {
        TimedSamples samples = samples_at(even_times(30));
        for (std::size_t i = 0; i < samples.c.size(); ++i) {
            samples.time_s[i] += (i % 2 == 0 ? 0.2 : 0) * (samples.time_s[1] - samples.time_s[0]);
            samples.c[i] = i % 2 == 0 ? 1.7e308 : -1.7e308;
        }
        const auto grid = to_uniform_grid(samples, "run.csv");
        QVERIFY(grid);
        QCOMPARE(std::ranges::count_if(grid->c, [](double x) { return std::isinf(x); }), 0);
        VYBEG_MORE(std::ranges::count_if(grid->c, [](double x) { return std::isnan(x); }), 0);
    }

    void a_jump_of_the_clock_by_years_is_an_error_and_no_memory_hog() {
        std::vector<double> times = even_times(100);
        times.push_back(1e9);
        const auto grid = to_uniform_grid(samples_at(times), "run.csv");
        QVERIFY(!grid);
        QCOMPARE(grid.error().code, ErrorCode::format_limit);
        QCOMPARE(grid.error().where, std::string("run.csv"));
    }

    void the_unit_of_the_header_scales_the_time_data() {
        QTest::addColumn<QString>("header");
        QTest::addColumn<double>("unit");
        for (const char* seconds : {"t", "t [s]", "time_s", "Time (sec)", "сек"}) {
            QTest::newRow(seconds) << QString(seconds) << 1.0;
        }
        for (const char* milliseconds : {"t [ms]", "t_ms", "Время, мс"}) {
            QTest::newRow(milliseconds) << QString(milliseconds) << 1e-3;
        }
        for (const char* microseconds : {"t (us)", "t [µs]", "t [μs]", "time_us", "t, мкс"}) {
            QTest::newRow(microseconds) << QString(microseconds) << 1e-6;
        }
    }

    void the_unit_of_the_header_scales_the_time() {
        QFETCH(QString, header);
        QFETCH(double, unit);
        const Folder folder;
        std::string text = header.toStdString() + ";C;D\n";
        for (int i = 0; i < 100; ++i) {
            text += QString::number(2.5 * i).toStdString() + ";1;2\n";
        }
        const Recording recording = opened(folder.write("run", text));
        VYBEG_CLOSE(recording.rate_hz * 2.5 * unit, 1, 1e-12);
        QCOMPARE(recording.channels.size(), 2u);
    }
};

VYBEG_TEST(TestTimeGrid)

}  // namespace test_time_grid

#include "test_time_grid.moc"
