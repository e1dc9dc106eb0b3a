#include "core/track/trend.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace test_trend {

using namespace vybeg;

namespace {

constexpr double hop_s = 0.01;

// Windows every 10 ms from 100 s on; `value` of the seconds since then, all with one deviation.
template <class Value>
Track track_of(SlowVariable variable, std::size_t rows, double sd, Value value) {
    Track track(rows);
    for (std::size_t k = 0; k < rows; ++k) {
        const double time_s = hop_s * static_cast<double>(k);
        track.time_s()[k] = 100 + time_s;
        track.values(variable)[k] = value(time_s);
        track.sds(variable)[k] = sd;
        track.flags()[k] = 0;
    }
    return track;
}

bool near(double found, double expected, double relative) {
    return std::abs(found - expected) <= relative * std::abs(expected);
}

}  // namespace

class TestTrend : public QObject {
    Q_OBJECT

private slots:
    // sd of a slope: sd / sqrt(sum (t - mean)^2); of n even times h apart, h^2 n (n^2 - 1)/12.
    void a_line_is_found_with_the_deviations_of_least_squares() {
        const Track track =
            track_of(SlowVariable::f, 1001, 2e-4, [](double t) { return 5300 + 3e-4 * t; });
        const auto trend = line_trend(track, SlowVariable::f, 101, 103, 1);
        QVERIFY(trend);
        QCOMPARE(trend->windows, std::size_t{201});
        QVERIFY(near(trend->centre_s, 102, 1e-12));
        QVERIFY(near(trend->value, 5300 + 6e-4, 1e-13));
        QVERIFY(near(trend->slope_per_s, 3e-4, 1e-6));
        QVERIFY(near(trend->sd_value, 2e-4 / std::sqrt(201.0), 1e-9));
        const double spread = hop_s * hop_s * 201 * (201.0 * 201 - 1) / 12;
        QVERIFY(near(trend->sd_slope_per_s, 2e-4 / std::sqrt(spread), 1e-9));
        VYBEG_LESS(trend->chi2_per_dof, 1e-6);
    }

    void windows_that_overlap_count_once() {
        const Track track =
            track_of(SlowVariable::a_B, 1000, 1e-3, [](double t) { return 2e-3 * t; });
        QCOMPARE(windows_apart(60, 60), std::size_t{1});
        QCOMPARE(windows_apart(60, 7), std::size_t{9});
        QCOMPARE(windows_apart(60, 100), std::size_t{1});
        const auto every = line_trend(track, SlowVariable::a_B, 100, 200, 1);
        const auto ninth = line_trend(track, SlowVariable::a_B, 100, 200, 9);
        QVERIFY(every && ninth);
        QCOMPARE(ninth->windows, std::size_t{112});
        QVERIFY(near(ninth->sd_value / every->sd_value, std::sqrt(1000.0 / 112), 1e-9));
        QVERIFY(near(ninth->slope_per_s, 2e-3, 1e-9));
    }

    void the_logarithm_gives_the_decay_time() {
        const Track track =
            track_of(SlowVariable::a_A, 500, 1e-6, [](double t) { return 2 * std::exp(-t / 400); });
        const auto trend = line_trend(track, SlowVariable::a_A, 100, 200, 1, TrendOf::logarithm);
        QVERIFY(trend);
        const auto decay = decay_time(*trend);
        QVERIFY(decay);
        QVERIFY(near(decay->tau_s, 400, 1e-9));
        QVERIFY(near(decay->sd_s, 400 * 400 * trend->sd_slope_per_s, 1e-9));
        Trend still = *trend;
        still.sd_slope_per_s = -still.slope_per_s;
        QVERIFY(!decay_time(still));
        still.slope_per_s = -still.slope_per_s;
        QVERIFY(!decay_time(still));
    }

    // Slow noise that single windows do not show: the slope's scatter over many seeds is within its
    // deviation, which is several times that of white noise.
    void slow_noise_enlarges_the_deviations() {
        double squares = 0;
        constexpr int seeds = 100;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            std::mt19937_64 random(seed);
            std::normal_distribution<double> noise;
            double slow = 0;
            const Track track = track_of(SlowVariable::a_B, 2000, 1e-3, [&](double) {
                slow = 0.95 * slow + 1e-4 * noise(random);
                return slow + 1e-3 * noise(random);
            });
            const auto trend = line_trend(track, SlowVariable::a_B, 100, 200, 1);
            QVERIFY(trend);
            VYBEG_MORE(trend->enlargement, 1.3);
            squares += std::pow(trend->slope_per_s / trend->sd_slope_per_s, 2);
        }
        const double rms = std::sqrt(squares / seeds);
        VYBEG_MORE(rms, 0.8);
        VYBEG_LESS(rms, 1.25);
    }

    // A curve: the deviation of the slope grows to the size of what a line leaves.
    void a_curve_is_no_line() {
        const Track track =
            track_of(SlowVariable::a_A, 1000, 1e-4, [](double t) { return 1 - 1e-3 * t * t; });
        const auto trend = line_trend(track, SlowVariable::a_A, 100, 200, 1);
        QVERIFY(trend);
        VYBEG_MORE(trend->enlargement, 10);
    }

    void a_scatter_above_the_deviations_enlarges_them() {
        const Track track = track_of(SlowVariable::a_B, 1000, 1e-3, [](double t) {
            return std::llround(t / hop_s) % 2 == 0 ? 3e-3 : -3e-3;
        });
        const auto trend = line_trend(track, SlowVariable::a_B, 100, 200, 1);
        QVERIFY(trend);
        QVERIFY(near(trend->chi2_per_dof, 9, 0.01));
        QVERIFY(near(trend->sd_value, 3e-3 / std::sqrt(1000.0), 0.01));
    }

    void windows_without_a_value_or_disturbed_do_not_count() {
        Track track = track_of(SlowVariable::a_B, 100, 1e-3, [](double t) { return t; });
        track.values(SlowVariable::a_B)[10] = std::numeric_limits<double>::quiet_NaN();
        track.values(SlowVariable::a_B)[20] = 1e9;
        set(track.flags()[20], Flag::clipped);
        track.values(SlowVariable::a_B)[30] = 1e9;
        set(track.flags()[30], Flag::gap);
        set(track.flags()[40], Flag::no_quadrature);
        const auto trend = line_trend(track, SlowVariable::a_B, 0, 200, 1);
        QVERIFY(trend);
        QCOMPARE(trend->windows, std::size_t{97});
        QVERIFY(near(trend->slope_per_s, 1, 1e-9));
    }

    void a_wrapped_angle_goes_on_beyond_a_turn() {
        const Track track = track_of(SlowVariable::delta_phi_CD, 1000, 1e-3, [](double t) {
            return std::remainder(3 + 2 * t, 2 * std::numbers::pi);
        });
        const auto trend = line_trend(track, SlowVariable::delta_phi_CD, 100, 200, 1);
        QVERIFY(trend);
        QVERIFY(near(trend->slope_per_s, 2, 1e-9));
    }

    void too_few_windows_or_no_deviation_give_none() {
        const Track track = track_of(SlowVariable::a_B, 100, 1e-3, [](double t) { return t; });
        QVERIFY(line_trend(track, SlowVariable::a_B, 100, 100.02, 1));
        QVERIFY(!line_trend(track, SlowVariable::a_B, 100, 100.019, 1));
        QVERIFY(!line_trend(track, SlowVariable::a_B, 300, 400, 1));
        QVERIFY(!line_trend(track, SlowVariable::noise, 100, 101, 1));
        const Track negative = track_of(SlowVariable::a_B, 100, 1e-3, [](double) { return -1.0; });
        QVERIFY(!line_trend(negative, SlowVariable::a_B, 100, 101, 1, TrendOf::logarithm));
    }
};

VYBEG_TEST(TestTrend)

}  // namespace test_trend

#include "test_trend.moc"
