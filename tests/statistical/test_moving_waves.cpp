#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/numerics/control_chart.h"
#include "core/simulation/simulate.h"
#include "core/track/events.h"
#include "tests/closeness.h"
#include "tests/largest_of.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/statistical/track_errors.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace test_moving_waves {

using namespace vybeg;
using namespace vybeg::test;

namespace {

// Instants at which the finely sampled truth, unwrapped, passes an axis.
std::vector<double> true_crossings(const Track& truth) {
    std::vector<double> times;
    const auto angle = truth.values(SlowVariable::two_theta_A);
    constexpr double half_pi = std::numbers::pi / 2;
    for (std::size_t k = 1; k < truth.rows(); ++k) {
        if (std::floor(angle[k - 1] / half_pi) != std::floor(angle[k] / half_pi)) {
            times.push_back(0.5 * (truth.time_s()[k - 1] + truth.time_s()[k]));
        }
    }
    return times;
}

}  // namespace

// Waves that move inside their windows, or far from one window to the next, from samples.
class TestMovingWaves : public QObject {
    Q_OBJECT

private slots:
    void what_is_not_flagged_is_right_data() {
        QTest::addColumn<double>("split");
        QTest::addColumn<double>("axis");
        QTest::addColumn<int>("n");
        QTest::addColumn<int>("hop");
        for (const double split : {0.0, 0.05, 0.5, 2.0, 5.0, 9.0}) {
            for (const double axis : {0.1, 0.39, 0.7}) {
                for (const int n : {60, 300, 2000}) {
                    for (const int hop : {n / 2, n, 3 * n}) {
                        QTest::addRow("split %g Hz, axis %g, n %d, hop %d", split, axis, n, hop)
                            << split << axis << n << hop;
                    }
                }
            }
        }
    }
    void what_is_not_flagged_is_right() {
        QFETCH(double, split);
        QFETCH(double, axis);
        QFETCH(int, n);
        QFETCH(int, hop);
        double values = 0;
        double beyond = 0;
        double unflagged = 0;
        double windows = 0;
        double still = 0;
        double still_unflagged = 0;
        double worst = 0;
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            FreeDecay wave{.seconds = 8,
                           .two_theta_A = 0.3 * static_cast<double>(seed),
                           .split_hz = split,
                           .theta_w = axis,
                           .tau_s = 5,
                           .omega_rad_s = seed == 1 ? 0 : 0.5,
                           .noise = 1e-3,
                           .seed = seed};
            Settings settings;
            settings.window = n;
            settings.hop = hop;
            const Result<Analysis> analysis = analyse(simulated_recording(wave), settings, {});
            QVERIFY(analysis);
            const Track& track = analysis->track;
            // Truth at every half window, the first centre being that of the first window.
            const Result<Track> truth = true_track(wave, n);
            QVERIFY(truth);
            wave.noise = 0;
            const Result<Analysis> quiet = analyse(simulated_recording(wave), settings, {});
            QVERIFY(quiet);
            // Largest bias of the window, in deviations: what it is off by without noise.
            const auto bias_of = [&](std::size_t k, std::size_t true_row) {
                double largest = 0;
                for (const SlowVariable variable : variables_with_sd) {
                    largest = largest_of(
                        {largest, std::abs(error_of(quiet->track, *truth, variable, k, true_row)) /
                                      track.sds(variable)[k]});
                }
                return largest;
            };
            for (std::size_t k = 0; k < track.rows(); ++k) {
                windows += 1;
                const std::size_t row_at = k * static_cast<std::size_t>(hop);
                if (split <= 0.05 && row_at % static_cast<std::size_t>(n) == 0 &&
                    bias_of(k, row_at / static_cast<std::size_t>(n)) < 0.25) {
                    still += 1;
                    still_unflagged += track.flags()[k] == 0 ? 1 : 0;
                }
                if (track.flags()[k] != 0) {
                    continue;
                }
                unflagged += 1;
                const std::size_t at = k * static_cast<std::size_t>(hop);
                if (at % static_cast<std::size_t>(n) != 0) {
                    continue;
                }
                for (const SlowVariable variable : variables_with_sd) {
                    const double pull = std::abs(error_of(track, *truth, variable, k,
                                                          at / static_cast<std::size_t>(n))) /
                                        track.sds(variable)[k];
                    if (std::isnan(pull)) {
                        continue;
                    }
                    values += 1;
                    beyond += pull > 4 ? 1 : 0;
                    worst = largest_of({worst, pull});
                }
            }
        }
        const QString found = QString("%1 of %2 values beyond 4 sd, worst %3; %4 of %5 unflagged")
                                  .arg(beyond)
                                  .arg(values)
                                  .arg(worst)
                                  .arg(unflagged)
                                  .arg(windows);
        qInfo("%s", qPrintable(found));
        const double expected = values * student_beyond(4, 2 * n - 5);
        VYBEG_AT_MOST(beyond, expected + 5 * std::sqrt(expected) + 2, qPrintable(found));
        VYBEG_LESS(worst, 8, qPrintable(found));
        // What does not move is not flagged.
        if (split <= 0.05) {
            VYBEG_AT_LEAST(still, 30, qPrintable(found));
            VYBEG_MORE(still_unflagged, 0.99 * still,
                       qPrintable(QString("%1 of %2 still ones").arg(still_unflagged).arg(still)));
        }
    }

    // Root of the mean square pull of each variable over the windows without a flag.
    void deviations_of_unflagged_windows_are_right_data() {
        QTest::addColumn<double>("decibels");
        QTest::addColumn<double>("split");
        QTest::addColumn<int>("n");
        for (const double decibels : {20.0, 60.0, 100.0}) {
            for (const double split : {0.0, 5.0, 20.0}) {
                for (const int n : {6, 60, 600, 2000, 6000}) {
                    QTest::addRow("%g dB, split %g Hz, n %d", decibels, split, n)
                        << decibels << split << n;
                }
            }
        }
    }
    void deviations_of_unflagged_windows_are_right() {
        QFETCH(double, decibels);
        QFETCH(double, split);
        QFETCH(int, n);
        std::array<double, variables_with_sd.size()> squares{};
        std::array<double, variables_with_sd.size()> biases{};
        double count = 0;
        double windows = 0;
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            FreeDecay wave{.seconds = n == 6     ? 1.0
                                      : n < 2000 ? 4.0
                                                 : 12.0,
                           .a_B = 0.05,
                           .two_theta_A = 0.3 * static_cast<double>(seed),
                           .split_hz = split,
                           .theta_w = seed == 1 ? 0.1 : 0.39,
                           .tau_s = 20,
                           .noise = std::pow(10, -decibels / 20),
                           .seed = seed + static_cast<std::uint64_t>(n)};
            Settings settings;
            settings.window = n;
            settings.f0_hz = wave.f0_hz;
            const Result<Analysis> analysis = analyse(simulated_recording(wave), settings, {});
            QVERIFY(analysis);
            const Result<Track> truth = true_track(wave, n);
            QVERIFY(truth);
            const Track& track = analysis->track;
            windows += static_cast<double>(track.rows());
            wave.noise = 0;
            const Result<Analysis> quiet = analyse(simulated_recording(wave), settings, {});
            QVERIFY(quiet);
            for (std::size_t k = 0; k < track.rows(); ++k) {
                for (std::size_t v = 0; v < biases.size(); ++v) {
                    const double bias = error_of(quiet->track, *truth, variables_with_sd[v], k, k) /
                                        track.sds(variables_with_sd[v])[k];
                    biases[v] += std::isfinite(bias) ? bias * bias : 0;
                }
                if (track.flags()[k] != 0) {
                    continue;
                }
                count += 1;
                for (std::size_t v = 0; v < squares.size(); ++v) {
                    const double pull = error_of(track, *truth, variables_with_sd[v], k, k) /
                                        track.sds(variables_with_sd[v])[k];
                    squares[v] += pull * pull;
                }
            }
        }
        // A decay moves the wave, too: the bias is what windows without noise are off by.
        if (split == 0) {
            const double bias = std::sqrt(std::ranges::max(biases) / windows);
            const QString found = QString("%1 of %2 unflagged, rms bias %3 deviations")
                                      .arg(count)
                                      .arg(windows)
                                      .arg(bias);
            qInfo("%s", qPrintable(found));
            if (bias < 0.3) {
                VYBEG_MORE(count, 0.99 * windows, qPrintable(found));
            }
            if (bias > 0.8) {
                VYBEG_LESS(count, 0.01 * windows + 1, qPrintable(found));
            }
        }
        if (count < 30) {
            return;  // all but the quiet ones are flagged, and so few determine no deviation
        }
        const double uncertain = 4 / std::sqrt(2 * count);
        for (std::size_t v = 0; v < squares.size(); ++v) {
            const double rms = std::sqrt(squares[v] / count);
            const QString found = QString("%1: rms pull %2 of %3 windows of %4")
                                      .arg(info(variables_with_sd[v]).column)
                                      .arg(rms)
                                      .arg(count)
                                      .arg(windows);
            VYBEG_CLOSE(rms, 1, 0.2 + uncertain, qPrintable(found));
        }
    }

    // Near a whole number of beats neighbours are alike, and the residual alone shows the motion.
    void whole_beats_in_a_window_are_flagged_data() {
        QTest::addColumn<double>("split");
        QTest::addColumn<int>("n");
        QTest::addColumn<double>("noise");
        for (const double noise : {1e-1, 1e-3}) {
            QTest::newRow("0.9 beats") << 5.0 << 6000 << noise;
            QTest::newRow("1.2 beats") << 20.0 << 2000 << noise;
            QTest::newRow("2.0 beats") << 5.0 << 13333 << noise;
            QTest::newRow("6 beats") << 20.0 << 10000 << noise;
        }
    }
    void whole_beats_in_a_window_are_flagged() {
        QFETCH(double, split);
        QFETCH(int, n);
        QFETCH(double, noise);
        const FreeDecay wave{.seconds = 16, .split_hz = split, .theta_w = 0.39, .noise = noise};
        Settings settings;
        settings.window = n;
        const Result<Analysis> analysis = analyse(simulated_recording(wave), settings, {});
        QVERIFY(analysis);
        for (const Flags flags : analysis->track.flags()) {
            QVERIFY(flags != 0);
        }
    }

    // White noise behind offset and hum or a band-pass is no motion.
    void noise_is_no_motion_data() {
        QTest::addColumn<int>("n");
        QTest::addColumn<double>("hum");
        QTest::addColumn<double>("offset");
        QTest::addColumn<bool>("filter");
        for (const int n : {5, 6, 9, 22, 60, 100, 200, 600, 2000, 6000, 100000}) {
            QTest::addRow("n %d", n) << n << 0.0 << 0.0 << false;
            QTest::addRow("n %d, hum and offset", n) << n << 0.03 << 0.03 << false;
            // At the centres of windows of 2000 samples, three periods, it has one phase.
            QTest::addRow("n %d, hum", n) << n << 0.1 << 0.0 << false;
            QTest::addRow("n %d, filter", n) << n << 0.0 << 0.0 << true;
        }
    }
    void noise_is_no_motion() {
        QFETCH(int, n);
        QFETCH(double, hum);
        QFETCH(double, offset);
        QFETCH(bool, filter);
        FreeDecay wave{.seconds = n < 10000 ? 8.0 : 30.0,
                       .a_B = 0.2,
                       .noise = 1e-3,
                       .offset_c = offset,
                       .seed = static_cast<std::uint64_t>(n),
                       .hum = hum};
        // Windows of whole hum periods have a zero of it at their centres.
        wave.hum_phase = 1.57;
        Settings settings;
        settings.window = n;
        settings.f0_hz = wave.f0_hz;
        if (filter) {
            settings.filter = Band{5200, 5400};
        }
        const Result<Analysis> analysis = analyse(simulated_recording(wave), settings, {});
        QVERIFY(analysis);
        double moving = 0;
        for (const Flags flags : analysis->track.flags()) {
            moving += has(flags, Flag::moving) && !has(flags, Flag::filter_transient) ? 1 : 0;
        }
        // A bend marks three windows.
        VYBEG_AT_MOST(moving, 1e-4 * static_cast<double>(analysis->track.rows()) + 3);
    }

    // One window and two have no neighbours that show a bend.
    void few_windows_are_flagged_where_the_wave_moves_inside() {
        int steady = 0;
        int steady_flagged = 0;
        int flagged = 0;
        double worst = 0;
        for (const double split : {0.0, 0.01, 0.3}) {
            for (const double tau_s : {1e300, 400.0, 20.0}) {
                for (const int windows : {1, 2}) {
                    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
                        const FreeDecay wave{.seconds = 5,
                                             .a_B = seed % 2 == 0 ? 0.1 : -0.1,
                                             .two_theta_A = 0.8 * static_cast<double>(seed),
                                             .split_hz = split,
                                             .theta_w = 0.2,
                                             .tau_s = tau_s,
                                             .noise = seed > 4 ? 1e-2 : 1e-3,
                                             .seed = seed};
                        Settings settings;
                        settings.window = 166000 / windows;
                        const Result<Analysis> analysis =
                            analyse(simulated_recording(wave), settings, {});
                        const Result<Track> truth = true_track(wave, settings.window);
                        QVERIFY(analysis && truth);
                        const Track& track = analysis->track;
                        VYBEG_EQUAL(track.rows(), static_cast<std::size_t>(windows));
                        for (std::size_t k = 0; k < track.rows(); ++k) {
                            const bool moves = has(track.flags()[k], Flag::moving);
                            flagged += moves ? 1 : 0;
                            if (split == 0 && tau_s > 1000) {
                                steady += 1;
                                steady_flagged += moves ? 1 : 0;
                            }
                            for (const SlowVariable variable : variables_with_sd) {
                                const double off = error_of(track, *truth, variable, k, k);
                                worst =
                                    moves ? worst
                                          : std::max(worst, std::abs(off) / track.sds(variable)[k]);
                            }
                        }
                    }
                }
            }
        }
        qInfo("%d flagged, of %d steady ones %d, worst pull of the others %.1f", flagged, steady,
              steady_flagged, worst);
        VYBEG_EQUAL(steady_flagged, 0);
        VYBEG_AT_LEAST(flagged, 50);
        VYBEG_AT_MOST(worst, 4.5);
    }

    void a_knock_is_flagged_data() {
        QTest::addColumn<int>("n");
        for (const int n : {6, 60, 600, 6000}) {
            QTest::addRow("n %d", n) << n;
        }
    }
    void a_knock_is_flagged() {
        QFETCH(int, n);
        const FreeDecay wave{.seconds = 4, .noise = 1e-3};
        SimulatedDecay samples = simulated(wave);
        const std::size_t at = samples.c.size() / 2 + static_cast<std::size_t>(n) / 3;
        for (std::size_t k = 0; k < 200; ++k) {
            samples.c[at + k] += 0.3 * std::exp(-0.02 * static_cast<double>(k)) *
                                 std::cos(1.7 * static_cast<double>(k));
        }
        Settings settings;
        settings.window = n;
        settings.f0_hz = wave.f0_hz;
        const Result<Analysis> analysis = analyse(
            recording_of(std::move(samples.c), std::move(samples.d), wave.rate_hz), settings, {});
        QVERIFY(analysis);
        const std::size_t struck = at / static_cast<std::size_t>(n);
        QVERIFY(has(analysis->track.flags()[struck], Flag::moving));
    }

    void crossings_are_those_of_the_wave_data() {
        QTest::addColumn<double>("omega");
        QTest::addColumn<double>("split");
        QTest::addColumn<int>("n");
        QTest::addColumn<int>("hop");
        for (const double omega : {0.3, 2.0, 6.0}) {
            for (const double split : {0.0, 0.2, 5.0}) {
                for (const int n : {60, 600, 2000}) {
                    for (const int hop : {n, 4000, 10000, 16000, 25000}) {
                        QTest::addRow("omega %g, split %g Hz, n %d, hop %d", omega, split, n, hop)
                            << omega << split << n << hop;
                    }
                }
            }
        }
    }
    void crossings_are_those_of_the_wave() {
        QFETCH(double, omega);
        QFETCH(double, split);
        QFETCH(int, n);
        QFETCH(int, hop);
        const FreeDecay wave{.seconds = 20,
                             .split_hz = split,
                             .theta_w = 0.2,
                             .omega_rad_s = omega,
                             .noise = 1e-4,
                             .seed = static_cast<std::uint64_t>(hop)};
        Settings settings;
        settings.window = n;
        settings.hop = hop;
        const Result<Analysis> analysis = analyse(simulated_recording(wave), settings, {});
        QVERIFY(analysis);
        const Result<Track> truth = true_track(wave, 20);
        QVERIFY(truth);
        const std::vector<double> expected = true_crossings(*truth);
        int told = 0;
        for (const Event& event : find_events(analysis->track)) {
            if (event.flag) {
                continue;
            }
            ++told;
            const double nearest = std::ranges::min(
                expected, {}, [&event](double t) { return std::abs(t - event.time_s); });
            const double off = std::abs(nearest - event.time_s) * wave.rate_hz;
            VYBEG_AT_MOST(
                off, hop,
                qPrintable(
                    QString("a crossing at %1 s, off by %2 samples").arg(event.time_s).arg(off)));
        }
        // No more than there are, and all of them where windows follow the wave.
        const auto all = static_cast<int>(expected.size());
        VYBEG_AT_MOST(told, all);
        if (split == 0 && n == 60 && hop == n) {
            QCOMPARE(told, all);
        }
    }
};

VYBEG_TEST(TestMovingWaves, first)

}  // namespace test_moving_waves

#include "test_moving_waves.moc"
