#include "core/track/trend.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

namespace test_beat {

using namespace vybeg;

namespace {

constexpr double hop_s = 0.002;
constexpr double start_s = 100;

struct Wave {
    double frequency_hz = 3.7;
    double amplitude = 0.02;
    double phase = 1.1;
    double damping_per_s = 0;
    double slope_per_s = 0;
    double offset = 0;
};

double value(const Wave& wave, double time_s, double centre_s) {
    const double u = time_s - centre_s;
    return wave.offset + wave.slope_per_s * u +
           wave.amplitude * std::exp(-wave.damping_per_s * u) *
               std::cos(2 * std::numbers::pi * wave.frequency_hz * u - wave.phase);
}

// Windows every 2 ms with a beat about their middle, and white noise.
Track track_of(SlowVariable variable, std::size_t rows, const Wave& wave, double sd,
               std::uint64_t seed = 1) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0, sd);
    Track track(rows);
    const double centre_s = start_s + 0.5 * hop_s * static_cast<double>(rows - 1);
    for (std::size_t k = 0; k < rows; ++k) {
        const double time_s = start_s + hop_s * static_cast<double>(k);
        track.time_s()[k] = time_s;
        track.values(variable)[k] = value(wave, time_s, centre_s) + noise(random);
        track.sds(variable)[k] = sd;
        track.flags()[k] = 0;
    }
    return track;
}

std::optional<Beat> beat_of(const Track& track, SlowVariable variable) {
    return find_beat(track, variable, 0, 1e9, 1);
}

}  // namespace

class TestBeat : public QObject {
    Q_OBJECT

private slots:
    void a_beat_is_found_within_its_deviations_data() {
        QTest::addColumn<double>("periods");
        QTest::addColumn<double>("damping_periods");  // damping times span
        for (const double periods : {1.3, 2.0, 7.77, 31.0, 94.6}) {
            for (const double damping : {0.0, 1.5, -0.7}) {
                QTest::addRow("%g periods, damping %g", periods, damping) << periods << damping;
            }
        }
    }

    void a_beat_is_found_within_its_deviations() {
        QFETCH(double, periods);
        QFETCH(double, damping_periods);
        constexpr std::size_t rows = 3000;
        const double span = hop_s * (rows - 1);
        for (const double phase : {-2.5, -0.4, 0.0, 1.0, 3.0}) {
            Wave wave;
            wave.frequency_hz = periods / span;
            wave.damping_per_s = damping_periods / span;
            wave.phase = phase;
            wave.slope_per_s = 2e-3;
            wave.offset = 5300;
            const auto beat =
                beat_of(track_of(SlowVariable::f, rows, wave, 1e-3, 7), SlowVariable::f);
            QVERIFY(beat);
            QCOMPARE(beat->windows, rows);
            VYBEG_WITHIN(beat->frequency_hz, wave.frequency_hz, 4 * beat->sd_frequency_hz);
            VYBEG_WITHIN(beat->damping_per_s, wave.damping_per_s, 4 * beat->sd_damping_per_s);
            VYBEG_WITHIN(beat->amplitude, wave.amplitude, 4 * beat->sd_amplitude);
            // Of a sinusoid on a line: sqrt(6)/pi sd/amplitude / (span sqrt(rows)), more with
            // damping and with fewer periods.
            const double least = std::sqrt(6.0) / std::numbers::pi * 1e-3 / wave.amplitude / span /
                                 std::sqrt(static_cast<double>(rows));
            VYBEG_MORE(beat->sd_frequency_hz, 0.6 * least);
            VYBEG_LESS(beat->sd_frequency_hz, 20 * least);
            if (periods > 2 && damping_periods == 0) {
                VYBEG_WITHIN(beat->sd_frequency_hz, least, 0.2 * least);
            }
            VYBEG_WITHIN(beat->at(start_s + 1), value(wave, start_s + 1, start_s + 0.5 * span),
                         3e-4);
        }
    }

    void noise_and_lines_have_no_beat() {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            Wave none;
            none.amplitude = 0;
            none.slope_per_s = 0.01;
            QVERIFY(
                !beat_of(track_of(SlowVariable::a_B, 1000, none, 1e-3, seed), SlowVariable::a_B));
        }
    }

    void a_period_or_less_is_no_beat() {
        constexpr std::size_t rows = 1000;
        for (const double periods : {0.2, 0.4, 0.7, 1.0}) {
            Wave wave;
            wave.frequency_hz = periods / (hop_s * (rows - 1));
            QVERIFY(!beat_of(track_of(SlowVariable::a_B, rows, wave, 1e-3), SlowVariable::a_B));
        }
    }

    void few_windows_and_variables_without_deviations_have_none() {
        const Track few = track_of(SlowVariable::a_B, 9, {}, 1e-3);
        QVERIFY(!beat_of(few, SlowVariable::a_B));
        const Track more = track_of(SlowVariable::a_B, 1000, {}, 1e-3);
        QVERIFY(beat_of(more, SlowVariable::a_B));
        QVERIFY(!beat_of(more, SlowVariable::noise));
    }

    // Averages of windows take the place of windows; they flatten the beat by less than its sd.
    void many_windows_give_the_same_beat() {
        constexpr std::size_t rows = 100001;
        Wave wave;
        wave.frequency_hz = 97 / (hop_s * (rows - 1));
        const auto beat = beat_of(track_of(SlowVariable::a_B, rows, wave, 1e-3), SlowVariable::a_B);
        QVERIFY(beat);
        VYBEG_WITHIN(beat->frequency_hz, wave.frequency_hz, 4 * beat->sd_frequency_hz);
        VYBEG_WITHIN(beat->amplitude, wave.amplitude, 4 * beat->sd_amplitude);
        const double expected = 1e-3 * std::sqrt(2.0 / rows);
        VYBEG_WITHIN(beat->sd_amplitude, expected, 0.1 * expected);
    }

    // Scatter that the deviations do not know of, and motions that are no damped sinusoid.
    void what_leaves_the_sinusoid_is_no_beat() {
        Track scattered = track_of(SlowVariable::a_B, 3000, {}, 1e-3);
        QVERIFY(beat_of(scattered, SlowVariable::a_B));
        for (double& sd : scattered.sds(SlowVariable::a_B)) {
            sd /= 3;
        }
        QVERIFY(!beat_of(scattered, SlowVariable::a_B));
        for (const double third : {0.05, -0.1}) {  // a large swing has a third harmonic
            Track swing = track_of(SlowVariable::a_B, 3000, {}, 1e-4);
            for (std::size_t k = 0; k < swing.rows(); ++k) {
                double& x = swing.values(SlowVariable::a_B)[k];
                x += third * x * x * x / (0.02 * 0.02);
            }
            QVERIFY(!beat_of(swing, SlowVariable::a_B));
        }
    }

    // Noise with a correlation of tens of windows: its slow part fits many sinusoids.
    void coloured_noise_has_no_beat() {
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            Wave none;
            none.amplitude = 0;
            Track track = track_of(SlowVariable::a_B, 3000, none, 1e-3, seed);
            std::mt19937_64 random(seed + 1000);
            std::normal_distribution<double> kick(0, 1);
            double slow = 0;
            for (double& x : track.values(SlowVariable::a_B)) {
                slow = 0.98 * slow + 2e-4 * kick(random);
                x += slow;
            }
            QVERIFY(!beat_of(track, SlowVariable::a_B));
        }
    }
};

VYBEG_TEST(TestBeat)

}  // namespace test_beat

#include "test_beat.moc"
