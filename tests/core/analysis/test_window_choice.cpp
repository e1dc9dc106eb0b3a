// Windows and deviations of an identification, from samples.
//
// Statistical model: the errors of the four real parts of N phasors are Gaussian with the deviation
// told; the mean of their squares in units of it is 1 within sqrt(2/(4 N)).
#include "core/analysis/phasor_windows.h"
#include "core/resonator/runs/wave_motion.h"
#include "core/simulation/decay_motion.h"
#include "core/simulation/noise.h"
#include "core/simulation/simulate.h"
#include "tests/closeness.h"
#include "tests/largest_of.h"
#include "tests/needed.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace test_window_choice {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

FreeDecay gyro(double split_hz = 0, std::uint64_t seed = 1) {
    FreeDecay decay{.seconds = 6,
                    .split_hz = split_hz,
                    .theta_w = 0.1 + 0.3 * static_cast<double>(seed),
                    .tau_s = 400};
    // Both modes move, the weaker one by 7 % at least.
    decay.two_theta_A = 0.5 + 0.9 * static_cast<double>(seed);
    decay.noise = 1e-3;
    decay.seed = seed;
    return decay;
}

void add_line(SimulatedDecay& samples, double rate_hz, double f_hz, double size) {
    for (std::size_t j = 0; j < samples.c.size(); ++j) {
        const double phase = two_pi * f_hz * static_cast<double>(j) / rate_hz;
        samples.c[j] += size * std::cos(phase + 0.3);
        samples.d[j] += size * std::cos(phase + 1.1);
    }
}

Result<RecordedRun> windows_of(const Recording& recording, const SignalSettings& settings,
                               std::optional<std::int64_t> window = {}) {
    const Result<WindowChoice> choice = choose_windows(recording, settings, {.window = window}, {});
    if (!choice) {
        return choice.error();
    }
    return phasor_windows(*choice, recording.rate_hz, 2, {});
}

RecordedRun found_in(const SimulatedDecay& samples, double rate_hz,
                     const SignalSettings& settings) {
    return needed(windows_of(recording_of(samples.c, samples.d, rate_hz), settings));
}

// Mean square of the errors in units of the deviations told; `parts` of lag-one products.
struct Errors {
    double square = 0;
    double neighbours = 0;
    double tolerance = 0;  // four deviations of the square
};

Errors errors_of(const RecordedRun& found, const FreeDecay& decay) {
    const SlowMotion motion(decay);
    const PhasorRun& run = found.phasors;
    Errors errors;
    Eigen::Vector2cd last = Eigen::Vector2cd::Zero();
    const auto count = static_cast<double>(run.time_s.size());
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        Eigen::Vector2cd sum = Eigen::Vector2cd::Zero();
        const auto n = found.told.window;
        const double first =
            std::round(run.time_s[k] * decay.rate_hz - 0.5 * static_cast<double>(n - 1));
        for (std::int64_t j = 0; j < n; ++j) {
            const double frame = first + static_cast<double>(j);
            sum += motion.at_frame(frame) *
                   std::polar(1.0,
                              -two_pi * std::remainder(run.f_ref_hz * frame / decay.rate_hz, 1.0));
        }
        const Eigen::Vector2cd error =
            (Eigen::Vector2cd(run.c[k], run.d[k]) - sum / static_cast<double>(n)) / run.sd[k];
        errors.square += error.squaredNorm() / (4 * count);
        errors.neighbours += last.dot(error).real() / (4 * count);
        last = error;
    }
    errors.tolerance = 4 * std::sqrt(2 / (4 * count));
    return errors;
}

QByteArray text(const RecordedRun& found, const Errors& errors) {
    return QString("square %1 +- %2, noise %3, window %4, reference %5 Hz")
        .arg(errors.square)
        .arg(errors.tolerance / 4)
        .arg(found.told.noise_sd)
        .arg(found.told.window)
        .arg(found.phasors.f_ref_hz, 0, 'f', 3)
        .toUtf8();
}

bool tells(const std::vector<Diagnostic>& diagnostics, DiagnosticKind kind) {
    return std::ranges::any_of(diagnostics, [&](const auto& told) { return told.kind == kind; });
}

// A pendulum filmed by a camera: 0.356 Hz, 24 minutes at 8.6 frames a second. The frequency falls
// with the square of the amplitude, the plane turns by 1.9 degrees, the first minute has outliers.
struct Pendulum {
    double f_hz = 0.356;
    double pull_hz = -2e-4;  // at the amplitude of the start
    double tau_s = 4400;
    double seconds = 1440;
    double quadrature(double t) const { return 0.02 + 1e-5 * t; }
    // The phase of both signals by power turns with the plane: 2 a_A a_B d(2theta) / |z|^2.
    double turned_phase(double t) const {
        return 2 * (0.02 * t + 0.5e-5 * t * t) * 2 * turn_rad / seconds;
    }
    double log_amplitude(double t) const {
        return -t / tau_s + 0.5 * std::log1p(quadrature(t) * quadrature(t));
    }
    double turn_rad = 1.9 * std::numbers::pi / 180;

    double phase(double t) const {
        return two_pi * (f_hz * t + pull_hz * tau_s / 2 * (1 - std::exp(-2 * t / tau_s)));
    }
};

}  // namespace

class TestWindowChoice : public QObject {
    Q_OBJECT

private slots:
    void an_offset_and_hum_change_neither_phasors_nor_deviations() {
        for (const double offset : {0.0, 0.01, 0.1}) {
            for (const double hum : {0.0, 0.03, 0.1}) {
                FreeDecay decay = gyro(0, 2);
                decay.offset_c = offset;
                decay.offset_d = -offset / 2;
                SimulatedDecay samples = simulated(decay);
                add_line(samples, decay.rate_hz, 50, hum);
                add_line(samples, decay.rate_hz, 150, hum / 3);
                SignalSettings settings;
                const RecordedRun found = found_in(samples, decay.rate_hz, settings);
                const Errors errors = errors_of(found, decay);
                VYBEG_CLOSE_RATIO(found.told.noise_sd, 1e-3, 0.03, text(found, errors));
                VYBEG_CLOSE(errors.square, 1, errors.tolerance + 0.03, text(found, errors));
                QCOMPARE(tells(found.told.diagnostics, DiagnosticKind::offset), offset > 0);
                QCOMPARE(tells(found.told.diagnostics, DiagnosticKind::mains), hum > 0);
            }
        }
    }

    void noise_elsewhere_does_not_count() {
        // Another mode at 1900 Hz and noise of low frequencies, 20 times the white one.
        const FreeDecay decay = gyro(0, 3);
        SimulatedDecay samples = simulated(decay);
        add_line(samples, decay.rate_hz, 1900, 0.02);
        GaussianNoise noise(7);
        double slow = 0;
        for (double& x : samples.c) {
            slow = 0.95 * slow + 6e-3 * noise.next().first;
            x += slow;
        }
        const RecordedRun found = found_in(samples, decay.rate_hz, {});
        const Errors errors = errors_of(found, decay);
        // The slow noise has 0.0064 / |1 - 0.95 e^{-i w}| of its density at the carrier.
        VYBEG_CLOSE(errors.square, 1, 0.35, text(found, errors));
    }

    void a_carrier_given_beside_the_signal_is_found_data() {
        QTest::addColumn<double>("off_hz");
        QTest::addColumn<double>("split_hz");
        for (const double off : {0.0, 10.0, -31.8, 66.7, -150.0, 300.0}) {
            for (const double split : {0.0, 5.0, 40.0, 70.0}) {
                QTest::addRow("%g Hz off, split %g Hz", off, split) << off << split;
            }
        }
    }

    void a_carrier_given_beside_the_signal_is_found() {
        QFETCH(double, off_hz);
        QFETCH(double, split_hz);
        const FreeDecay decay =
            gyro(split_hz, 1 + static_cast<std::uint64_t>(std::abs(off_hz)) % 5);
        SignalSettings settings;
        settings.f0_hz = decay.f0_hz + off_hz;
        const RecordedRun found = found_in(simulated(decay), decay.rate_hz, settings);
        const double away = std::abs(found.phasors.f_ref_hz - decay.f0_hz) + split_hz / 2;
        const Errors errors = errors_of(found, decay);
        VYBEG_AT_MOST(away * found.phasors.window_s, 0.105, text(found, errors));
        VYBEG_CLOSE(errors.square, 1, errors.tolerance + 0.03, text(found, errors));
        // A main lobe is 67 Hz; the stronger mode may lie on either side.
        if (std::abs(std::abs(off_hz) - 67) > 36) {
            QCOMPARE(tells(found.told.diagnostics, DiagnosticKind::carrier_elsewhere),
                     std::abs(off_hz) > 67);
        }
    }

    void what_windows_cannot_follow_is_refused() {
        const Recording recording = simulated_recording(gyro(40, 1));
        SignalSettings settings;
        const auto long_windows = windows_of(recording, settings, 500);
        QVERIFY(!long_windows);
        QVERIFY(long_windows.error().code == ErrorCode::fit_window_turns);
        QVERIFY(windows_of(recording, settings, std::stoll(english(long_windows.error().args[3]))));
        settings.f0_hz = 6800;
        const auto nothing_there = windows_of(recording, settings);
        QVERIFY(!nothing_there);
        QVERIFY(nothing_there.error().code == ErrorCode::carrier_not_near);
        FreeDecay bell = gyro(30, 1);
        bell.f0_hz = 300;
        const auto too_fast = windows_of(simulated_recording(bell), {});
        QVERIFY(!too_fast);
        QVERIFY(too_fast.error().code == ErrorCode::fit_beat_too_fast);
    }

    void deviations_behind_a_band_pass_are_those_of_its_noise() {
        for (const double half : {20.0, 60.0, 100.0, 400.0}) {
            const FreeDecay decay = gyro(0, 2);
            SignalSettings settings;
            settings.filter = Band{decay.f0_hz - half, decay.f0_hz + half};
            const RecordedRun found = found_in(simulated(decay), decay.rate_hz, settings);
            const Errors errors = errors_of(found, decay);
            VYBEG_CLOSE_RATIO(found.told.noise_sd, 1e-3, 0.1,
                              text(found, errors) + QByteArray::number(half));
            VYBEG_CLOSE(errors.square, 1, 2 * errors.tolerance + 0.1,
                        text(found, errors) + QByteArray::number(half));
            const std::vector<double>& correlation = found.phasors.noise_correlation;
            const double expected = correlation.size() > 1 ? correlation[1] : 0;
            VYBEG_CLOSE(errors.neighbours / errors.square, expected, 0.12);
        }
    }

    void the_wave_of_a_filmed_pendulum_is_told() {
        const Pendulum pendulum;
        constexpr double rate = 8.6;
        const auto frames = static_cast<std::size_t>(pendulum.seconds * rate);
        double worst = 0;
        double sum = 0;
        constexpr int runs = 12;
        for (int seed = 1; seed <= runs; ++seed) {
            GaussianNoise noise(static_cast<std::uint64_t>(seed));
            std::vector<double> c(frames);
            std::vector<double> d(frames);
            for (std::size_t j = 0; j < frames; ++j) {
                const double t = static_cast<double>(j) / rate;
                const double theta2 = 0.4 + 2 * pendulum.turn_rad * t / pendulum.seconds;
                const double a = 100 * std::exp(-t / pendulum.tau_s);
                const double b = pendulum.quadrature(t) * a;
                const double phase = pendulum.phase(t);
                const auto [x, y] = noise.next();
                c[j] = a * std::cos(phase) * std::cos(theta2) -
                       b * std::sin(phase) * std::sin(theta2) + 0.7 * x;
                d[j] = a * std::cos(phase) * std::sin(theta2) +
                       b * std::sin(phase) * std::cos(theta2) + 0.7 * y;
                if (t < 60 && j % 9 == static_cast<std::size_t>(seed % 9)) {
                    c[j] += 30 * x;
                    d[j] -= 40 * y;
                }
            }
            const RecordedRun found = found_in({c, d, 0}, rate, {});
            const WaveMotion wave = wave_motion(found.phasors);
            // The bent phase has no slope but by the same line, weights |z|^2, of the windows
            // behind the outliers.
            std::vector<double> times = found.phasors.time_s;
            std::erase_if(times, [&](double t) { return t - found.phasors.window_s / 2 < 60; });
            double weights = 0;
            double mean_s = 0;
            for (const double t : times) {
                weights += std::exp(-2 * t / pendulum.tau_s);
                mean_s += t * std::exp(-2 * t / pendulum.tau_s);
            }
            mean_s /= weights;
            double spread = 0;
            double rise = 0;
            double growth = 0;
            for (const double t : times) {
                const double lever = std::exp(-2 * t / pendulum.tau_s) * (t - mean_s);
                spread += lever * t;
                rise += lever * (pendulum.phase(t) + pendulum.turned_phase(t)) / two_pi;
                growth += lever * pendulum.log_amplitude(t);
            }
            const std::array pulls{
                (wave.decay_per_s.value + growth / spread) / wave.decay_per_s.sd,
                (wave.theta_rate_rad_s.value - pendulum.turn_rad / pendulum.seconds) /
                    wave.theta_rate_rad_s.sd,
                (wave.quadrature_rate_per_s.value - 1e-5) / wave.quadrature_rate_per_s.sd,
                (wave.f_hz.value - rise / spread) /
                    std::hypot(wave.f_hz.sd, 1e-3 * pendulum.pull_hz)};
            qInfo("%.2f %.2f %.2f %.2f", pulls[0], pulls[1], pulls[2], pulls[3]);
            for (const double pull : pulls) {
                worst = largest_of({worst, std::abs(pull)});
                sum += pull * pull / (runs * 4);
            }
        }
        VYBEG_LESS(worst, 4);
        VYBEG_LESS(std::sqrt(sum), 1.4);
    }
};

VYBEG_TEST(TestWindowChoice)

}  // namespace test_window_choice

#include "test_window_choice.moc"
