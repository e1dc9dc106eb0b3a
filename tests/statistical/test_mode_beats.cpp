#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/resonator/runs/mode_beat.h"
#include "core/track/trend.h"
#include "tests/closeness.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

namespace test_mode_beats {

using namespace vybeg;
using namespace vybeg::test;
using std::numbers::pi;

// Beats of any resonator between two cursors, against the simulator: 0.05 to 5 Hz, 1.5 to 20
// periods, decays from half of the time between the cursors on, swings of any size, quadratures of
// both signs up to 0.9 of the amplitude, with and without anisotropy and rotation, with a drift of
// up to three turns between the cursors, and noise 40 to 80 dB below the wave. A frequency that
// depends on the amplitude by a tenth of a turn is another motion: nearly all of those are refused.
class TestModeBeats : public QObject {
    Q_OBJECT

private slots:
    void a_beat_is_told_within_its_deviation_or_refused_data() {
        QTest::addColumn<bool>("any_matrix");
        QTest::addColumn<double>("drift");   // turns of phase between the cursors
        QTest::addColumn<double>("spring");  // turns by a cubic spring
        QTest::addColumn<double>("noise");
        QTest::newRow("split") << false << 0. << 0. << 1e-3;
        QTest::newRow("split, anisotropy and rotation") << true << 0. << 0. << 1e-3;
        QTest::newRow("much noise") << true << 0. << 0. << 1e-2;
        QTest::newRow("little noise") << true << 0. << 0. << 1e-4;
        QTest::newRow("drift") << true << 3. << 0. << 1e-3;
        QTest::newRow("spring") << true << 0. << 0.1 << 1e-3;
    }

    void a_beat_is_told_within_its_deviation_or_refused() {
        QFETCH(bool, any_matrix);
        QFETCH(double, drift);
        QFETCH(double, spring);
        QFETCH(double, noise);
        std::mt19937_64 random(17);
        std::uniform_real_distribution<double> any(-1, 1);
        const auto between = [&](double least, double most) {
            return least * std::pow(most / least, 0.5 + 0.5 * any(random));
        };
        double squares = 0;
        int told = 0;
        int silent = 0;
        for (int seed = 1; seed <= seeds; ++seed) {
            FreeDecay wave;
            const double beat = between(0.05, 5);
            const double periods = between(1.5, 20);
            const double span = periods / beat;
            wave.seconds = 1.1 * span;
            wave.rate_hz = 33333 * std::clamp(beat / 0.5, 0.1, 1.);
            wave.f0_hz = 0.159 * wave.rate_hz + any(random);
            wave.seed = static_cast<std::uint64_t>(seed);
            wave.alpha = 3 * any(random);
            wave.split_hz = beat;
            wave.theta_w = 0.7 * any(random);
            wave.two_theta_A = 2 * wave.theta_w + any(random) * pi / 2;
            wave.a_B = 0.9 * any(random);
            wave.tau_s = span * between(0.5, 20);
            wave.noise = noise;
            if (any_matrix) {
                wave.damping_anisotropy_per_s = 0.3 * beat * std::abs(any(random));
                wave.tau_s = 1 / (1 / wave.tau_s + wave.damping_anisotropy_per_s / 2);
                wave.theta_tau = 0.7 * any(random);
                wave.omega_rad_s = beat * any(random);
            }
            wave.frequency_drift_hz_s = 2 * drift * any(random) / (span * span);
            wave.frequency_per_power_hz = spring * any(random) / span;
            const double truth = beat_of(wave);
            Settings settings;
            settings.window = settings.hop = 60;
            const auto analysis = analyse(simulated_recording(wave), settings, {});
            QVERIFY(analysis);
            const double from = 0.05 * span;
            const double to = from + span;
            const std::size_t apart = windows_apart(analysis->plan.length, analysis->plan.hop);
            const auto two = find_mode_beat(analysis->track, analysis->f0_hz(), 0, from, to, apart);
            const QByteArray where = "seed " + QByteArray::number(seed);
            for (const SlowVariable variable : {SlowVariable::a_B, SlowVariable::two_theta_A}) {
                const auto one = find_beat(analysis->track, variable, from, to, apart);
                if (one) {
                    VYBEG_CLOSE((one->frequency_hz - truth) / one->sd_frequency_hz, 0, 5, where);
                }
                silent += !one && !two ? 1 : 0;
            }
            if (two && spring == 0) {
                const double pull = (two->frequency_hz - truth) / two->sd_frequency_hz;
                VYBEG_CLOSE(pull, 0, 5, where);
                squares += pull * pull;
                ++told;
            } else if (two) {
                // The spring adds to the split.
                VYBEG_CLOSE(two->frequency_hz, truth, 1e-3 * truth, where);
            }
        }
        const double rms = std::sqrt(squares / told);
        qInfo("%d of %d told, rms pull %g, %d variables without a beat", told, seeds, rms, silent);
        if (spring == 0) {
            VYBEG_AT_LEAST(told, seeds * 9 / 10);
            VYBEG_MORE(rms, 0.85);
            VYBEG_LESS(rms, 1.15);
        }
    }

private:
    static constexpr int seeds = 200;

    // Difference of the modes' frequencies by the eigenvalues of M (METHOD section 8).
    static double beat_of(const FreeDecay& wave) {
        const double split = pi * wave.split_hz;
        const double damping = wave.damping_anisotropy_per_s / 2;
        const double rotation = 2 * wave.bryan * wave.omega_rad_s;
        const std::complex<double> square(
            damping * damping - split * split - rotation * rotation,
            -2 * split * damping * std::cos(4 * (wave.theta_w - wave.theta_tau)));
        return std::abs(std::sqrt(square).imag()) / pi;
    }
};

VYBEG_TEST(TestModeBeats)

}  // namespace test_mode_beats

#include "test_mode_beats.moc"
