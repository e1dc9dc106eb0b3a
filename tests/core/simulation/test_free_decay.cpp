// The noiseless samples of the simulator against three descriptions of the same motion that share
// no formula with it.
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "tests/closeness.h"
#include "tests/largest_of.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <stop_token>

namespace test_free_decay {

using namespace vybeg;
using std::numbers::pi;

namespace {

using Complex = std::complex<double>;
using Pair = std::array<Complex, 2>;

// Phasors at t = 0 from equation (6) at the phases 0 and pi/2.
Pair start_phasors(const FreeDecay& decay) {
    const auto signal = [&decay](double phase) {
        const double tau = phase - decay.alpha;
        const double cosine = std::cos(decay.two_theta_A);
        const double sine = std::sin(decay.two_theta_A);
        return std::array{decay.a_A * std::cos(tau) * cosine - decay.a_B * std::sin(tau) * sine,
                          decay.a_A * std::cos(tau) * sine + decay.a_B * std::sin(tau) * cosine};
    };
    const auto now = signal(0);
    const auto later = signal(pi / 2);
    return {Complex{now[0], -later[0]}, Complex{now[1], -later[1]}};
}

// dz/dt = M z as written in METHOD section 8, term by term.
Pair rate_of_change(const FreeDecay& decay, const Pair& z) {
    const auto sigma = [&z](double x) {
        return Pair{std::cos(4 * x) * z[0] + std::sin(4 * x) * z[1],
                    std::sin(4 * x) * z[0] - std::cos(4 * x) * z[1]};
    };
    const Pair stiffness = sigma(decay.theta_w);
    const Pair damping = sigma(decay.theta_tau);
    const Complex half_split{0, 2 * pi * decay.split_hz / 2};
    const double half_damping = decay.damping_anisotropy_per_s / 2;
    const double r = 2 * decay.bryan * decay.omega_rad_s;
    return {-z[0] / decay.tau_s + half_split * stiffness[0] - half_damping * damping[0] + r * z[1],
            -z[1] / decay.tau_s + half_split * stiffness[1] - half_damping * damping[1] - r * z[0]};
}

Pair along(const Pair& z, const Pair& slope, double step) {
    return {z[0] + step * slope[0], z[1] + step * slope[1]};
}

void runge_kutta_step(const FreeDecay& decay, Pair& z, double h) {
    const Pair k1 = rate_of_change(decay, z);
    const Pair k2 = rate_of_change(decay, along(z, k1, h / 2));
    const Pair k3 = rate_of_change(decay, along(z, k2, h / 2));
    const Pair k4 = rate_of_change(decay, along(z, k3, h));
    for (std::size_t i = 0; i < 2; ++i) {
        z[i] += h / 6 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
    }
}

// A whole number of periods in a whole number of samples, so that the carrier's phase is exact.
FreeDecay slow_carrier() {
    FreeDecay decay{.seconds = 6, .rate_hz = 2000, .f0_hz = 317, .a_B = 0.15};
    return decay;
}

// Phase of a whole-number carrier at a frame, reduced in whole numbers.
double carrier_phase(const FreeDecay& decay, std::int64_t frame) {
    const auto rate = static_cast<std::int64_t>(decay.rate_hz);
    const auto f0 = static_cast<std::int64_t>(decay.f0_hz);
    return 2 * pi * static_cast<double>(f0 * frame % rate) / decay.rate_hz;
}

}  // namespace

class TestFreeDecay : public QObject {
    Q_OBJECT

private slots:
    void samples_are_the_solution_of_the_equations_of_motion_data() {
        QTest::addColumn<double>("split");
        QTest::addColumn<double>("theta_w");
        QTest::addColumn<double>("damping");
        QTest::addColumn<double>("theta_tau");
        QTest::addColumn<double>("omega");
        QTest::newRow("still") << 0.0 << 0.0 << 0.0 << 0.0 << 0.0;
        QTest::newRow("stiffness alone") << 0.4 << 0.3 << 0.0 << 0.0 << 0.0;
        QTest::newRow("damping alone") << 0.0 << 0.0 << 0.3 << -0.4 << 0.0;
        QTest::newRow("rotation alone") << 0.0 << 0.0 << 0.0 << 0.0 << 1.5;
        QTest::newRow("everything") << 0.2 << -0.35 << 0.15 << 0.2 << -0.8;
        // 2 pi split = damping with axes 22.5 degrees apart: the two modes coincide, s = 0.
        QTest::newRow("two modes coincide")
            << 0.25 / (2 * pi) << 0.1 << 0.25 << 0.1 + pi / 8 << 0.0;
        QTest::newRow("two modes nearly coincide")
            << 0.25 / (2 * pi) + 1e-12 << 0.1 << 0.25 << 0.1 + pi / 8 << 0.0;
    }

    void samples_are_the_solution_of_the_equations_of_motion() {
        QFETCH(double, split);
        QFETCH(double, theta_w);
        QFETCH(double, damping);
        QFETCH(double, theta_tau);
        QFETCH(double, omega);
        FreeDecay decay = slow_carrier();
        decay.tau_s = 4;
        decay.split_hz = split;
        decay.theta_w = theta_w;
        decay.damping_anisotropy_per_s = damping;
        decay.theta_tau = theta_tau;
        decay.omega_rad_s = omega;
        const auto samples = simulate(decay, {});
        QVERIFY(samples);
        QCOMPARE(samples->c.size(), std::size_t{12000});
        Pair z = start_phasors(decay);
        double worst = 0;
        for (std::size_t k = 0; k < samples->c.size(); ++k) {
            const Complex carrier =
                std::polar(1.0, carrier_phase(decay, static_cast<std::int64_t>(k)));
            worst = test::largest_of({worst, std::abs((z[0] * carrier).real() - samples->c[k]),
                                      std::abs((z[1] * carrier).real() - samples->d[k])});
            runge_kutta_step(decay, z, 1 / decay.rate_hz);
        }
        // Runge-Kutta: |M|^5 h^5 / 120 a step, times 12000 steps, is below 1e-13 here; the rest is
        // rounding. Relative to a_A = 1.
        VYBEG_LESS(worst, 1e-12);
    }

    void without_damping_anisotropy_and_rotation_two_modes_ring_side_by_side() {
        FreeDecay decay = slow_carrier();
        decay.split_hz = 0.7;
        decay.theta_w = 0.31;
        decay.tau_s = 3;
        const auto samples = simulate(decay, {});
        QVERIFY(samples);
        const Pair z = start_phasors(decay);
        // Mode p moves the rim along theta_w, mode q 45 degrees beside it.
        const double cosine = std::cos(2 * decay.theta_w);
        const double sine = std::sin(2 * decay.theta_w);
        const Complex p = z[0] * cosine + z[1] * sine;
        const Complex q = -z[0] * sine + z[1] * cosine;
        double worst = 0;
        for (std::size_t k = 0; k < samples->c.size(); ++k) {
            const double t = static_cast<double>(k) / decay.rate_hz;
            const double phase = carrier_phase(decay, static_cast<std::int64_t>(k));
            const double left = std::exp(-t / decay.tau_s);
            const double ring_p = left * (p * std::polar(1.0, phase + pi * 0.7 * t)).real();
            const double ring_q = left * (q * std::polar(1.0, phase - pi * 0.7 * t)).real();
            worst =
                test::largest_of({worst, std::abs(ring_p * cosine - ring_q * sine - samples->c[k]),
                                  std::abs(ring_p * sine + ring_q * cosine - samples->d[k])});
        }
        VYBEG_LESS(worst, 1e-13);
    }

    void damping_is_largest_along_its_axis() {
        FreeDecay decay = slow_carrier();
        decay.a_B = 0;
        decay.two_theta_A = 0.5;
        decay.alpha = 0;
        decay.theta_tau = 0;  // along the first pick-off
        decay.tau_s = 5;
        decay.damping_anisotropy_per_s = 0.2;
        const auto samples = simulate(decay, {});
        QVERIFY(samples);
        const std::size_t second = 2000;  // a whole number of periods of 317 Hz
        VYBEG_CLOSE(samples->c[second], std::cos(0.5) * std::exp(-0.3), 1e-13);
        VYBEG_CLOSE(samples->d[second], std::sin(0.5) * std::exp(-0.1), 1e-13);
    }

    void an_hour_keeps_twelve_digits() {
        FreeDecay decay = slow_carrier();
        decay.seconds = 3600;
        decay.split_hz = 0.1;
        decay.theta_w = 0;
        decay.two_theta_A = 0.6;
        decay.a_B = 0;
        const auto samples = simulate(decay, {});
        QVERIFY(samples);
        double worst = 0;
        for (std::size_t k = samples->c.size() - 10000; k < samples->c.size(); ++k) {
            // Mode p is C alone and mode q is D alone; phases in long double.
            const long double beat = std::numbers::pi_v<long double> *
                                     static_cast<long double>(decay.split_hz) *
                                     static_cast<long double>(k) / 2000;
            const long double phase = carrier_phase(decay, static_cast<std::int64_t>(k));
            const long double c = std::cos(0.6L) * std::cos(phase + beat - 0.4L);
            const long double d = std::sin(0.6L) * std::cos(phase - beat - 0.4L);
            worst = test::largest_of({worst, std::abs(static_cast<double>(c - samples->c[k])),
                                      std::abs(static_cast<double>(d - samples->d[k]))});
        }
        VYBEG_LESS(worst, 1e-12);
    }

    void a_decay_of_many_time_constants_neither_overflows_nor_comes_back() {
        FreeDecay decay = slow_carrier();
        decay.seconds = 4000;
        decay.rate_hz = 100;
        decay.f0_hz = 31;
        decay.tau_s = 1;
        decay.damping_anisotropy_per_s = 2;  // one mode does not decay at all
        decay.theta_tau = 0;
        const auto samples = simulate(decay, {});
        QVERIFY(samples);
        double c = 0;
        double d = 0;
        for (std::size_t k = samples->c.size() - 100; k < samples->c.size(); ++k) {
            c = std::max(c, std::abs(samples->c[k]));
            d = std::max(d, std::abs(samples->d[k]));
        }
        QCOMPARE(c, 0.0);
        const double amplitude = std::abs(start_phasors(decay)[1]);
        VYBEG_MORE(d, 0.99 * amplitude);
        VYBEG_LESS(d, amplitude * (1 + 1e-12));
    }

    void the_number_of_frames_is_whole_where_the_product_is() {
        FreeDecay decay;
        QCOMPARE(frame_count(decay), std::int64_t{933324});
        decay.seconds = 2.3;  // 2.3 * 100 is 229.99999999999997
        decay.rate_hz = 100;
        QCOMPARE(frame_count(decay), std::int64_t{230});
        decay.seconds = 2.309;
        QCOMPARE(frame_count(decay), std::int64_t{230});
    }

    void the_impossible_is_refused_with_its_reason_data() {
        QTest::addColumn<FreeDecay>("decay");
        const auto row = [](const char* name, auto change) {
            FreeDecay decay;
            change(decay);
            QTest::newRow(name) << decay;
        };
        row("negative length", [](FreeDecay& x) { x.seconds = -1; });
        row("no rate", [](FreeDecay& x) { x.rate_hz = 0; });
        row("carrier at half the rate", [](FreeDecay& x) { x.f0_hz = x.rate_hz / 2; });
        row("no carrier", [](FreeDecay& x) { x.f0_hz = 0; });
        row("a century", [](FreeDecay& x) { x.seconds = 3e9; });
        row("less than a sample", [](FreeDecay& x) { x.seconds = 1e-6; });
        row("decay time of zero", [](FreeDecay& x) { x.tau_s = 0; });
        row("negative split", [](FreeDecay& x) { x.split_hz = -1e-3; });
        row("growing mode", [](FreeDecay& x) { x.damping_anisotropy_per_s = 0.1; });
        row("negative noise", [](FreeDecay& x) { x.noise = -1e-3; });
        row("kappa of zero", [](FreeDecay& x) { x.kappa = 0; });
        row("one bit", [](FreeDecay& x) { x.bits = 1; });
        row("33 bits", [](FreeDecay& x) { x.bits = 33; });
        row("negative full scale", [](FreeDecay& x) { x.full_scale = -1; });
        row("not a number", [](FreeDecay& x) { x.alpha = std::nan(""); });
    }

    void the_impossible_is_refused_with_its_reason() {
        QFETCH(FreeDecay, decay);
        const auto samples = simulate(decay, {});
        QVERIFY(!samples);
        QCOMPARE(samples.error().code, ErrorCode::simulation_impossible);
        QCOMPARE(samples.error().args.size(), std::size_t{1});
        const auto truth = true_track(decay, 60);
        QVERIFY(!truth);
        QCOMPARE(truth.error(), samples.error());
    }

    void the_sinks_own_error_ends_the_simulation() {
        const FreeDecay decay{.seconds = 1e6};
        const Error enough{ErrorCode::output_failed, "sink", {"enough"}};
        std::int64_t taken = 0;
        const Status ran = simulate(decay, 0,
                                    [&](std::span<const double> c, std::span<const double>) {
                                        taken += std::ssize(c);
                                        return taken > 100'000 ? Status(enough) : Status();
                                    },
                                    {});
        QCOMPARE(ran.error(), enough);
        VYBEG_LESS(taken, 200'000);
    }

    void piece_by_piece_it_is_what_it_is_in_memory() {
        FreeDecay decay = demo_decay();
        decay.seconds = 3.1;
        for (const int bits : {0, 12}) {
            decay.bits = bits;
            const auto whole = simulate(decay, {});
            const auto full_scale = find_full_scale(decay, {});
            QCOMPARE(*full_scale, whole->full_scale);
            std::vector<double> c;
            std::vector<double> d;
            std::size_t longest = 0;
            std::vector<double> reported;
            const DecaySink sink = [&](std::span<const double> x, std::span<const double> y) {
                c.insert(c.end(), x.begin(), x.end());
                d.insert(d.end(), y.begin(), y.end());
                longest = std::max(longest, x.size());
                return Status();
            };
            const JobControl job({}, [&](double fraction) { reported.push_back(fraction); });
            QVERIFY(bool(simulate(decay, *full_scale, sink, job)));
            QVERIFY(c == whole->c && d == whole->d);
            VYBEG_AT_MOST(longest, 20'000);
            QVERIFY(std::ranges::is_sorted(reported));
            QCOMPARE(reported.back(), 1.0);
        }
    }

    void a_stop_request_is_heard() {
        std::stop_source stop;
        stop.request_stop();
        const auto samples = simulate(FreeDecay{}, JobControl(stop.get_token()));
        QVERIFY(!samples);
        QCOMPARE(samples.error().code, ErrorCode::interrupted);
    }
};

VYBEG_TEST(TestFreeDecay, threads)

}  // namespace test_free_decay

#include "test_free_decay.moc"
