#include "core/analysis/analyse.h"
#include "core/estimators/wave/wave_formulas.h"
#include "core/simulation/simulate.h"
#include "core/sweep/window_sweep.h"
#include "tests/closeness.h"
#include "tests/needed.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <numbers>
#include <random>
#include <stop_token>
#include <thread>

namespace test_window_sweep {

using namespace vybeg;

namespace {

constexpr std::size_t a_A = 0;
constexpr std::size_t a_B = 1;
constexpr std::size_t two_theta_A = 2;
constexpr std::size_t f = 3;
constexpr std::size_t delta_phi_CD = 4;

FreeDecay still_wave() {
    FreeDecay decay{.seconds = 6, .a_B = 0.2, .noise = 1e-3};
    return decay;
}

// A beat of 1 Hz, in which all five variables move, at an amplitude that decays.
FreeDecay beating_wave() {
    FreeDecay decay = still_wave();
    decay.a_B = 0;
    decay.split_hz = 1;
    decay.theta_w = 0.35;
    decay.tau_s = 5;
    return decay;
}

Settings with(Algorithm algorithm) {
    Settings settings;
    settings.algorithm = algorithm;
    return settings;
}

WindowSweep sweep_of(const Recording& recording, const std::vector<std::int64_t>& lengths,
                     const Settings& settings = {}) {
    return test::needed(sweep_windows(recording, settings, lengths, JobControl()));
}

WindowSweep sweep_of(const FreeDecay& decay, const std::vector<std::int64_t>& lengths,
                     const Settings& settings = {}) {
    return sweep_of(test::simulated_recording(decay), lengths, settings);
}

Track track_of(const FreeDecay& decay, std::int64_t window, Settings settings = {}) {
    settings.window = window;
    return test::needed(analyse(test::simulated_recording(decay), settings, JobControl())).track;
}

// Differences of two tracks, of angles modulo a half turn.
std::vector<double> differences(const Track& a, const Track& b, SlowVariable variable) {
    std::vector<double> found;
    for (std::size_t k = 0; k < a.rows(); ++k) {
        const double difference = a.values(variable)[k] - b.values(variable)[k];
        found.push_back(variable == SlowVariable::two_theta_A ||
                                variable == SlowVariable::delta_phi_CD
                            ? std::remainder(difference, std::numbers::pi)
                            : difference);
    }
    return found;
}

}  // namespace

class TestWindowSweep : public QObject {
    Q_OBJECT

private slots:
    void lengths_are_spaced_in_equal_ratios() {
        const auto lengths = spaced_lengths(6, 600);
        QCOMPARE(lengths.size(), std::size_t(15));
        QCOMPARE(lengths.front(), 6);
        QCOMPARE(lengths[7], 60);
        QCOMPARE(lengths.back(), 600);
        QCOMPARE(spaced_lengths(5, 7), (std::vector<std::int64_t>{5, 6, 7}));
        QCOMPARE(spaced_lengths(9, 9), (std::vector<std::int64_t>{9}));
    }

    // A still wave in white noise: scatter, stated sd and bound are one number.
    void white_noise_scatters_as_the_bound_and_as_stated() {
        const FreeDecay decay = still_wave();
        const WindowSweep sweep = sweep_of(decay, {22, 63, 600});
        VYBEG_CLOSE_RATIO(sweep.white_noise, decay.noise, 0.01);
        QCOMPARE(sweep.lengths.size(), std::size_t(3));
        for (const SweepLength& each : sweep.lengths) {
            const auto n = static_cast<double>(each.length);
            const double power = 1.04;
            const double amplitude = decay.noise * std::sqrt(2 / n);
            const double angle = amplitude * std::sqrt(power) / 0.96;
            const double hz = decay.noise * decay.rate_hz *
                              std::sqrt(24 / (power * n * (n * n - 1))) / (2 * std::numbers::pi);
            const std::array method{amplitude, amplitude, angle, hz};
            for (std::size_t v = 0; v < method.size(); ++v) {
                const SweepValue& value = each.values[v];
                const QString where = QString("n = %1, variable %2").arg(n).arg(v);
                VYBEG_CLOSE_RATIO(value.bound, method[v], 0.02, qPrintable(where));
                VYBEG_CLOSE_RATIO(value.stated, method[v], 0.02, qPrintable(where));
                // Five of its own standard deviations, which are 8 % for the 333 windows of 600.
                VYBEG_CLOSE(value.scatter, method[v], 5 * value.sd_scatter, qPrintable(where));
                VYBEG_CLOSE_RATIO(
                    value.sd_scatter,
                    value.scatter * std::sqrt(3.17 / (2 * static_cast<double>(each.windows))), 0.05,
                    qPrintable(where));
                VYBEG_CLOSE(value.motion, 0, 0.1 * value.scatter, qPrintable(where));
            }
            VYBEG_CLOSE_RATIO(each.noise, decay.noise, 0.02);
            VYBEG_CLOSE_RATIO(each.rms, decay.noise * std::sqrt(2 - 5 / n), 0.02);
            QCOMPARE(each.used, each.windows);
        }
    }

    void the_deviation_of_the_scatter_is_its_own() {
        std::vector<double> off;
        for (std::uint64_t seed = 1; seed <= 24; ++seed) {
            FreeDecay decay = still_wave();
            decay.seconds = 2;
            decay.seed = seed;
            const SweepLength found = sweep_of(decay, {600}).lengths.front();
            for (const std::size_t v : {a_A, two_theta_A, f}) {
                const SweepValue& value = found.values[v];
                off.push_back((value.scatter - value.bound) / value.sd_scatter);
            }
        }
        // 72 numbers of sd 1: their root mean square is known to 8 %; two parts in a hundred are
        // the noise of the bound.
        VYBEG_CLOSE(test::rms_of(off), 1, 0.3);
    }

    void slow_motion_does_not_move_the_scatter() {
        const FreeDecay decay = beating_wave();
        const WindowSweep sweep = sweep_of(decay, {60, 200, 600});
        for (const SweepLength& each : sweep.lengths) {
            const Track track = track_of(decay, each.length);
            const Track truth = *true_track(decay, each.length);
            for (const std::size_t v : {a_A, a_B, two_theta_A, f}) {
                const SweepValue& value = each.values[v];
                const QString where = QString("n = %1, variable %2").arg(each.length).arg(v);
                VYBEG_CLOSE(value.scatter, value.bound, 5 * value.sd_scatter + 0.02 * value.bound,
                            qPrintable(where));
            }
            // First differences would be moved.
            if (each.length == 600) {
                std::vector<double> steps;
                const auto angle = track.values(SlowVariable::two_theta_A);
                for (std::size_t k = 1; k < angle.size(); ++k) {
                    steps.push_back((angle[k] - angle[k - 1]) / std::sqrt(2.0));
                }
                VYBEG_MORE(test::rms_of(steps), 50 * each.values[two_theta_A].scatter);
            }
        }
    }

    void motion_has_the_size_of_the_shift_of_a_windows_mean() {
        FreeDecay decay = beating_wave();
        decay.noise = 1e-5;
        decay.tau_s = 1e300;
        const SweepLength found = sweep_of(decay, {600}).lengths.front();
        const Track track = track_of(decay, 600);
        const Track truth = *true_track(decay, 600);
        for (const std::size_t v : {a_B, two_theta_A}) {
            const double shift = test::rms_of(differences(track, truth, main_slow_variables[v]));
            // x'' T^2/24 is the shift of a mean; the wave of a window follows its phasors, whose
            // turn adds another term of this size.
            VYBEG_MORE(found.values[v].motion, shift / 1.6);
            VYBEG_LESS(found.values[v].motion, shift * 1.6);
            VYBEG_MORE(found.values[v].motion, 5 * found.values[v].scatter);
        }
    }

    void disturbed_windows_do_not_matter() {
        const FreeDecay decay = still_wave();
        SimulatedDecay samples = test::simulated(decay);
        const WindowSweep before =
            sweep_of(test::recording_of(samples.c, samples.d, decay.rate_hz), {60});
        for (std::size_t k = 1000; k < samples.c.size(); k += 12000) {  // one window of 200
            samples.c[k] += 0.7;
            samples.d[k + 3] -= 0.4;
        }
        const WindowSweep after = sweep_of(
            test::recording_of(std::move(samples.c), std::move(samples.d), decay.rate_hz), {60});
        for (std::size_t v = 0; v < sweep_variable_count; ++v) {
            VYBEG_CLOSE_RATIO(after.lengths[0].values[v].scatter,
                              before.lengths[0].values[v].scatter, 0.04);
        }
    }

    // The systematic error of the closed forms against that of the track of a recording with
    // hardly any noise.
    void leakage_is_that_of_the_windows() {
        FreeDecay decay = still_wave();
        decay.noise = 1e-9;
        decay.seconds = 2;
        const Track truth = *true_track(decay, 60);
        const WindowSweep sweep = sweep_of(decay, {22, 60});
        for (std::size_t k = 0; k < closed_form_algorithms.size(); ++k) {
            const Track track = track_of(decay, 60, with(closed_form_algorithms[k]));
            for (const std::size_t v : {a_A, a_B, two_theta_A, f, delta_phi_CD}) {
                const SlowVariable variable = main_slow_variables[v];
                const double leakage = sweep.lengths[1].values[v].leakage[k];
                if (std::isnan(track.values(variable)[100])) {
                    QVERIFY(std::isnan(leakage));
                    continue;
                }
                const QString where = QString("algorithm %1, variable %2").arg(k + 1).arg(v);
                std::vector<double> errors = differences(track, truth, variable);
                errors.erase(errors.begin());  // the delay reaches beyond the samples
                errors.pop_back();
                VYBEG_CLOSE(leakage, test::rms_of(errors), 0.1 * test::rms_of(errors) + 1e-8,
                            qPrintable(where));
            }
        }
        // Whole half-periods leave little, of all but the quadrature that algorithm 1 omits.
        for (std::size_t k = 1; k < closed_form_algorithms.size(); ++k) {
            VYBEG_LESS(sweep.lengths[0].values[a_A].leakage[k],
                       0.3 * sweep.lengths[1].values[a_A].leakage[k]);
        }
    }

    void the_deviations_of_closed_forms_contain_their_leakage() {
        const FreeDecay decay = still_wave();
        const WindowSweep sweep = sweep_of(decay, {60}, with(Algorithm::demodulation));
        const SweepValue& value = sweep.lengths[0].values[two_theta_A];
        VYBEG_MORE(value.leakage[3], value.bound);
        VYBEG_CLOSE_RATIO(value.stated, std::hypot(value.bound, value.leakage[3]), 0.08);
    }

    void a_band_pass_lowers_the_bound_of_short_windows() {
        Settings settings;
        settings.filter = Band{4800, 5800};
        const WindowSweep sweep = sweep_of(still_wave(), {22, 600}, settings);
        const double unit = 1e-3 * std::sqrt(2.0);
        VYBEG_LESS(sweep.lengths[0].values[a_A].bound, 0.92 * unit / std::sqrt(22.0));
        VYBEG_CLOSE_RATIO(sweep.lengths[1].values[a_A].bound, unit / std::sqrt(600.0), 0.06);
        VYBEG_CLOSE_RATIO(sweep.lengths[1].values[a_A].stated, sweep.lengths[1].values[a_A].bound,
                          0.02);
        VYBEG_LESS(sweep.lengths[0].used, sweep.lengths[0].windows);  // the transients
    }

    void snap_moves_lengths_and_drops_doubles() {
        Settings settings;
        settings.snap = true;
        const WindowSweep sweep = sweep_of(still_wave(), {21, 22, 60}, settings);
        QCOMPARE(sweep.lengths.size(), std::size_t(2));
        QCOMPARE(sweep.lengths[0].length, 22);
        QCOMPARE(sweep.lengths[1].length, 63);
    }

    void impossible_lengths_are_refused_with_their_reason() {
        const Recording recording = test::simulated_recording(still_wave());
        const WindowSweep sweep = sweep_of(recording, {3, 60, 1000000});
        QCOMPARE(sweep.lengths.size(), std::size_t(1));
        QCOMPARE(sweep.refused.size(), std::size_t(2));
        QCOMPARE(sweep.refused[0].error.code, ErrorCode::window_too_short);
        QCOMPARE(sweep.refused[1].error.code, ErrorCode::window_too_long);
        QVERIFY(!sweep.advice);
        const std::vector<std::int64_t> none{3};
        const auto refused = sweep_windows(recording, Settings(), none, JobControl());
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::window_too_short);
    }

    // Too few windows for a scatter: none, and no number in its place.
    void few_windows_have_no_scatter() {
        const WindowSweep sweep = sweep_of(still_wave(), {20000});
        QCOMPARE(sweep.lengths[0].windows, 9);
        QVERIFY(std::isnan(sweep.lengths[0].values[a_A].scatter));
        QVERIFY(std::isnan(sweep.lengths[0].values[a_A].error()));
    }

    void the_bits_do_not_depend_on_the_threads() {
        const Recording recording = test::simulated_recording(beating_wave());
        Settings settings;
        settings.threads = 1;
        const WindowSweep one = sweep_of(recording, {6, 60}, settings);
        settings.threads = 2;
        const WindowSweep two = sweep_of(recording, {6, 60}, settings);
        QCOMPARE(one.white_noise, two.white_noise);
        for (std::size_t k = 0; k < one.lengths.size(); ++k) {
            QCOMPARE(one.lengths[k].rms, two.lengths[k].rms);
            for (std::size_t v = 0; v < sweep_variable_count; ++v) {
                QCOMPARE(one.lengths[k].values[v].scatter, two.lengths[k].values[v].scatter);
                QCOMPARE(one.lengths[k].values[v].motion, two.lengths[k].values[v].motion);
                QCOMPARE(one.lengths[k].values[v].stated, two.lengths[k].values[v].stated);
            }
        }
    }

    void progress_rises_and_a_cancelled_sweep_is_interrupted() {
        const Recording recording = test::simulated_recording(still_wave());
        std::vector<double> told;
        const JobControl job({}, [&told](double fraction) { told.push_back(fraction); });
        const auto lengths = spaced_lengths(6, 600);
        QVERIFY(sweep_windows(recording, Settings(), lengths, job));
        VYBEG_AT_LEAST(told.size(), lengths.size());
        QVERIFY(std::ranges::is_sorted(told));
        VYBEG_CLOSE(told.back(), 1, 1e-9);
        std::stop_source stop;
        const JobControl stopping(stop.get_token(), [&stop](double fraction) {
            if (fraction > 0.3) {
                stop.request_stop();
            }
        });
        const auto stopped = sweep_windows(recording, Settings(), lengths, stopping);
        QVERIFY(!stopped);
        QCOMPARE(stopped.error().code, ErrorCode::interrupted);
    }

    // At 20 moments, or as many as VYBEG_SIGNALS says.
    void a_sweep_is_left_within_a_second() {
        FreeDecay short_decay = still_wave();
        short_decay.tau_s = 0.1;
        const std::array recordings{test::simulated_recording(beating_wave()),
                                    test::simulated_recording(short_decay)};
        const auto lengths = spaced_lengths(6, 6000);
        bool given = false;
        const int wanted = qEnvironmentVariableIntValue("VYBEG_SIGNALS", &given);
        std::mt19937_64 random(24);
        int stopped = 0;
        for (int k = 0; k < (given ? wanted : 20); ++k) {
            const Recording& recording = recordings[static_cast<std::size_t>(k) % 2];
            std::stop_source stop;
            bool interrupted = false;
            std::thread work([&] {
                const auto sweep =
                    sweep_windows(recording, Settings(), lengths, JobControl(stop.get_token()));
                interrupted = !sweep && sweep.error().code == ErrorCode::interrupted;
            });
            const int after_ms = std::uniform_int_distribution<int>(0, 400)(random);
            QTest::qSleep(after_ms);  // the moment of the stop
            QElapsedTimer timer;
            timer.start();
            stop.request_stop();
            work.join();
            stopped += interrupted ? 1 : 0;
            VYBEG_LESS(timer.elapsed(), 1000, qPrintable(QString("after %1 ms").arg(after_ms)));
        }
        VYBEG_MORE(stopped, 0);
    }
};

VYBEG_TEST(TestWindowSweep, threads)

}  // namespace test_window_sweep

#include "test_window_sweep.moc"
