// Errors of the channels, modes beside, hum and lost samples against direct formulas: with
// a_A = 1, a_B = 0 the wave is C = cos(2theta) cos(wt - alpha), D = sin(2theta) cos(wt - alpha).
#include "core/simulation/decay_motion.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/noise.h"
#include "core/simulation/simulate.h"
#include "tests/closeness.h"
#include "tests/largest_of.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace test_simulated_channels {

using namespace vybeg;
using std::numbers::pi;

namespace {

using Signals = std::pair<double, double>;

struct Case {
    double angle;  // 2theta_A
    double alpha;
    double f0_hz;
    double rate_hz;
};

constexpr std::array cases{Case{0.3, 0.4, 5300, 33333}, Case{-1.1, 2.9, 317.25, 2000},
                           Case{1.5, -1.3, 0.356, 8.6}, Case{2.6, 0.0, 7912.5, 44100}};

FreeDecay steady(const Case& x) {
    FreeDecay decay{.seconds = 20000 / x.rate_hz,
                    .rate_hz = x.rate_hz,
                    .f0_hz = x.f0_hz,
                    .two_theta_A = x.angle,
                    .alpha = x.alpha};
    return decay;
}

// Largest distance of the samples from a formula of the time.
template <typename Formula>
double distance(const FreeDecay& decay, const Formula& formula) {
    const auto samples = simulate(decay, {});
    if (!samples || samples->c.size() != 20000) {
        return std::numeric_limits<double>::infinity();
    }
    double worst = 0;
    for (std::size_t k = 0; k < samples->c.size(); ++k) {
        const auto [c, d] = formula(static_cast<double>(k) / decay.rate_hz);
        worst = test::largest_of({worst, std::abs(c - samples->c[k]), std::abs(d - samples->d[k])});
    }
    return worst;
}

// 20000 samples hold up to 3e4 rad of phase, whose rounding is 4e-12.
constexpr double rounding = 2e-11;

}  // namespace

class TestSimulatedChannels : public QObject {
    Q_OBJECT

private slots:

    // The samples before there were any errors to set: carrier, motion, gain, offset, white noise.
    void without_errors_the_samples_are_those_of_the_linear_motion_to_the_last_bit() {
        for (const std::uint64_t seed : {1U, 20U}) {
            FreeDecay decay = demo_decay();
            decay.seconds = 3;
            decay.seed = seed;
            decay.kappa = 1.02;
            decay.offset_c = 0.1;
            decay.two_theta_A = 0.3 + static_cast<double>(seed);
            const auto samples = simulate(decay, {});
            QVERIFY(bool(samples));
            const SlowMotion motion(decay);
            const Eigen::Matrix2cd step = motion.propagator(1 / decay.rate_hz) * motion.carrier(1);
            GaussianNoise noise(seed);
            Eigen::Vector2cd z;
            for (std::size_t k = 0; k < samples->c.size(); ++k) {
                if (k % 256 == 0) {
                    z = motion.at_frame(static_cast<double>(k));
                }
                const auto [noise_c, noise_d] = noise.next();
                double c = z(0).real() + decay.offset_c;
                double d = z(1).real() / decay.kappa + decay.offset_d;
                c += decay.noise * noise_c;
                d += decay.noise * noise_d;
                QCOMPARE(samples->c[k] - c, 0.0);
                QCOMPARE(samples->d[k] - d, 0.0);
                z = step * z;
            }
        }
    }

    void skew_and_gain_ratio_mix_the_channels_as_written() {
        for (const Case& x : cases) {
            for (const double skew_deg : {0.1, -3.0}) {
                FreeDecay decay = steady(x);
                decay.skew_deg = skew_deg;
                decay.kappa = 1.04;
                VYBEG_CLOSE(
                    distance(decay,
                             [&](double t) {
                                 const double wave = std::cos(2 * pi * x.f0_hz * t - x.alpha);
                                 return Signals{std::cos(x.angle) * wave,
                                                (std::sin(x.angle) + std::sin(skew_deg * pi / 180) *
                                                                         std::cos(x.angle)) *
                                                    wave / 1.04};
                             }),
                    0, rounding);
            }
        }
    }

    void crosstalk_in_quadrature_is_c_a_quarter_of_a_period_early() {
        for (const Case& x : cases) {
            FreeDecay decay = steady(x);
            decay.crosstalk = 0.02;
            VYBEG_CLOSE(distance(decay,
                                 [&](double t) {
                                     const double phase = 2 * pi * x.f0_hz * t - x.alpha;
                                     return Signals{
                                         std::cos(x.angle) * std::cos(phase),
                                         std::sin(x.angle) * std::cos(phase) +
                                             0.02 * std::cos(x.angle) * std::cos(phase + pi / 2)};
                                 }),
                        0, rounding);
        }
    }

    void a_delay_shows_channel_d_as_it_was_before() {
        for (const Case& x : cases) {
            for (const double samples_late : {0.01, -0.37, 25.5}) {
                FreeDecay decay = steady(x);
                decay.delay_d_s = std::clamp(samples_late / x.rate_hz, -0.1, 0.1);
                VYBEG_CLOSE(distance(decay,
                                     [&](double t) {
                                         const double w = 2 * pi * x.f0_hz;
                                         return Signals{
                                             std::cos(x.angle) * std::cos(w * t - x.alpha),
                                             std::sin(x.angle) *
                                                 std::cos(w * (t - decay.delay_d_s) - x.alpha)};
                                     }),
                            0, rounding);
            }
        }
    }

    // A delay of whole samples against the samples themselves.
    void the_delay_holds_for_a_decaying_beating_drifting_wave() {
        for (const double by_power : {0.0, 2.0}) {
            FreeDecay decay{.seconds = 4,
                            .rate_hz = 4000,
                            .f0_hz = 731,
                            .a_B = 0.2,
                            .split_hz = 1,
                            .theta_w = 0.4,
                            .tau_s = 3,
                            .omega_rad_s = 1,
                            .frequency_drift_hz_s = 0.3,
                            .settling_hz = -0.2,
                            .settling_time_s = 0.5,
                            .frequency_per_power_hz = by_power,
                            .damping_per_power_per_s = by_power / 10};
            const auto plain = simulate(decay, {});
            for (const int late : {1, 7, -3}) {
                decay.delay_d_s = late / decay.rate_hz;
                const auto delayed = simulate(decay, {});
                QVERIFY(plain && delayed);
                QVERIFY(plain->c == delayed->c);
                double worst = 0;
                for (std::size_t k = 10; k + 10 < plain->d.size(); ++k) {
                    const double before =
                        plain->d[static_cast<std::size_t>(static_cast<int>(k) - late)];
                    worst = test::largest_of({worst, std::abs(delayed->d[k] - before)});
                }
                VYBEG_CLOSE(worst, 0, 1e-11);
            }
        }
    }

    void phase_and_gain_of_d_drift_linearly_over_the_recording() {
        for (const Case& x : cases) {
            FreeDecay decay = steady(x);
            decay.phase_drift_rad = 0.2;
            decay.gain_drift = -0.05;
            decay.kappa = 0.98;
            VYBEG_CLOSE(distance(decay,
                                 [&](double t) {
                                     const double phase = 2 * pi * x.f0_hz * t - x.alpha;
                                     const double share = t / decay.seconds;
                                     return Signals{std::cos(x.angle) * std::cos(phase),
                                                    std::sin(x.angle) * (1 - 0.05 * share) *
                                                        std::cos(phase + 0.2 * share) / 0.98};
                                 }),
                        0, rounding);
        }
    }

    void the_cubic_of_the_pick_offs_bends_both_channels() {
        for (const Case& x : cases) {
            FreeDecay decay = steady(x);
            const auto straight = simulate(decay, {});
            decay.pick_off_cubic = -0.03;
            decay.offset_c = 0.5;  // an offset of the electronics is not bent
            const auto bent = simulate(decay, {});
            QVERIFY(straight && bent);
            for (std::size_t k = 0; k < straight->c.size(); ++k) {
                const double c = straight->c[k];
                const double d = straight->d[k];
                VYBEG_CLOSE(bent->c[k], c - 0.03 * c * c * c + 0.5, 1e-15);
                VYBEG_CLOSE(bent->d[k], d - 0.03 * d * d * d, 1e-15);
            }
        }
    }

    void hum_is_the_same_in_both_channels() {
        FreeDecay decay = steady(cases[0]);
        const auto plain = simulate(decay, {});
        decay.hum = 0.07;
        decay.hum_hz = 60;
        decay.hum_phase = 1.2;
        const auto humming = simulate(decay, {});
        QVERIFY(plain && humming);
        for (std::size_t k = 0; k < plain->c.size(); ++k) {
            const double t = static_cast<double>(k) / decay.rate_hz;
            const double hum = 0.07 * std::cos(2 * pi * 60 * t - 1.2);
            VYBEG_CLOSE(humming->c[k] - plain->c[k], hum, 1e-13);
            VYBEG_CLOSE(humming->d[k] - plain->d[k], hum, 1e-13);
        }
    }

    void modes_beside_ring_with_their_own_phases() {
        FreeDecay decay = steady(cases[0]);
        const auto plain = simulate(decay, {});
        decay.modes_beside = {
            {.f_hz = 990, .a_C = 0.3, .a_D = -0.1, .phase_C = 0.5, .phase_D = 2, .tau_s = 0.2},
            {.f_hz = 5317.5, .a_C = 2, .a_D = 3}};
        const auto more = simulate(decay, {});
        QVERIFY(plain && more);
        for (std::size_t k = 0; k < plain->c.size(); ++k) {
            const double t = static_cast<double>(k) / decay.rate_hz;
            const double left = std::exp(-t / 0.2);
            const double ring = std::cos(2 * pi * 5317.5 * t);
            const double c = 0.3 * left * std::cos(2 * pi * 990 * t - 0.5) + 2 * ring;
            const double d = -0.1 * left * std::cos(2 * pi * 990 * t - 2) + 3 * ring;
            VYBEG_CLOSE(more->c[k] - plain->c[k], c, rounding);
            VYBEG_CLOSE(more->d[k] - plain->d[k], d, rounding);
        }
    }

    void lost_samples_are_cut_out_and_doubled_ones_come_twice() {
        FreeDecay decay = steady(cases[0]);
        decay.noise = 1e-3;
        const auto whole = simulate(decay, {});
        decay.lost = {{.frame = 100, .count = 3}, {.frame = 5000, .count = -4}};
        QCOMPARE(frame_count(decay), std::int64_t{20001});
        QCOMPARE(motion_frame_count(decay), std::int64_t{20000});
        const auto faulty = simulate(decay, {});
        QVERIFY(whole && faulty);
        for (const auto& [from, found] :
             {std::pair{&whole->c, &faulty->c}, std::pair{&whole->d, &faulty->d}}) {
            std::vector<double> expected(*from);
            const std::vector<double> again(expected.begin() + 5000, expected.begin() + 5004);
            expected.insert(expected.begin() + 5004, again.begin(), again.end());
            expected.erase(expected.begin() + 100, expected.begin() + 103);
            QVERIFY(*found == expected);
        }
    }

    // 16384 frames are made at a time.
    void lost_samples_do_not_care_about_blocks() {
        FreeDecay decay = steady(cases[0]);
        const auto whole = simulate(decay, {});
        for (const std::int64_t frame : {16380, 16383, 16384}) {
            for (const std::int64_t count : {9, -9, -1}) {
                decay.lost = {{0, 1}, {1, -1}, {frame, count}, {19999, 1}};
                const auto faulty = simulate(decay, {});
                QVERIFY(whole && faulty);
                std::vector<double> expected;
                for (std::int64_t k = 1; k < 19999; ++k) {
                    const bool inside = k >= frame && k < frame + std::abs(count);
                    if (inside && count > 0) {
                        continue;
                    }
                    expected.push_back(whole->d[static_cast<std::size_t>(k)]);
                    const bool last = k + 1 == frame + std::abs(count);
                    for (std::int64_t j = k == 1 ? 1 : (count < 0 && last ? frame : k + 1); j <= k;
                         ++j) {
                        expected.push_back(whole->d[static_cast<std::size_t>(j)]);
                    }
                }
                QCOMPARE(faulty->d.size(), expected.size());
                QVERIFY(faulty->d == expected);
                QCOMPARE(frame_count(decay), std::ssize(expected));
            }
        }
    }

    void the_truth_is_the_waves_without_errors_of_channels() {
        FreeDecay decay = demo_decay();
        decay.seconds = 3;
        const auto clean = true_track(decay, 60);
        decay.skew_deg = 1;
        decay.delay_d_s = 1e-5;
        decay.crosstalk = 0.1;
        decay.phase_drift_rad = 0.1;
        decay.gain_drift = 0.1;
        decay.pick_off_cubic = 0.1;
        decay.hum = 0.1;
        decay.carrier_noise = 0.1;
        decay.modulation_noise = 0.1;
        decay.phase_noise_rad = 0.1;
        decay.modes_beside = {{.f_hz = 900, .a_C = 1, .a_D = 1}};
        decay.lost = {{.frame = 100, .count = 30}};
        const auto truth = true_track(decay, 60);
        QVERIFY(clean && truth);
        QCOMPARE(truth->rows(), clean->rows());
        for (const SlowVariable variable :
             {SlowVariable::a_A, SlowVariable::a_B, SlowVariable::alpha, SlowVariable::two_theta_A,
              SlowVariable::f}) {
            QVERIFY(std::ranges::equal(truth->values(variable), clean->values(variable)));
        }
    }

    void the_impossible_is_refused_data() {
        QTest::addColumn<FreeDecay>("decay");
        const auto row = [](const char* name, const FreeDecay& decay) {
            QTest::newRow(name) << decay;
        };
        row("delay of a second", {.delay_d_s = 1});
        row("delay of the decay time", {.tau_s = 0.01, .delay_d_s = 0.02});
        row("skew that is no number", {.skew_deg = std::nan("")});
        row("gain drift to zero", {.gain_drift = -1});
        row("no settling time", {.settling_time_s = 0});
        row("drift through zero", {.frequency_drift_hz_s = -200});
        row("drift beyond half the rate", {.frequency_drift_hz_s = 500});
        row("settling beyond half the rate", {.settling_hz = 12000});
        row("stiffer than half the rate", {.frequency_per_power_hz = 12000});
        row("growing at full power", {.tau_s = 10, .damping_per_power_per_s = -0.2});
        row("hum above half the rate", {.hum = 1, .hum_hz = 20000});
        row("negative noise about the carrier", {.carrier_noise = -1});
        row("negative modulation", {.modulation_noise = -1});
        row("negative phase noise", {.phase_noise_rad = -1});
        row("noise without width", {.carrier_noise_width_hz = 0});
        row("mode beside without frequency", {.modes_beside = {{.a_C = 1}}});
        row("mode beside at half the rate", {.modes_beside = {{.f_hz = 16666.5, .a_C = 1}}});
        row("mode beside that grows", {.modes_beside = {{.f_hz = 100, .tau_s = -1}}});
        row("nothing lost", {.lost = {{10, 0}}});
        row("lost before the start", {.lost = {{-1, 2}}});
        row("lost behind the end", {.lost = {{933320, 5}}});
        row("doubled behind the end", {.lost = {{933320, -5}}});
        row("lost twice", {.lost = {{10, 5}, {14, 5}}});
        row("out of order", {.lost = {{100, 5}, {10, 5}}});
        row("everything lost", {.lost = {{0, 933324}}});
        row("more lost than a number holds",
            {.lost = {{10, std::numeric_limits<std::int64_t>::min()}}});
    }

    void the_impossible_is_refused() {
        QFETCH(FreeDecay, decay);
        const auto samples = simulate(decay, {});
        QVERIFY(!samples);
        QCOMPARE(samples.error().code, ErrorCode::simulation_impossible);
        QCOMPARE(true_track(decay, 60).error(), samples.error());
    }
};

VYBEG_TEST(TestSimulatedChannels)

}  // namespace test_simulated_channels

#include "test_simulated_channels.moc"
