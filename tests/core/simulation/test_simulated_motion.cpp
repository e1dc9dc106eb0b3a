// Motion whose frequency drifts, settles or depends on the power, against the oscillator's own
// second-order equations, against Runge-Kutta, and against its own steps halved.
#include "core/simulation/decay_motion.h"
#include "core/simulation/simulate.h"
#include "tests/closeness.h"
#include "tests/largest_of.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <numbers>

namespace test_simulated_motion {

using namespace vybeg;
using std::numbers::pi;

namespace {

// x, y, dx/dt, dy/dt of a point on a plane.
using State = std::array<double, 4>;

// x'' = -w^2 x - K |x|^2 x - 2 (1/tau + k (|x|^2 + |x'|^2/w^2)) x'. The averaged
// motion has b = 3 K / (16 pi w), and |x|^2 + |x'|^2/w^2 = |z|^2.
struct Oscillator {
    double w;
    double spring;  // K
    double decay;   // 1/tau
    double by_power;

    State slope(const State& s) const {
        const double square = s[0] * s[0] + s[1] * s[1];
        const double power = square + (s[2] * s[2] + s[3] * s[3]) / (w * w);
        const double back = w * w + spring * square;
        const double drag = 2 * (decay + by_power * power);
        return {s[2], s[3], -back * s[0] - drag * s[2], -back * s[1] - drag * s[3]};
    }

    void step(State& s, double h) const {
        const auto along = [&s](const State& slope, double by) {
            State to = s;
            for (std::size_t i = 0; i < 4; ++i) {
                to[i] += by * slope[i];
            }
            return to;
        };
        const State a = slope(s);
        const State b = slope(along(a, h / 2));
        const State c = slope(along(b, h / 2));
        const State d = slope(along(c, h));
        for (std::size_t i = 0; i < 4; ++i) {
            s[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
        }
    }
};

FreeDecay by_power(double b, double k) {
    FreeDecay decay{.seconds = 5,
                    .rate_hz = 8000,
                    .f0_hz = 1000,
                    .frequency_per_power_hz = b,
                    .damping_per_power_per_s = k};
    return decay;
}

}  // namespace

class TestSimulatedMotion : public QObject {
    Q_OBJECT

private slots:
    void a_cubic_spring_and_damping_by_power_are_those_of_the_oscillator_data() {
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("k");
        QTest::addColumn<double>("a_B");
        QTest::addColumn<double>("angle");
        for (const double angle : {0.3, -1.9}) {
            QTest::addRow("stiffer, straight, %g", angle) << 0.02 << 0.0 << 0.0 << angle;
            QTest::addRow("softer, ellipse, %g", angle) << -0.02 << 0.0 << 0.4 << angle;
            QTest::addRow("stiffer, ellipse the other way, %g", angle)
                << 0.02 << 0.0 << -0.3 << angle;
            QTest::addRow("damping, ellipse, %g", angle) << 0.0 << 0.05 << 0.3 << angle;
            QTest::addRow("both, %g", angle) << 0.02 << 0.05 << 0.3 << angle;
        }
    }

    // The averaged motion leaves out what is of second order in b/f0 = 2e-5: in 2e4 rad of phase
    // some 1e-5, and a third harmonic of the order of 1e-5. The effects themselves are 0.1 to 0.4.
    void a_cubic_spring_and_damping_by_power_are_those_of_the_oscillator() {
        QFETCH(double, b);
        QFETCH(double, k);
        QFETCH(double, a_B);
        QFETCH(double, angle);
        FreeDecay decay = by_power(b, k);
        decay.a_B = a_B;
        decay.two_theta_A = angle;
        decay.seconds = 3;
        decay.tau_s = 20;
        const auto samples = simulate(decay, {});
        QVERIFY(bool(samples));
        const double w0 = 2 * pi * decay.f0_hz;
        // A damped oscillator rings at sqrt(w^2 - 1/tau^2).
        const double w = std::hypot(w0, 1 / decay.tau_s);
        const Oscillator oscillator{w, 16 * pi * b * w / 3, 1 / decay.tau_s, k};
        const double power = 1 + a_B * a_B;
        // Slow changes of z move the velocity by their share of w.
        const SlowMotion linear(decay);
        const Eigen::Vector2cd z = linear.start();
        const double drag = 1 / decay.tau_s + k * power;
        const std::complex<double> square = z(0) * z(0) + z(1) * z(1);
        const std::complex<double> i{0, 1};
        State state{};
        for (int n = 0; n < 2; ++n) {
            const std::complex<double> slope =
                i * w0 * z(n) - drag * z(n) +
                i * (2 * pi * b / 3) * (2 * power * z(n) + square * std::conj(z(n)));
            const auto at = static_cast<std::size_t>(n);
            state[at] = z(n).real();
            state[at + 2] = slope.real();
        }
        double worst = 0;
        for (std::size_t frame = 0; frame < samples->c.size(); ++frame) {
            worst = test::largest_of({worst, std::abs(state[0] - samples->c[frame]),
                                      std::abs(state[1] - samples->d[frame])});
            for (int part = 0; part < 40; ++part) {
                oscillator.step(state, 1 / decay.rate_hz / 40);
            }
        }
        VYBEG_LESS(worst, 1e-4);
        decay.frequency_per_power_hz = decay.damping_per_power_per_s = 0;
        const auto without = simulate(decay, {});
        QVERIFY(bool(without));
        double effect = 0;
        for (std::size_t frame = 0; frame < samples->c.size(); ++frame) {
            effect = std::max({effect, std::abs(without->c[frame] - samples->c[frame]),
                               std::abs(without->d[frame] - samples->d[frame])});
        }
        VYBEG_MORE(effect, 0.05);
    }

    void the_cubic_precession_has_its_sign_and_size_data() {
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("a_B");
        for (const double b : {0.03, -1.0}) {
            for (const double a_B : {0.3, -0.1}) {
                QTest::addRow("b %g, a_B %g", b, a_B) << b << a_B;
            }
        }
    }

    // d theta_A/dt = -(2 pi b/3) a_A a_B, f = f0 + b (a_A^2 + a_B^2 - ...): for a still ellipse
    // Im(z^H dz/dt)/(2 pi |z|^2) = (b/3) (2 |z|^2 + |z.z|^2/|z|^2).
    void the_cubic_precession_has_its_sign_and_size() {
        QFETCH(double, b);
        QFETCH(double, a_B);
        FreeDecay decay = by_power(b, 0);
        decay.a_B = a_B;
        const auto truth = true_track(decay, 41);
        QVERIFY(bool(truth));
        const double rate = -(2 * pi * b / 3) * 1 * a_B;
        const double power = 1 + a_B * a_B;
        const double line = 1 - a_B * a_B;
        const double f = decay.f0_hz + b / 3 * (2 * power + line * line / power);
        for (std::size_t row = 0; row < truth->rows(); ++row) {
            VYBEG_CLOSE(truth->values(SlowVariable::two_theta_A)[row],
                        decay.two_theta_A + 2 * rate * truth->time_s()[row], 1e-11);
            VYBEG_CLOSE(truth->values(SlowVariable::f)[row], f, 1e-9);
            VYBEG_CLOSE(truth->values(SlowVariable::a_A)[row], 1.0, 1e-12);
            VYBEG_CLOSE(truth->values(SlowVariable::a_B)[row], a_B, 1e-12);
        }
    }

    // d|z|^2/dt = -2 |z|^2/tau - 2 k |z|^4: |z|^2 = P e^{-2t/tau} / (1 + k P tau (1 -
    // e^{-2t/tau})).
    void damping_by_power_has_its_closed_form() {
        for (const double k : {0.05, 3.0, -0.03}) {
            FreeDecay decay = by_power(0.5, k);
            decay.tau_s = 7;
            decay.seconds = 30;
            decay.a_B = -0.25;
            const auto truth = true_track(decay, 801);
            QVERIFY(bool(truth));
            const double power = 1 + 0.0625;
            for (std::size_t row = 0; row < truth->rows(); ++row) {
                const double gone = -std::expm1(-2 * truth->time_s()[row] / 7);
                const double left = power * (1 - gone) / (1 + k * power * 7 * gone);
                const double a_A = truth->values(SlowVariable::a_A)[row];
                const double a_B = truth->values(SlowVariable::a_B)[row];
                VYBEG_CLOSE((a_A * a_A + a_B * a_B) / left, 1.0, 1e-11);
                VYBEG_CLOSE(a_B / a_A, -0.25, 1e-11);
            }
        }
    }

    void half_steps_give_the_same_motion() {
        for (const double b : {0.01, 5.0}) {
            for (const double k : {0.0, 0.4}) {
                FreeDecay decay = by_power(b, k);
                decay.split_hz = 1;
                decay.theta_w = 0.2;
                decay.tau_s = 50;
                decay.damping_anisotropy_per_s = 0.01;
                decay.omega_rad_s = 0.5;
                decay.a_B = 0.3;
                const SlowMotion linear(decay);
                PowerMotion whole(decay, linear.matrix(), linear.start());
                PowerMotion half(decay, linear.matrix(), linear.start(), 0.05);
                double worst = 0;
                for (int n = 0; n < 3000; ++n) {
                    const double t = 0.01 * n;
                    const Eigen::Vector2cd z = half.at(t);
                    worst = test::largest_of({worst, (whole.at(t) - z).norm() / z.norm()});
                }
                VYBEG_LESS(worst, 1e-10);
            }
        }
    }

    void without_dependence_on_power_the_series_are_the_matrix_exponential() {
        FreeDecay decay = demo_decay();
        decay.split_hz = 0.7;
        const SlowMotion linear(decay);
        PowerMotion motion(decay, linear.matrix(), linear.start());
        double worst = (motion.at(-0.3) - linear.propagator(-0.3) * linear.start()).norm();
        for (int n = 0; n < 1000; ++n) {
            const double t = -0.25 + 0.1 * n;
            worst = test::largest_of(
                {worst, (motion.at(t) - linear.propagator(t) * linear.start()).norm()});
        }
        VYBEG_LESS(worst, 1e-12);
    }

    void runge_kutta_gives_the_same_motion_with_all_terms() {
        FreeDecay decay = by_power(0.8, 0.1);
        decay.split_hz = 0.5;
        decay.theta_w = -0.3;
        decay.tau_s = 4;
        decay.damping_anisotropy_per_s = 0.1;
        decay.theta_tau = 0.5;
        decay.omega_rad_s = -1;
        decay.a_B = 0.35;
        const SlowMotion linear(decay);
        PowerMotion motion(decay, linear.matrix(), linear.start());
        const auto slope = [&](const Eigen::Vector2cd& z) {
            const std::complex<double> i{0, 1};
            const double power = std::norm(z(0)) + std::norm(z(1));
            const std::complex<double> square = z(0) * z(0) + z(1) * z(1);
            Eigen::Vector2cd rate = linear.matrix() * z - 0.1 * power * z;
            rate += i * (2 * pi * 0.8 / 3) * (2 * power * z + square * z.conjugate());
            return rate;
        };
        Eigen::Vector2cd z = linear.start();
        const double h = 1e-4;
        double worst = 0;
        for (int n = 0; n < 50000; ++n) {
            worst = test::largest_of({worst, (motion.at(n * h) - z).norm()});
            const Eigen::Vector2cd a = slope(z);
            const Eigen::Vector2cd b = slope(z + h / 2 * a);
            const Eigen::Vector2cd c = slope(z + h / 2 * b);
            const Eigen::Vector2cd d = slope(z + h * c);
            z += h / 6 * (a + 2 * b + 2 * c + d);
        }
        VYBEG_LESS(worst, 1e-11);
    }

    void frequency_settles_and_drifts_by_its_integral() {
        for (const double angle : {0.3, 1.4}) {
            const FreeDecay decay{.two_theta_A = angle,
                                  .frequency_drift_hz_s = 0.02,
                                  .settling_hz = -0.01,
                                  .settling_time_s = 3};
            const auto samples = simulate(decay, {});
            const auto truth = true_track(decay, 60);
            QVERIFY(samples && truth);
            double worst = 0;
            for (std::size_t k = 0; k < samples->c.size(); ++k) {
                const double t = static_cast<double>(k) / decay.rate_hz;
                const double turns = static_cast<double>(5300 * k % 33333) / 33333 + 0.01 * t * t -
                                     0.03 * (1 - std::exp(-t / 3));
                const double wave = std::cos(2 * pi * turns - decay.alpha);
                worst = test::largest_of({worst, std::abs(std::cos(angle) * wave - samples->c[k]),
                                          std::abs(std::sin(angle) * wave - samples->d[k])});
            }
            VYBEG_LESS(worst, 1e-12);
            for (std::size_t row = 0; row < truth->rows(); ++row) {
                const double t = truth->time_s()[row];
                VYBEG_CLOSE(truth->values(SlowVariable::f)[row],
                            5300 + 0.02 * t - 0.01 * std::exp(-t / 3), 1e-11);
            }
        }
    }

    void an_hour_of_drift_keeps_its_phase() {
        const FreeDecay decay{.seconds = 3600,
                              .rate_hz = 1000,
                              .f0_hz = 100,
                              .two_theta_A = 0,
                              .alpha = 0,
                              .frequency_drift_hz_s = 0.0625};
        const auto samples = simulate(decay, {});
        QVERIFY(bool(samples));
        double worst = 0;
        for (std::size_t k = samples->c.size() - 10000; k < samples->c.size(); ++k) {
            // 0.0625/2 (k/1000)^2 = k^2 / 32e6 turns, in whole numbers.
            const double turns = static_cast<double>(100 * k % 1000) / 1000 +
                                 static_cast<double>(k * k % 32'000'000) / 32e6;
            worst = test::largest_of({worst, std::abs(std::cos(2 * pi * turns) - samples->c[k])});
        }
        VYBEG_LESS(worst, 1e-12);
    }

    void the_truth_gives_the_samples_and_the_frequency_of_them() {
        FreeDecay decay = demo_decay();
        decay.noise = 0;
        decay.frequency_per_power_hz = 1.5;
        decay.damping_per_power_per_s = 0.02;
        decay.frequency_drift_hz_s = 0.05;
        decay.settling_hz = 0.3;
        decay.settling_time_s = 4;
        decay.a_B = 0.2;
        const auto truth = true_track(decay, 61);
        const auto samples = simulate(decay, {});
        QVERIFY(truth && samples);
        double worst = 0;
        double worst_turn = 0;
        for (std::size_t row = 0; row < truth->rows(); ++row) {
            const double a_A = truth->values(SlowVariable::a_A)[row];
            const double a_B = truth->values(SlowVariable::a_B)[row];
            const double angle = truth->values(SlowVariable::two_theta_A)[row];
            const double alpha = truth->values(SlowVariable::alpha)[row];
            const std::size_t centre = row * 61 + 30;
            // Equation (6) at tau = -alpha.
            const double c =
                a_A * std::cos(alpha) * std::cos(angle) + a_B * std::sin(alpha) * std::sin(angle);
            const double d =
                a_A * std::cos(alpha) * std::sin(angle) - a_B * std::sin(alpha) * std::cos(angle);
            worst = std::max(
                {worst, std::abs(c - samples->c[centre]), std::abs(d - samples->d[centre])});
            // The power-weighted rate is d(-alpha)/dt + (2 a_A a_B/|z|^2) d(2theta_A)/dt.
            if (row > 0) {
                const double f = (truth->values(SlowVariable::f)[row] +
                                  truth->values(SlowVariable::f)[row - 1]) /
                                 2;
                const double turn = angle - truth->values(SlowVariable::two_theta_A)[row - 1];
                const double share = 2 * a_A * a_B / (a_A * a_A + a_B * a_B);
                const double expected = 2 * pi * f * 61 / decay.rate_hz;
                const double gone =
                    -(alpha - truth->values(SlowVariable::alpha)[row - 1]) + share * turn;
                worst_turn =
                    test::largest_of({worst_turn, std::abs(std::remainder(gone - expected, pi))});
            }
        }
        VYBEG_LESS(worst, 1e-11);
        // The trapezoid's rest is f'' h^3/12 and the share's change in a window times the turn.
        VYBEG_LESS(worst_turn, 1e-5);
    }

    void it_streams() {
        FreeDecay decay = by_power(1, 0.1);
        decay.delay_d_s = 1e-4;
        decay.phase_noise_rad = 1e-3;
        const auto whole = simulate(decay, {});
        std::size_t taken = 0;
        std::size_t longest = 0;
        bool same = true;
        const DecaySink sink = [&](std::span<const double> c, std::span<const double> d) {
            for (std::size_t k = 0; k < c.size(); ++k) {
                same = same && c[k] == whole->c[taken + k] && d[k] == whole->d[taken + k];
            }
            taken += c.size();
            longest = std::max(longest, c.size());
            return Status();
        };
        QVERIFY(bool(whole));
        QVERIFY(bool(simulate(decay, 0, sink, {})));
        QCOMPARE(taken, whole->c.size());
        QVERIFY(same);
        VYBEG_AT_MOST(longest, 20'000);
    }
};

VYBEG_TEST(TestSimulatedMotion)

}  // namespace test_simulated_motion

#include "test_simulated_motion.moc"
