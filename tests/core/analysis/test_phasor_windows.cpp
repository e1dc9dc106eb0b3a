// Phasors of windows against the equations of motion.
//
// Statistical model: the errors of the four real parts are independent and Gaussian with the
// deviation told; the mean of N squares in units of it has a deviation of sqrt(2/N).
#include "core/analysis/phasor_windows.h"
#include "core/recording/conditioning/conditioned_source.h"
#include "core/simulation/decay_motion.h"
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

namespace test_phasor_windows {

using namespace vybeg;
using namespace vybeg::test;

namespace {

FreeDecay bell() {
    FreeDecay decay{.seconds = 3,
                    .rate_hz = 44100,
                    .f0_hz = 1020,
                    .split_hz = 5,
                    .theta_w = 0.3,
                    .tau_s = 0.8,
                    .damping_anisotropy_per_s = 0.1};
    return decay;
}

FreeDecay gyro() {
    FreeDecay decay{.seconds = 4, .a_B = 0.1, .tau_s = 400, .noise = 1e-3};
    return decay;
}

RecordedRun phasors_of(const Recording& recording, const SignalSettings& settings,
                       std::int64_t window, int threads = 2) {
    const auto choice = needed(choose_windows(recording, settings, {.window = window}, {}));
    return needed(phasor_windows(choice, recording.rate_hz, threads, {}));
}

RecordedRun phasors_of(const FreeDecay& decay, std::int64_t window) {
    SignalSettings settings;
    settings.f0_hz = decay.f0_hz;
    return phasors_of(simulated_recording(decay), settings, window);
}

// The motion's mean over the samples of a window that is centred on a time.
Eigen::Vector2cd true_mean(const SlowMotion& motion, const FreeDecay& decay, double time_s,
                           std::int64_t window) {
    Eigen::Vector2cd sum = Eigen::Vector2cd::Zero();
    const double first = std::round(time_s * decay.rate_hz - 0.5 * static_cast<double>(window - 1));
    for (std::int64_t j = 0; j < window; ++j) {
        const double frame = first + static_cast<double>(j);
        sum += motion.at_frame(frame) * std::conj(motion.carrier(frame));
    }
    return sum / static_cast<double>(window);
}

struct Errors {
    double worst = 0;   // of the phasors, recording units
    double square = 0;  // mean, in units of the deviations told
};

Errors errors_of(const RecordedRun& found, const FreeDecay& decay) {
    const SlowMotion motion(decay);
    Errors errors;
    const PhasorRun& run = found.phasors;
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        const Eigen::Vector2cd truth = true_mean(motion, decay, run.time_s[k], found.told.window);
        const double c = std::norm(run.c[k] - truth[0]);
        const double d = std::norm(run.d[k] - truth[1]);
        errors.worst = largest_of({errors.worst, std::sqrt(c), std::sqrt(d)});
        errors.square +=
            (c + d) / (4 * run.sd[k] * run.sd[k]) / static_cast<double>(run.time_s.size());
    }
    return errors;
}

}  // namespace

class TestPhasorWindows : public QObject {
    Q_OBJECT

private slots:
    void they_are_the_mean_of_the_motion_over_the_window() {
        // 15 ms are 0.08 of the beat: its curvature is there, its third order is below 1e-5.
        const Errors resolved = errors_of(phasors_of(bell(), 661), bell());
        VYBEG_LESS(resolved.worst, 3e-5);
        FreeDecay still = gyro();
        still.noise = 0;
        const Errors unresolved = errors_of(phasors_of(still, 500), still);
        VYBEG_LESS(unresolved.worst, 1e-10);
    }

    void their_deviations_are_those_of_the_noise_and_not_of_the_beat() {
        for (FreeDecay decay : {bell(), gyro()}) {
            decay.noise = 1e-3;
            const RecordedRun found = phasors_of(decay, 512);
            VYBEG_CLOSE_RATIO(found.told.noise_sd, 1e-3, 0.01);
            const double count = 4 * static_cast<double>(found.phasors.time_s.size());
            const double square = errors_of(found, decay).square;
            VYBEG_CLOSE(square, 1, 4 * std::sqrt(2 / count) + 0.02);
        }
    }

    void short_windows_keep_their_deviations() {
        // 0.95 of a period beyond two: cos and sin, and their slopes, are far from orthogonal.
        const FreeDecay decay = gyro();
        const RecordedRun found = phasors_of(decay, 18);
        const double square = errors_of(found, decay).square;
        const double count = 4 * static_cast<double>(found.phasors.time_s.size());
        VYBEG_CLOSE(square, 1, 4 * std::sqrt(2 / count) + 0.03);
    }

    void any_number_of_threads_gives_the_same_bits() {
        FreeDecay decay = bell();
        decay.noise = 1e-3;
        const Recording recording = simulated_recording(decay);
        SignalSettings settings;
        settings.f0_hz = decay.f0_hz;
        const PhasorRun one = phasors_of(recording, settings, 300, 1).phasors;
        const PhasorRun two = phasors_of(recording, settings, 300, 2).phasors;
        QVERIFY(one.time_s == two.time_s && one.c == two.c && one.d == two.d && one.sd == two.sd);
    }

    void windows_over_missing_and_clipped_samples_are_left_out() {
        const FreeDecay decay = gyro();
        SimulatedDecay samples = simulated(decay);
        samples.c[5250] = std::numeric_limits<double>::quiet_NaN();
        for (std::size_t j = 20000; j < 20500; ++j) {
            samples.d[j] = std::clamp(samples.d[j], -0.15, 0.15);
        }
        for (double& x : samples.d) {  // the rail is the largest value anywhere
            x = std::clamp(x, -0.15, 0.15);
        }
        SignalSettings settings;
        settings.f0_hz = decay.f0_hz;
        const RecordedRun clipped =
            phasors_of(recording_of(samples.c, simulated(decay).d, 33333), settings, 500);
        QCOMPARE(clipped.phasors.time_s.size(), std::size_t{265});  // of 266
        const double missing = (10 * 500 + 249.5) / 33333;
        QVERIFY(std::ranges::none_of(clipped.phasors.time_s,
                                     [&](double t) { return std::abs(t - missing) < 1e-3; }));
        const Result<WindowChoice> choice = choose_windows(
            recording_of(simulated(decay).c, samples.d, 33333), settings, {.window = 500}, {});
        QVERIFY(choice);
        const auto none = phasor_windows(*choice, 33333, 2, {});
        QVERIFY(!none);
        QVERIFY(none.error().code == ErrorCode::every_window_clipped);
        QCOMPARE(none.error().args, std::vector<MessageArg>{"D"});
    }

    // As a decoder or a driver fills what was lost, with zeros or with the last sample.
    void windows_over_filled_samples_are_left_out() {
        FreeDecay decay = gyro();
        decay.noise = 1e-3;
        const SimulatedDecay whole = simulated(decay);
        for (const bool zeros : {true, false}) {
            SimulatedDecay samples = whole;
            for (std::size_t j = 20100; j < 21124; ++j) {
                samples.c[j] = zeros ? 0 : samples.c[20099];
                samples.d[j] = zeros ? 0 : samples.d[20099];
            }
            for (std::size_t j = 132900; j < samples.c.size(); ++j) {
                samples.c[j] = samples.d[j] = 0;
            }
            SignalSettings settings;
            settings.f0_hz = decay.f0_hz;
            const RecordedRun found =
                phasors_of(recording_of(samples.c, samples.d, 33333), settings, 500);
            const auto filled = std::ranges::find(found.told.diagnostics,
                                                  DiagnosticKind::samples_still, &Diagnostic::kind);
            QVERIFY(filled != found.told.diagnostics.end());
            QCOMPARE(filled->args[0], count_arg(2));
            VYBEG_CLOSE(filled->first_frame, 20100, 2);
            const auto frames = static_cast<std::int64_t>(samples.c.size());
            QCOMPARE(found.told.windows_used, frames / 500 - 3 - (frames / 500 - 132900 / 500));
            VYBEG_LESS(errors_of(found, decay).square, 1.2);
        }
        SignalSettings settings;
        settings.f0_hz = decay.f0_hz;
        QVERIFY(std::ranges::none_of(
            phasors_of(recording_of(whole.c, whole.d, 33333), settings, 500).told.diagnostics,
            [](const Diagnostic& told) { return told.kind == DiagnosticKind::samples_still; }));
    }

    void the_phase_runs_on_behind_a_lost_sample() {
        const FreeDecay decay = gyro();
        SimulatedDecay samples = simulated(decay);
        const std::ptrdiff_t lost = 66000;
        samples.c.erase(samples.c.begin() + lost);
        samples.d.erase(samples.d.begin() + lost);
        SignalSettings settings;
        settings.f0_hz = decay.f0_hz;
        const RecordedRun found =
            phasors_of(recording_of(samples.c, samples.d, 33333), settings, 512);
        QCOMPARE(found.phasors.time_s.size(), static_cast<std::size_t>(found.told.windows - 1));
        QCOMPARE(std::ranges::count(found.told.diagnostics, DiagnosticKind::lost_counted,
                                    &Diagnostic::kind),
                 1);
        const double square = errors_of(found, decay).square;
        VYBEG_LESS(square, 1.2);
    }

    void the_phase_after_an_ambiguous_loss_is_a_break() {
        for (const double noise : {1e-3, 1e-2}) {
            for (const std::ptrdiff_t lost_at : {30011, 66000}) {
                FreeDecay decay = gyro();
                decay.noise = noise;
                SimulatedDecay samples = simulated(decay);
                for (std::vector<double>* x : {&samples.c, &samples.d}) {
                    x->erase(x->begin() + lost_at, x->begin() + lost_at + 40);
                }
                SignalSettings settings;
                settings.f0_hz = decay.f0_hz;
                const RecordedRun found =
                    phasors_of(recording_of(samples.c, samples.d, 33333), settings, 512);
                QCOMPARE(found.phasors.breaks.size(), std::size_t{1});
                const double at = static_cast<double>(lost_at) / 33333;
                VYBEG_CLOSE(found.phasors.breaks[0].time_s, at, 1e-4);
                QCOMPARE(std::ranges::count(found.told.diagnostics, DiagnosticKind::phase_unknown,
                                            &Diagnostic::kind),
                         1);
                QCOMPARE(std::ranges::count(found.told.diagnostics, DiagnosticKind::lost_counted,
                                            &Diagnostic::kind),
                         0);
                // Up to one constant phase each side is the motion; 1.3 ms change nothing in it.
                const SlowMotion motion(decay);
                std::complex<double> turn = 0;
                double size = 0;
                for (std::size_t k = 0; k < found.phasors.time_s.size(); ++k) {
                    if (found.phasors.time_s[k] > at) {
                        const auto truth = true_mean(motion, decay, found.phasors.time_s[k], 512);
                        turn += std::conj(truth[0]) * found.phasors.c[k] +
                                std::conj(truth[1]) * found.phasors.d[k];
                        size += truth.squaredNorm();
                    }
                }
                // Modulo the period the phase is right, within what the step was told to.
                VYBEG_CLOSE(std::arg(turn), 0, 0.05);
                VYBEG_CLOSE_RATIO(std::abs(turn), size, 1e-3);
            }
        }
    }

    void a_channel_below_one_bit_leaves_the_windows_of_the_other() {
        FreeDecay decay = gyro();
        decay.a_B = 0;
        for (const double share : {0.3, 0.497}) {
            SimulatedDecay samples = simulated(decay);
            for (double& x : samples.d) {
                x = 1e-3 * std::round(0.01 * x + share);
            }
            SignalSettings settings;
            settings.f0_hz = decay.f0_hz;
            const RecordedRun found =
                phasors_of(recording_of(samples.c, samples.d, 33333), settings, 500);
            QCOMPARE(found.phasors.time_s.size(), std::size_t{266});
        }
    }

    void what_is_no_free_decay_yet_is_left_out() {
        const FreeDecay decay = gyro();
        SimulatedDecay samples = simulated(decay);
        // Half a second of silence before the strike.
        std::vector<double> c(16666, 0.0);
        std::vector<double> d(16666, 0.0);
        c.insert(c.end(), samples.c.begin(), samples.c.end());
        d.insert(d.end(), samples.d.begin(), samples.d.end());
        SignalSettings settings;
        settings.f0_hz = decay.f0_hz;
        const RecordedRun struck = phasors_of(recording_of(c, d, 33333), settings, 500);
        VYBEG_MORE(struck.phasors.time_s.front(), 0.5);
        VYBEG_LESS(struck.phasors.time_s.front(), 0.54);
        const auto told = [](const RecordedRun& found) {
            return std::ranges::count(found.told.diagnostics, DiagnosticKind::strike_left_out,
                                      &Diagnostic::kind);
        };
        QCOMPARE(told(struck), 1);
        const RecordedRun plain = phasors_of(decay, 500);
        QCOMPARE(told(plain), 0);
        QCOMPARE(plain.phasors.time_s.size(), static_cast<std::size_t>(plain.told.windows));
        // Behind a band-pass, its reach at both ends, and once more at the start.
        settings.filter = Band{5200, 5400};
        const RecordedRun filtered =
            phasors_of(recording_of(samples.c, samples.d, 33333), settings, 500);
        const double reach = static_cast<double>(band_pass_reach(5200, 5400, 33333)) / 33333;
        VYBEG_CLOSE(filtered.phasors.time_s.front(), 2 * reach, 0.035);
        QCOMPARE(told(filtered), 1);
    }

    void the_angle_of_the_first_electrode_is_subtracted() {
        const FreeDecay decay = gyro();
        SignalSettings settings;
        settings.f0_hz = decay.f0_hz;
        settings.calibration.angle_zero_deg = 7;
        const PhasorRun run = phasors_of(simulated_recording(decay), settings, 500).phasors;
        const WaveState state = to_wave_state({run.c[0], run.d[0]});
        VYBEG_CLOSE(state.two_theta_A - 0.3, -14 * std::numbers::pi / 180, 1e-3);
    }

    void the_default_window_is_bounded_in_length_and_number() {
        QCOMPARE(default_phasor_window(933324, 5300, 33333), std::int64_t{500});
        QCOMPARE(default_phasor_window(200000, 100, 33333), std::int64_t{3125});  // frames / 64
        QCOMPARE(default_phasor_window(2000000, 100, 33333), std::int64_t{4000});
        const std::int64_t hour = default_phasor_window(119998800, 5300, 33333);
        VYBEG_AT_MOST(119998800 / hour, 16384);
        VYBEG_MORE(119998800 / hour, 16000);
        QCOMPARE(default_phasor_window(300, 5300, 33333), std::int64_t{16});
        QCOMPARE(least_phasor_window(100, 33333), std::int64_t{667});
    }

    void a_stop_is_heard() {
        std::stop_source stop;
        stop.request_stop();
        const Recording recording = simulated_recording(gyro());
        SignalSettings settings;
        settings.f0_hz = 5300;
        const Result<WindowChoice> choice =
            choose_windows(recording, settings, {.window = 500}, {});
        QVERIFY(choice);
        const auto found = phasor_windows(*choice, 33333, 2, JobControl(stop.get_token()));
        QVERIFY(!found);
        QVERIFY(found.error().code == ErrorCode::interrupted);
    }
};

VYBEG_TEST(TestPhasorWindows, threads)

}  // namespace test_phasor_windows

#include "test_phasor_windows.moc"
