#include "core/track/trend.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QTest>

#include <array>
#include <cmath>
#include <random>

namespace test_polynomial_trend {

using namespace vybeg;

namespace {

constexpr double hop_s = 0.05;
constexpr double start_s = 1000;

template <class Value>
Track track_of(std::size_t rows, double sd, Value value) {
    Track track(rows);
    for (std::size_t k = 0; k < rows; ++k) {
        const double time_s = hop_s * static_cast<double>(k);
        track.time_s()[k] = start_s + time_s;
        track.values(SlowVariable::f)[k] = value(time_s);
        track.sds(SlowVariable::f)[k] = sd;
        track.flags()[k] = 0;
    }
    return track;
}

std::optional<PolynomialTrend> trend_of(const Track& track, int degree) {
    return polynomial_trend(track, SlowVariable::f, start_s, start_s + 1e6, 1, degree);
}

}  // namespace

class TestPolynomialTrend : public QObject {
    Q_OBJECT

private slots:
    void a_cubic_without_noise_is_found_exactly() {
        const Track track = track_of(401, 1e-4, [](double t) {
            const double u = t - 10;
            return 5300 + 2e-3 * u - 3e-4 * u * u + 5e-5 * u * u * u;
        });
        const auto trend = trend_of(track, 3);
        QVERIFY(trend);
        VYBEG_CLOSE_RATIO(trend->centre_s, start_s + 10, 1e-12);
        VYBEG_CLOSE_RATIO(trend->coefficient[0], 5300.0, 1e-14);
        VYBEG_CLOSE_RATIO(trend->coefficient[1], 2e-3, 1e-8);
        VYBEG_CLOSE_RATIO(trend->coefficient[2], -3e-4, 1e-8);
        VYBEG_CLOSE_RATIO(trend->coefficient[3], 5e-5, 1e-8);
        VYBEG_CLOSE_RATIO(trend->at(start_s + 20), 5300 + 2e-2 - 3e-2 + 5e-2, 1e-14);
        QCOMPARE(trend->windows, std::size_t{401});
    }

    // Of the first degree it is the line of trend.h, whose formulas are others.
    void the_first_degree_is_the_line() {
        std::mt19937_64 random(3);
        std::normal_distribution<double> noise(0, 1e-3);
        const Track track = track_of(200, 1e-3, [&](double t) { return 2e-3 * t + noise(random); });
        const auto trend = trend_of(track, 1);
        const auto line = line_trend(track, SlowVariable::f, start_s, start_s + 1e6, 1);
        QVERIFY(trend && line);
        VYBEG_CLOSE_RATIO(trend->coefficient[1], line->slope_per_s, 1e-9);
        VYBEG_CLOSE_RATIO(trend->sd[1], line->sd_slope_per_s, 1e-9);
        VYBEG_CLOSE_RATIO(trend->chi2_per_dof, line->chi2_per_dof, 1e-9);
    }

    // Pulls over 200 seeds: rms within 0.85 to 1.15, three deviations of its own scatter (5 %).
    void the_deviations_are_those_of_the_scatter_data() {
        QTest::addColumn<int>("degree");
        QTest::newRow("parabola") << 2;
        QTest::newRow("cubic") << 3;
    }
    void the_deviations_are_those_of_the_scatter() {
        QFETCH(int, degree);
        constexpr int seeds = 200;
        constexpr std::array truth{5301.0, -2e-3, 4e-4, 3e-5};
        std::array<double, 4> squares{};
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            std::mt19937_64 random(seed);
            std::normal_distribution<double> noise(0, 1e-3);
            const Track track = track_of(301, 1e-3, [&](double t) {
                const double u = t - 7.5;
                return truth[0] + truth[1] * u + truth[2] * u * u +
                       (degree == 3 ? truth[3] * u * u * u : 0) + noise(random);
            });
            const auto trend = trend_of(track, degree);
            QVERIFY(trend);
            for (int k = 0; k <= degree; ++k) {
                const auto at = static_cast<std::size_t>(k);
                squares.at(at) +=
                    std::pow((trend->coefficient[at] - truth.at(at)) / trend->sd[at], 2);
            }
        }
        for (int k = 0; k <= degree; ++k) {
            VYBEG_WITHIN(std::sqrt(squares.at(static_cast<std::size_t>(k)) / seeds), 1.0, 0.15);
        }
    }

    // A parabola where the truth is cubic: the windows leave it, and the deviations say so.
    void what_leaves_the_polynomial_enlarges_the_deviations() {
        const Track track =
            track_of(400, 1e-4, [](double t) { return 1e-4 * std::pow(t - 10, 3); });
        const auto parabola = trend_of(track, 2);
        const auto cubic = trend_of(track, 3);
        QVERIFY(parabola && cubic);
        VYBEG_MORE(parabola->enlargement, 10);
        VYBEG_CLOSE(cubic->enlargement, 1.0, 1e-12);
    }

    void fewer_points_than_coefficients_and_one_give_none() {
        for (int degree = 1; degree <= most_trend_degree; ++degree) {
            const auto least = static_cast<std::size_t>(degree) + 2;
            QVERIFY(!trend_of(track_of(least - 1, 1e-3, [](double t) { return t; }), degree));
            QVERIFY(trend_of(track_of(least, 1e-3, [](double t) { return t; }), degree));
        }
    }
};

VYBEG_TEST(TestPolynomialTrend)

}  // namespace test_polynomial_trend

#include "test_polynomial_trend.moc"
