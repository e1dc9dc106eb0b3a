#include "core/estimators/wave/wave_state.h"
#include "core/resonator/model/phasor_run.h"
#include "core/resonator/runs/mode_beat.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QTest>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <random>

namespace test_mode_beat {

using namespace vybeg;
using std::numbers::pi;

namespace {

constexpr double hop_s = 0.01;
constexpr double f_ref_hz = 5300;
constexpr double noise = 1e-4;
constexpr double two_theta_zero = 0.7;

// Two modes at right angles 0.5 rad from the first electrode, 2.5 Hz apart, and a common drift.
Phasors motion(double time_s, double split_hz, double drift_hz_s = 0) {
    const auto wave = [&](double amplitude, double f_hz, double tau_s) {
        return std::polar(amplitude * std::exp(-time_s / tau_s),
                          2 * pi * (f_hz * time_s + drift_hz_s * time_s * time_s / 2));
    };
    Phasors z{wave(0.8, 0.3 + split_hz, 9), wave(0.6, 0.3, 12)};
    turn_channels(-0.5, z.c, z.d);
    return z;
}

Track track_of(std::size_t rows, const std::function<Phasors(double)>& motion_at,
               std::uint64_t seed = 1) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> scatter(0, noise);
    const auto noisy = [&] { return std::complex<double>(scatter(random), scatter(random)); };
    Track track(rows);
    for (std::size_t k = 0; k < rows; ++k) {
        const double time_s = hop_s * static_cast<double>(k);
        track.time_s()[k] = time_s;
        Phasors z = motion_at(time_s);
        z.c += noisy();
        z.d += noisy();
        const auto carrier = std::polar(1., 2 * pi * std::remainder(f_ref_hz * time_s, 1));
        const WaveState wave = to_wave_state({carrier * z.c, carrier * z.d});
        track.put(k, SlowVariable::a_A, wave.a_A, noise);
        track.put(k, SlowVariable::a_B, wave.a_B, noise);
        track.put(k, SlowVariable::two_theta_A, wave.two_theta_A, noise);
        track.put(k, SlowVariable::alpha, wave.alpha, noise);
        track.put(k, SlowVariable::f, f_ref_hz, 0.01);
        track.flags()[k] = 0;
    }
    return track;
}

std::optional<ModeBeat> beat_of(const Track& track) {
    return find_mode_beat(track, f_ref_hz, two_theta_zero, 0, 1e9, 1);
}

}  // namespace

class TestModeBeat : public QObject {
    Q_OBJECT

private slots:
    void a_large_swing_is_found_with_every_variable_data() {
        QTest::addColumn<double>("drift_hz_s");
        QTest::newRow("steady") << 0.;
        QTest::newRow("drift") << 0.4;
    }

    void a_large_swing_is_found_with_every_variable() {
        QFETCH(double, drift_hz_s);
        const auto at = [&](double time_s) { return motion(time_s, 2.5, drift_hz_s); };
        const auto beat = beat_of(track_of(400, at));
        QVERIFY(beat);
        VYBEG_WITHIN(beat->frequency_hz, 2.5, 4 * beat->sd_frequency_hz);
        VYBEG_LESS(beat->sd_frequency_hz, 1e-4);
        VYBEG_CLOSE(beat->drift_hz_s, drift_hz_s, 1e-3);
        for (const double time_s : {0.013, 0.77, 2.1, 3.9}) {
            Phasors z = at(time_s);
            const WaveState wave = to_wave_state(z);
            VYBEG_CLOSE(beat->at(SlowVariable::a_A, time_s), wave.a_A, 1e-4);
            VYBEG_CLOSE(beat->at(SlowVariable::a_B, time_s), wave.a_B, 1e-4);
            VYBEG_CLOSE(
                std::remainder(beat->at(SlowVariable::two_theta_A, time_s) - wave.two_theta_A, pi),
                0, 1e-3);
            // The phase of the whole wave, by a difference quotient.
            constexpr double step_s = 1e-4;
            const Phasors later = at(time_s + step_s);
            const double turned =
                std::arg(std::conj(z.c) * later.c + std::conj(z.d) * later.d) / step_s;
            VYBEG_CLOSE(beat->at(SlowVariable::f, time_s), f_ref_hz + turned / (2 * pi), 3e-3);
            turn_channels(-two_theta_zero, z.c, z.d);
            VYBEG_CLOSE(
                std::remainder(beat->at(SlowVariable::delta_phi_CD, time_s) - phase_difference(z),
                               2 * pi),
                0, 1e-3);
        }
    }

    // Long recordings are merged: 30 000 windows.
    void many_windows_lose_nothing() {
        const auto at = [](double time_s) { return motion(0.01 * time_s, 2.5); };
        const auto beat = beat_of(track_of(30'000, at));
        QVERIFY(beat);
        VYBEG_WITHIN(beat->frequency_hz, 0.025, 4 * beat->sd_frequency_hz);
        VYBEG_CLOSE(beat->at(SlowVariable::a_B, 150), to_wave_state(at(150)).a_B, 2e-5);
    }

    void less_than_a_beat_is_none() {
        for (const double split_hz : {0., 0.05, 0.2, 0.3}) {
            QVERIFY(!beat_of(track_of(400, [&](double t) { return motion(t, split_hz); })));
        }
    }

    void noise_makes_no_beat() {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            const auto still = [](double time_s) {
                return Phasors{std::polar(std::exp(-time_s / 9), time_s), 0};
            };
            QVERIFY(!beat_of(track_of(400, still, seed)));
        }
    }

    void another_motion_is_refused() {
        const auto three = [](double time_s) {
            Phasors z = motion(time_s, 2.5);
            z.c += std::polar(0.01, 2 * pi * 7.3 * time_s);
            return z;
        };
        QVERIFY(!beat_of(track_of(400, three)));
        const auto knocked = [](double time_s) { return motion(time_s < 2 ? time_s : 0.9, 2.5); };
        QVERIFY(!beat_of(track_of(400, knocked)));
    }

    void windows_without_phasors_are_left_out() {
        Track track = track_of(400, [](double time_s) { return motion(time_s, 2.5); });
        for (std::size_t k = 100; k < 130; ++k) {
            track.put(k, SlowVariable::two_theta_A, std::nan(""), noise);
        }
        track.flags()[300] = static_cast<Flags>(Flag::gap);
        track.put(300, SlowVariable::a_A, 5, noise);
        const auto beat = beat_of(track);
        QVERIFY(beat);
        VYBEG_WITHIN(beat->frequency_hz, 2.5, 4 * beat->sd_frequency_hz);
        QVERIFY(!beat_of(Track(3)));
    }
};

VYBEG_TEST(TestModeBeat)

}  // namespace test_mode_beat

#include "test_mode_beat.moc"
