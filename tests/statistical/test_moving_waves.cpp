#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/simulation/true_track.h"
#include "core/track/events.h"
#include "tests/closeness.h"
#include "tests/largest_of.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/statistical/track_errors.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>

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
        double worst = 0;
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            FreeDecay wave;
            wave.seconds = 8;
            wave.split_hz = split;
            wave.theta_w = axis;
            wave.two_theta_A = 0.3 * static_cast<double>(seed);
            wave.tau_s = 5;
            wave.omega_rad_s = seed == 1 ? 0 : 0.5;
            wave.noise = 1e-3;
            wave.seed = seed;
            Settings settings;
            settings.window = n;
            settings.hop = hop;
            const Result<Analysis> analysis = analyse(simulated_recording(wave), settings, {});
            QVERIFY(analysis);
            const Track& track = analysis->track;
            // Truth at every half window, the first centre being that of the first window.
            const Result<Track> truth = true_track(wave, n);
            QVERIFY(truth);
            for (std::size_t k = 0; k < track.rows(); ++k) {
                windows += 1;
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
            VYBEG_MORE(unflagged, 0.99 * windows, qPrintable(found));
        }
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
        FreeDecay wave;
        wave.seconds = 20;
        wave.omega_rad_s = omega;
        wave.split_hz = split;
        wave.theta_w = 0.2;
        wave.noise = 1e-4;
        wave.seed = static_cast<std::uint64_t>(hop);
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
            if (event.kind != EventKind::axis_crossing) {
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

VYBEG_TEST(TestMovingWaves)

}  // namespace test_moving_waves

#include "test_moving_waves.moc"
