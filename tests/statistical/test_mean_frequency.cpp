#include "core/analysis/analyse.h"
#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/estimators/wave/estimator.h"
#include "core/simulation/simulate.h"
#include "core/track/track_summary.h"
#include "tests/closeness.h"
#include "tests/statistical/simulated_recording.h"
#include "tests/statistical/track_errors.h"
#include "tests/test_registry.h"

#include <QtTest>

namespace test_mean_frequency {

using namespace vybeg;
using namespace vybeg::test;

namespace {

TrackSummary summary_of(const Analysis& analysis) {
    return summarise(
        analysis.track,
        static_cast<double>(analysis.plan.hop) / static_cast<double>(analysis.plan.length),
        analysis.f_correlation);
}

// Maximum likelihood at the known carrier, behind a band-pass of 400 Hz if `filter`.
Result<Analysis> analysed(const FreeDecay& wave, int n, int hop, bool filter) {
    Settings settings;
    settings.window = n;
    settings.hop = hop;
    settings.threads = 1;
    settings.f0_hz = wave.f0_hz;
    if (filter) {
        settings.filter = Band{5100, 5500};
    }
    return analyse(simulated_recording(wave), settings, {});
}

}  // namespace

class TestMeanFrequency : public QObject {
    Q_OBJECT

private slots:
    // The demonstration's frequency swings with its beat by less than 1e-3 Hz about 5300.0011.
    void the_demonstration_s_mean_is_right_for_every_algorithm_and_window() {
        FreeDecay decay = demo_decay();
        const Recording recording = simulated_recording(decay);
        const Result<Track> truth = true_track(decay, 60);
        QVERIFY(truth);
        double low = 1e9;
        double high = 0;
        for (const double f : truth->values(SlowVariable::f)) {
            low = std::min(low, f);
            high = std::max(high, f);
        }
        for (const Algorithm algorithm :
             {Algorithm::in_phase, Algorithm::phase_shift, Algorithm::moving_axes,
              Algorithm::demodulation, Algorithm::conjugate_gradient,
              Algorithm::maximum_likelihood}) {
            for (const int n : {6, 22, 60, 63, 600}) {
                Settings settings;
                settings.algorithm = algorithm;
                settings.window = n;
                const Result<Analysis> analysis = analyse(recording, settings, {});
                QVERIFY(analysis);
                const TrackSummary summary = summary_of(*analysis);
                const double off =
                    std::max({low - summary.mean_f_hz, summary.mean_f_hz - high, 0.0});
                const QString found = QString("%1, n %2: %3 +- %4 (leakage %5), true %6 to %7")
                                          .arg(algorithm_name(algorithm).data())
                                          .arg(n)
                                          .arg(summary.mean_f_hz, 0, 'f', 6)
                                          .arg(summary.sd_mean_f_hz)
                                          .arg(summary.leakage_f_hz)
                                          .arg(low, 0, 'f', 6)
                                          .arg(high, 0, 'f', 6);
                qInfo("%s", qPrintable(found));
                VYBEG_LESS(off, 4 * summary.sd_mean_f_hz, qPrintable(found));
                // Leakage is a share of the main lobe; without it the noise is what is left.
                const bool closed = algorithm != Algorithm::conjugate_gradient &&
                                    algorithm != Algorithm::maximum_likelihood;
                VYBEG_LESS(summary.sd_mean_f_hz, (closed ? 0.02 * decay.rate_hz / n : 0.02),
                           qPrintable(found));
            }
        }
    }

    void its_deviation_is_that_of_repeated_recordings_data() {
        QTest::addColumn<int>("n");
        QTest::addColumn<int>("hop");
        QTest::addColumn<bool>("filter");
        QTest::addColumn<double>("tau");
        QTest::newRow("short windows") << 6 << 6 << false << 1e300;
        QTest::newRow("the default") << 60 << 60 << false << 1e300;
        QTest::newRow("few windows") << 6000 << 6000 << false << 1e300;
        QTest::newRow("overlapping windows") << 60 << 15 << false << 1e300;
        QTest::newRow("windows apart") << 60 << 240 << false << 1e300;
        QTest::newRow("a decay of one time constant") << 60 << 60 << false << 2.0;
        QTest::newRow("behind a band-pass") << 60 << 60 << true << 1e300;
    }
    void its_deviation_is_that_of_repeated_recordings() {
        QFETCH(int, n);
        QFETCH(int, hop);
        QFETCH(bool, filter);
        QFETCH(double, tau);
        constexpr int runs = 150;  // a deviation over them is known to 6 %
        double squares = 0;
        for (int run = 1; run <= runs; ++run) {
            const FreeDecay wave{.seconds = 2,
                                 .a_B = run % 2 == 0 ? 0.2 : -0.2,
                                 .two_theta_A = 0.1 * run,
                                 .tau_s = tau,
                                 .noise = 1e-2,
                                 .seed = static_cast<std::uint64_t>(run + 1000 * n + 7 * hop)};
            const Result<Analysis> analysis = analysed(wave, n, hop, filter);
            QVERIFY(analysis);
            const TrackSummary summary = summary_of(*analysis);
            const double pull = (summary.mean_f_hz - wave.f0_hz) / summary.sd_mean_f_hz;
            squares += pull * pull;
        }
        const double rms = std::sqrt(squares / runs);
        qInfo("rms pull %g", rms);
        // Behind a band-pass the errors of windows shorter than the inverse of its width cancel
        // each other from window to window, which the deviation does not count on.
        VYBEG_MORE(rms, filter ? 0.02 : 0.75);
        VYBEG_LESS(rms, 1.25);
    }

    // The mean of a drifting frequency is its value at the mean's instant.
    void the_mean_of_a_drift_holds_at_its_instant_data() {
        QTest::addColumn<double>("drift");
        QTest::addColumn<double>("tau");
        QTest::addColumn<int>("n");
        QTest::addColumn<int>("hop");
        QTest::addColumn<bool>("filter");
        for (const bool filter : {false, true}) {
            for (const double drift : {0.0, 0.002, 0.02}) {
                for (const int n : {6, 60, 600}) {
                    for (const int hop : {n, n / 10}) {
                        if (hop > 0 && (n < 600 ? drift != 0.002 : true)) {
                            const double tau = n == 60 ? 400 : 5;
                            QTest::addRow("drift %g Hz/s, tau %g s, n %d, hop %d%s", drift, tau, n,
                                          hop, filter ? ", filter" : "")
                                << drift << tau << n << hop << filter;
                        }
                    }
                }
            }
        }
    }
    void the_mean_of_a_drift_holds_at_its_instant() {
        QFETCH(double, drift);
        QFETCH(double, tau);
        QFETCH(int, n);
        QFETCH(int, hop);
        QFETCH(bool, filter);
        constexpr int runs = 40;  // a deviation over them is known to 11 %
        double squares = 0;
        for (int run = 1; run <= runs; ++run) {
            const FreeDecay wave{.seconds = n == 600 ? 4.0 : 1.0,
                                 .a_B = 0.2,
                                 .two_theta_A = 0.1 * run,
                                 .tau_s = tau,
                                 .noise = 1e-3,
                                 .seed = static_cast<std::uint64_t>(run + 1000 * n + 7 * hop),
                                 .frequency_drift_hz_s = drift};
            const Result<Analysis> analysis = analysed(wave, n, hop, filter);
            QVERIFY(analysis);
            const TrackSummary& mean = analysis->means;
            QVERIFY(mean.mean_at_s > 0 && mean.mean_at_s < wave.seconds);
            const double pull =
                (mean.mean_f_hz - wave.f0_hz - drift * mean.mean_at_s) / mean.sd_mean_f_hz;
            squares += pull * pull;
        }
        const double rms = std::sqrt(squares / runs);
        qInfo("rms pull %g", rms);
        VYBEG_MORE(rms, 0.8 - 0.2);
        VYBEG_LESS(rms, 1.2 + 0.3);
    }

    // A carrier that is told 400 Hz off: windows of 60 samples search within 555 Hz of it, and many
    // end at that bound where the noise is large.
    void windows_at_the_bound_of_the_search_widen_it() {
        for (const double off : {-500.0, 400.0, 540.0}) {
            for (const double noise : {1e-3, 0.3, 1.0}) {
                const FreeDecay wave{.seconds = 2, .noise = noise};
                Settings settings;
                settings.f0_hz = wave.f0_hz + off;
                const Result<Analysis> analysis = analyse(simulated_recording(wave), settings, {});
                QVERIFY(analysis);
                const TrackSummary summary = summary_of(*analysis);
                const double pull = (summary.mean_f_hz - wave.f0_hz) / summary.sd_mean_f_hz;
                VYBEG_CLOSE(pull, 0, 4,
                            qPrintable(QString("%1 Hz off, noise %2: %3 +- %4, %5 "
                                               "windows at the bound")
                                           .arg(off)
                                           .arg(noise)
                                           .arg(summary.mean_f_hz)
                                           .arg(summary.sd_mean_f_hz)
                                           .arg(summary.at_bound)));
            }
        }
    }

    void noise_per_channel_is_the_same_for_every_window() {
        const FreeDecay wave{.seconds = 2, .a_B = 0.3, .noise = 1e-3};
        const Recording recording = simulated_recording(wave);
        for (const int n : {6, 7, 22, 60, 600}) {
            Settings settings;
            settings.window = n;
            const Result<Analysis> analysis = analyse(recording, settings, {});
            QVERIFY(analysis);
            const double noise = summary_of(*analysis).noise;
            // 130,000 samples in all, of which at n = 6 seven of twelve are left.
            VYBEG_CLOSE_RATIO(noise, wave.noise, 0.015, qPrintable(QString("n %1").arg(n)));
        }
    }
};

VYBEG_TEST(TestMeanFrequency)

}  // namespace test_mean_frequency

#include "test_mean_frequency.moc"
