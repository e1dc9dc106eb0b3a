// The truth against what was put in, against the samples, and as a track.
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "tests/closeness.h"
#include "tests/largest_of.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace test_true_track {

using namespace vybeg;
using std::numbers::pi;

namespace {

std::span<const double> column(const Track& track, SlowVariable variable) {
    return track.values(variable);
}

}  // namespace

class TestTrueTrack : public QObject {
    Q_OBJECT

private slots:
    void a_still_wave_keeps_its_numbers_for_an_hour_data() {
        QTest::addColumn<double>("a_B");
        QTest::addColumn<double>("two_theta_A");
        QTest::addColumn<double>("alpha");
        for (const double a_B : {0.0, 0.25, -0.25}) {
            for (const double angle : {-3.0, -1.6, -0.7, 0.0, 0.3, 1.5, 2.9}) {
                for (const double alpha : {-2.8, 0.4, 1.9}) {
                    QTest::addRow("%g %g %g", a_B, angle, alpha) << a_B << angle << alpha;
                }
            }
        }
    }

    void a_still_wave_keeps_its_numbers_for_an_hour() {
        QFETCH(double, a_B);
        QFETCH(double, two_theta_A);
        QFETCH(double, alpha);
        const FreeDecay decay{
            .seconds = 3600, .a_B = a_B, .two_theta_A = two_theta_A, .alpha = alpha};
        const std::int64_t window = 333330 - 1;  // odd: the centre is a frame
        const auto track = true_track(decay, window);
        QVERIFY(track);
        QCOMPARE(track->rows(), std::size_t{360});
        // The same motion with 2theta_A in (-pi/2, pi/2].
        const double half_turns = std::ceil(two_theta_A / pi - 0.5);
        const double angle = two_theta_A - pi * half_turns;
        for (std::size_t row = 0; row < track->rows(); ++row) {
            const std::int64_t centre = static_cast<std::int64_t>(row) * window + (window - 1) / 2;
            const double turns = static_cast<double>(5300 * centre % 33333) / 33333;
            VYBEG_CLOSE(column(*track, SlowVariable::a_A)[row], 1, 1e-13);
            VYBEG_CLOSE(column(*track, SlowVariable::a_B)[row], a_B, 1e-13);
            VYBEG_CLOSE(column(*track, SlowVariable::two_theta_A)[row], angle, 1e-13);
            const double expected = alpha - pi * half_turns - 2 * pi * turns;
            VYBEG_CLOSE(std::remainder(column(*track, SlowVariable::alpha)[row] - expected, 2 * pi),
                        0, 1e-13);
            QCOMPARE(column(*track, SlowVariable::f)[row], 5300.0);
            VYBEG_CLOSE(track->time_s()[row], static_cast<double>(centre) / 33333, 1e-12);
            QCOMPARE(track->flags()[row], Flags{0});
        }
    }

    void truth_and_equation_6_give_the_samples() {
        FreeDecay decay = demo_decay();
        decay.noise = 0;
        decay.omega_rad_s = 2;  // several turns of 2theta_A
        const std::int64_t window = 61;
        const auto track = true_track(decay, window);
        const auto samples = simulate(decay, {});
        QVERIFY(track && samples);
        QCOMPARE(track->rows(), std::size_t{933324 / 61});
        double worst = 0;
        double worst_beside = 0;
        for (std::size_t row = 0; row < track->rows(); ++row) {
            const std::size_t centre = row * 61 + 30;
            const double f = column(*track, SlowVariable::f)[row];
            const double a_A = column(*track, SlowVariable::a_A)[row];
            const double a_B = column(*track, SlowVariable::a_B)[row];
            const double angle = column(*track, SlowVariable::two_theta_A)[row];
            const auto distance = [&](std::size_t frame) {
                const double seconds =
                    (static_cast<double>(frame) - static_cast<double>(centre)) / decay.rate_hz;
                const double tau = 2 * pi * f * seconds - column(*track, SlowVariable::alpha)[row];
                const double c =
                    a_A * std::cos(tau) * std::cos(angle) - a_B * std::sin(tau) * std::sin(angle);
                const double d =
                    a_A * std::cos(tau) * std::sin(angle) + a_B * std::sin(tau) * std::cos(angle);
                return std::max(std::abs(c - samples->c[frame]), std::abs(d - samples->d[frame]));
            };
            worst = test::largest_of({worst, distance(centre)});
            worst_beside =
                test::largest_of({worst_beside, distance(centre - 1), distance(centre + 1)});
        }
        VYBEG_LESS(worst, 1e-12);
        // One sample aside the slow change shows: 2 k Omega dt = 3.3e-5 of the amplitude.
        VYBEG_LESS(worst_beside, 5e-5);
    }

    void a_balanced_wave_decays_exponentially() {
        const FreeDecay decay{.a_B = -0.1, .tau_s = 7};
        const auto track = true_track(decay, 1000);
        QVERIFY(track);
        for (std::size_t row = 0; row < track->rows(); ++row) {
            const double left = std::exp(-track->time_s()[row] / 7);
            VYBEG_CLOSE(column(*track, SlowVariable::a_A)[row], left, 1e-13);
            VYBEG_CLOSE(column(*track, SlowVariable::a_B)[row], -0.1 * left, 1e-13);
        }
    }

    void a_turned_gyro_turns_the_wave_backwards_without_a_jump() {
        const FreeDecay decay{.a_B = 0.2, .omega_rad_s = 1.2};
        const auto track = true_track(decay, 3333);
        QVERIFY(track);
        const auto angle = column(*track, SlowVariable::two_theta_A);
        VYBEG_LESS(angle.back(), -5 * pi);
        for (std::size_t row = 0; row < track->rows(); ++row) {
            // d theta_A/dt = -k Omega.
            const double expected = 0.3 - 2 * 0.277 * 1.2 * track->time_s()[row];
            VYBEG_CLOSE(angle[row], expected, 1e-12);
            const double alpha = column(*track, SlowVariable::alpha)[row];
            VYBEG_MORE(alpha, -pi);
            VYBEG_AT_MOST(alpha, pi);
        }
    }

    void a_split_makes_the_quadrature_grow_at_the_rate_of_the_method() {
        const FreeDecay decay{.seconds = 0.2, .split_hz = 1e-3, .theta_w = -0.2};
        const auto track = true_track(decay, 101);
        QVERIFY(track);
        // da_B/dt = pi split a_A sin 4(theta_A - theta_w), METHOD section 8.
        const double rate = pi * 1e-3 * std::sin(2 * 0.3 + 4 * 0.2);
        for (std::size_t row = 0; row < track->rows(); ++row) {
            const double grown = column(*track, SlowVariable::a_B)[row];
            VYBEG_CLOSE(grown, rate * track->time_s()[row], 1e-6);
        }
        VYBEG_MORE(column(*track, SlowVariable::a_B).back(), 5e-4);
    }

    void the_frequency_is_that_of_the_mode_along_which_the_wave_stands() {
        FreeDecay decay{.two_theta_A = 2 * 0.15, .split_hz = 0.5, .theta_w = 0.15};
        auto track = true_track(decay, 60);
        QVERIFY(track);
        VYBEG_CLOSE(column(*track, SlowVariable::f).back(), 5300.25, 1e-9);
        decay.theta_w += pi / 4;
        track = true_track(decay, 60);
        QVERIFY(track);
        VYBEG_CLOSE(column(*track, SlowVariable::f).back(), 5299.75, 1e-9);
    }

    void the_phase_difference_has_the_sign_of_minus_the_quadrature() {
        FreeDecay decay{.two_theta_A = 0.7};
        for (const double a_B : {0.3, -0.3}) {
            decay.a_B = a_B;
            const auto track = true_track(decay, 60);
            QVERIFY(track);
            // tan(phi_D) - form of (6): C = A cos tau - B sin tau, D = E cos tau + F sin tau.
            const double phi_c = std::atan2(-a_B * std::sin(0.7), std::cos(0.7));
            const double phi_d = std::atan2(a_B * std::cos(0.7), std::sin(0.7));
            const double difference = column(*track, SlowVariable::delta_phi_CD)[100];
            VYBEG_CLOSE(difference, phi_c - phi_d, 1e-13);
            VYBEG_LESS(difference * a_B, 0);
        }
    }

    void a_circular_wave_has_no_angle() {
        const FreeDecay decay{.a_B = -1};
        const auto track = true_track(decay, 60);
        QVERIFY(track);
        for (std::size_t row = 0; row < track->rows(); ++row) {
            QVERIFY(has(track->flags()[row], Flag::circular));
            QVERIFY(std::isnan(column(*track, SlowVariable::two_theta_A)[row]));
            QVERIFY(std::isnan(column(*track, SlowVariable::alpha)[row]));
            VYBEG_CLOSE(column(*track, SlowVariable::a_B)[row], -1, 1e-13);
        }
    }

    void the_demo_swings_its_quadrature_and_crosses_a_pick_off_axis() {
        const FreeDecay decay = demo_decay();
        const auto track = true_track(decay, 60);
        QVERIFY(track);
        QCOMPARE(track->rows(), std::size_t{15555});
        const auto a_B = column(*track, SlowVariable::a_B);
        const auto angle = column(*track, SlowVariable::two_theta_A);
        std::size_t peak = 0;
        std::size_t crossing = 0;
        double largest = 0;
        for (std::size_t row = 0; row < track->rows(); ++row) {
            const double ratio = a_B[row] / column(*track, SlowVariable::a_A)[row];
            if (ratio > largest) {
                largest = ratio;
                peak = row;
            }
            if (row > 0) {
                VYBEG_LESS(angle[row], angle[row - 1]);
            }
            crossing = angle[row] > 0 ? row : crossing;
        }
        VYBEG_MORE(largest, 0.28);
        VYBEG_LESS(largest, 0.32);
        VYBEG_MORE(track->time_s()[peak], 10);
        VYBEG_LESS(track->time_s()[peak], 16);
        VYBEG_LESS(a_B.back(), 0);
        VYBEG_MORE(track->time_s()[crossing], 4);
        VYBEG_LESS(track->time_s()[crossing], 10);
        QCOMPARE(decay.noise, 1e-3);
        QCOMPARE(column(*track, SlowVariable::rms)[0], std::numbers::sqrt2 * 1e-3);
    }

    void a_window_that_does_not_fit_is_refused() {
        for (const std::int64_t window : {std::int64_t{0}, std::int64_t{933325}}) {
            const auto track = true_track(FreeDecay{}, window);
            QVERIFY(!track);
            QCOMPARE(track.error().code, ErrorCode::simulation_impossible);
        }
    }
};

VYBEG_TEST(TestTrueTrack)

}  // namespace test_true_track

#include "test_true_track.moc"
